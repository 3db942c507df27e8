#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace regarment {

/// Header fields in their order. Names compare without regard to ASCII case.
class Headers {
 public:
  Headers() = default;
  Headers(std::initializer_list<std::pair<std::string, std::string>> fields) : fields_(fields) {}

  void add(std::string name, std::string value);
  /// The first value, or nothing.
  std::optional<std::string_view> find(std::string_view name) const;
  /// The first value, or empty text.
  std::string_view get(std::string_view name) const { return find(name).value_or(""); }
  std::size_t count(std::string_view name) const;
  const std::vector<std::pair<std::string, std::string>>& all() const { return fields_; }

 private:
  std::vector<std::pair<std::string, std::string>> fields_;
};

/// Whether two texts are the same but for ASCII case.
bool same_ignoring_case(std::string_view a, std::string_view b);

/// Text without spaces and tabs at both ends.
std::string_view trimmed(std::string_view text);

/// The members of a comma-separated header value, trimmed; empty ones are left out.
std::vector<std::string_view> list_members(std::string_view value);

/// A parameter of a header value, in lower case or not: `header_parameter("form-data; name=\"a\"",
/// "name")` is "a". Quotes and their backslashes are taken off. Nothing when it is not there, there
/// twice, or the value is not of the form `word; name=token; name="text"`.
std::optional<std::string> header_parameter(std::string_view value, std::string_view name);

}  // namespace regarment
