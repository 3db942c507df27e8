#include "http/headers.h"

#include <algorithm>

namespace regarment {
namespace {

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + ('a' - 'A')) : c; }

bool is_token(std::string_view text) {
  const auto fits = [](char c) {
    const bool alphanumeric =
        (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z');
    return alphanumeric || std::string_view("!#$%&'*+-.^_`|~").find(c) != std::string_view::npos;
  };
  return !text.empty() && std::all_of(text.begin(), text.end(), fits);
}

// Takes a quoted text off the front of `rest`, which begins with its quote.
std::optional<std::string> take_quoted(std::string_view& rest) {
  std::string out;
  for (std::size_t i = 1; i < rest.size(); ++i) {
    if (rest[i] == '"') {
      rest.remove_prefix(i + 1);
      return out;
    }
    if (rest[i] == '\\' && ++i == rest.size()) break;
    out += rest[i];
  }
  return std::nullopt;
}

// Takes a value, quoted or a token, off the front.
std::optional<std::string> take_value(std::string_view& rest) {
  if (rest.starts_with('"')) return take_quoted(rest);
  const std::string_view token = trimmed(rest.substr(0, rest.find(';')));
  if (!is_token(token)) return std::nullopt;
  rest.remove_prefix(std::min(rest.find(';'), rest.size()));
  return std::string(token);
}

}  // namespace

void Headers::add(std::string name, std::string value) {
  fields_.emplace_back(std::move(name), std::move(value));
}

std::optional<std::string_view> Headers::find(std::string_view name) const {
  for (const auto& [key, value] : fields_)
    if (same_ignoring_case(key, name)) return value;
  return std::nullopt;
}

std::size_t Headers::count(std::string_view name) const {
  return static_cast<std::size_t>(
      std::count_if(fields_.begin(), fields_.end(),
                    [&](const auto& field) { return same_ignoring_case(field.first, name); }));
}

bool same_ignoring_case(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](char x, char y) { return lower(x) == lower(y); });
}

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

std::vector<std::string_view> list_members(std::string_view value) {
  std::vector<std::string_view> out;
  while (!value.empty()) {
    const std::size_t comma = std::min(value.find(','), value.size());
    const std::string_view member = trimmed(value.substr(0, comma));
    if (!member.empty()) out.push_back(member);
    value.remove_prefix(std::min(comma + 1, value.size()));
  }
  return out;
}

std::optional<std::string> header_parameter(std::string_view value, std::string_view name) {
  std::optional<std::string> found;
  const std::size_t first = value.find(';');
  std::string_view rest = first == std::string_view::npos ? "" : value.substr(first);
  while (!rest.empty()) {
    if (rest[0] != ';') return std::nullopt;
    rest = trimmed(rest.substr(1));
    const std::size_t equals = rest.find('=');
    if (equals == std::string_view::npos || !is_token(rest.substr(0, equals))) return std::nullopt;
    const bool wanted = same_ignoring_case(rest.substr(0, equals), name);
    rest.remove_prefix(equals + 1);
    std::optional<std::string> one = take_value(rest);
    if (!one || (wanted && found)) return std::nullopt;
    if (wanted) found = std::move(one);
    rest = trimmed(rest);
  }
  return found;
}

}  // namespace regarment
