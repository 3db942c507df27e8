// Any bytes as the lines of a request, target first, fields "Name: value" after it: refused, or
// what request.h, headers.h and conditional.h promise.
#include <cstdint>
#include <cstdlib>

#include "http/conditional.h"
#include "http/problem.h"

namespace {

using namespace regarment;

void require(bool right) {
  if (!right) std::abort();
}

std::string_view take_line(std::string_view& text) {
  const std::size_t end = std::min(text.find('\n'), text.size());
  const std::string_view line = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  return line;
}

bool is_plain(const std::string& text) {
  for (const char c : text)
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) return false;
  return true;
}

// Every byte as a percent code.
std::string encoded(const std::string& text) {
  constexpr const char* kDigits = "0123456789abcdef";
  std::string out;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    out.append({'%', kDigits[byte / 16], kDigits[byte % 16]});
  }
  return out;
}

// What was read means the same when it is written another way.
void check_target(const Request& request) {
  std::string again;
  for (const std::string& segment : request.path) {
    require(!segment.empty() && is_plain(segment));
    require(segment.find_first_of("/\\") == std::string::npos);
    require(segment.find_first_not_of('.') != std::string::npos);
    again += "/" + encoded(segment);
  }
  if (again.empty()) again = "/";
  char mark = '?';
  for (const auto& [name, value] : request.query) {
    require(is_plain(name) && is_plain(value));
    again += mark + encoded(name) + "=" + encoded(value);
    mark = '&';
  }
  Request twice;
  read_target(again, twice);
  require(twice.path == request.path && twice.query == request.query);
}

void check_range(const Request& request, std::uint64_t size) {
  const auto asked = asked_range(request, size, "\"e\"");
  if (const auto* range = std::get_if<ByteRange>(&asked))
    require(range->first < range->second && range->second <= size);
  if (std::holds_alternative<NoSuchRange>(asked)) require(request.headers.count("Range") == 1);
  if (request.headers.count("Range") == 0) require(std::holds_alternative<WholeFile>(asked));
}

void check_fields(const Request& request) {
  for (const auto& [name, value] : request.headers.all()) {
    require(request.headers.find(name).has_value() && request.headers.count(name) > 0);
    std::size_t members = 0;
    for (const std::string_view member : list_members(value)) {
      require(!member.empty() && trimmed(member) == member);
      members += member.size();
    }
    require(members <= value.size());
    const auto parameter = header_parameter(value, "name");
    require(!parameter || parameter->size() < value.size());
  }
  // Without the field nothing is had; a star stands for whatever there is.
  const bool asked = request.headers.find("If-None-Match").has_value();
  require(asked || !has_etag(request, "\"e\""));
  if (request.headers.get("If-None-Match") == "*") require(has_etag(request, "\"e\""));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::string_view text(reinterpret_cast<const char*>(data), size);
  Request request;
  request.method = "GET";
  const std::string_view target = take_line(text);
  while (!text.empty()) {
    const std::string_view line = take_line(text);
    const std::size_t colon = std::min(line.find(':'), line.size());
    request.headers.add(std::string(line.substr(0, colon)),
                        std::string(trimmed(line.substr(std::min(colon + 1, line.size())))));
  }
  for (const std::uint64_t file :
       {std::uint64_t{0}, std::uint64_t{1}, std::uint64_t{1000}, UINT64_MAX})
    check_range(request, file);
  check_fields(request);
  try {
    read_target(target, request);
    check_target(request);
    check_header(request, true, false);
  } catch (const HttpProblem& problem) {
    require(problem.status >= 400 && problem.status < 600 && !problem.code.empty());
  }
  return 0;
}
