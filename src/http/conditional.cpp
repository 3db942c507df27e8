#include "http/conditional.h"

#include <algorithm>
#include <charconv>

namespace regarment {
namespace {

// Digits alone; more than 64 bits is the largest number there is, which no file reaches.
std::optional<std::uint64_t> number(std::string_view text) {
  if (text.empty() || text.find_first_not_of("0123456789") != std::string_view::npos)
    return std::nullopt;
  std::uint64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() ? value : UINT64_MAX;
}

std::variant<WholeFile, ByteRange, NoSuchRange> one_range(std::string_view text,
                                                          std::uint64_t size) {
  const std::size_t dash = text.find('-');
  if (dash == std::string_view::npos) return WholeFile{};
  const std::string_view from = trimmed(text.substr(0, dash)), to = trimmed(text.substr(dash + 1));
  const std::optional<std::uint64_t> first = number(from), last = number(to);
  if (from.empty() && last) {
    if (*last == 0 || size == 0) return NoSuchRange{};
    return ByteRange{size - std::min(*last, size), size};
  }
  if (!first || (!to.empty() && !last) || (last && *last < *first)) return WholeFile{};
  if (*first >= size) return NoSuchRange{};
  return ByteRange{*first, last ? std::min(*last, size - 1) + 1 : size};
}

}  // namespace

std::variant<WholeFile, ByteRange, NoSuchRange> asked_range(const Request& request,
                                                            std::uint64_t size,
                                                            std::string_view etag) {
  constexpr std::string_view kUnit = "bytes=";
  const auto range = request.headers.find("Range");
  if (!range || request.method != "GET" || request.headers.count("Range") != 1) return WholeFile{};
  const auto condition = request.headers.find("If-Range");
  if (condition && *condition != etag) return WholeFile{};
  if (!range->starts_with(kUnit) || range->find(',') != std::string_view::npos) return WholeFile{};
  return one_range(range->substr(kUnit.size()), size);
}

bool has_etag(const Request& request, std::string_view etag) {
  const auto asked = request.headers.find("If-None-Match");
  if (!asked) return false;
  const std::vector<std::string_view> tags = list_members(*asked);
  return std::any_of(tags.begin(), tags.end(), [&](std::string_view tag) {
    if (tag.starts_with("W/")) tag.remove_prefix(2);
    return tag == "*" || tag == etag;
  });
}

}  // namespace regarment
