#pragma once

#include <string>

namespace regarment {

/// How often `part`, which is not empty, stands in the text.
inline std::size_t count(const std::string& text, const std::string& part) {
  std::size_t n = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
  return n;
}

/// What an action is refused with: the words of the error of this kind that it throws; nothing
/// when it throws none. Errors of other kinds pass through.
template <class Kind, class Action>
std::string refusal_of(const Action& action) {
  try {
    action();
  } catch (const Kind& error) {
    return error.what();
  }
  return {};
}

}  // namespace regarment
