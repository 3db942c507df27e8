#pragma once

#include <map>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace regarment {

/// What fills the named gaps of a page template: text, a yes or no, a list of such, by name.
/// Everything is escaped for HTML when it is filled in, but for gaps the template marks with three
/// braces.
struct Gaps {
  using Value = std::variant<std::string, bool, std::vector<Gaps>>;

  void set(const std::string& name, Value value) { values[name] = std::move(value); }
  /// A text and, beside it, `has_NAME`: whether it is not empty.
  void set_maybe(const std::string& name, const std::string& text) {
    set(name, text);
    set("has_" + name, !text.empty());
  }

  std::map<std::string, Value> values;
};

/// Fills a template (mustache, logic-less). Throws InvalidInput when the template is malformed.
std::string fill_template(const std::string& text, const Gaps& gaps);

}  // namespace regarment
