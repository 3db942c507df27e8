#pragma once

#include <initializer_list>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace regarment {

/// Parses a template's text, at most 256 KiB and 16 levels deep, no key twice in one object.
/// Throws ReadError("FILE: ...").
nlohmann::json parse_template_json(const std::string& text, const std::string& file);

/// A value of a template file that knows where it stands. Every getter throws
/// ReadError("FILE: /json/pointer: what is wrong"). Internal to this library.
class JsonNode {
 public:
  JsonNode(const nlohmann::json& value, std::string path, const std::string& file)
      : value_(&value), path_(std::move(path)), file_(&file) {}

  [[noreturn]] void fail(const std::string& what) const;

  /// An object with none but these keys; "note" is always allowed.
  void keys(std::initializer_list<const char*> allowed) const;
  bool has(const char* key) const;
  JsonNode at(const std::string& key) const;
  std::vector<JsonNode> items(std::size_t fewest, std::size_t most) const;
  std::vector<std::string> member_names(std::size_t most) const;

  std::string text(std::size_t most = 600) const;
  /// A name: a lower-case letter, then lower-case letters, digits and '_', at most 40 in all.
  std::string name() const;
  double number(double lowest, double highest) const;
  int integer(int lowest, int highest) const;
  bool boolean() const;
  bool is_number() const;

 private:
  const nlohmann::json* value_;
  std::string path_;
  const std::string* file_;
};

}  // namespace regarment
