#include "http/request.h"

#include <array>
#include <cstdio>
#include <random>

#include "http/problem.h"

namespace regarment {
namespace {

[[noreturn]] void refuse(const std::string& what) {
  throw HttpProblem(400, "bad_target", "the address of the request " + what);
}

int hex_digit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  refuse("has a % that no two hexadecimal digits follow");
}

std::string decoded(std::string_view text, bool plus_is_space) {
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    char c = text[i];
    if (c == '+' && plus_is_space) {
      c = ' ';
    } else if (c == '%') {
      if (i + 2 >= text.size()) refuse("ends in the middle of a % code");
      c = static_cast<char>(hex_digit(text[i + 1]) * 16 + hex_digit(text[i + 2]));
      i += 2;
    }
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) refuse("holds a control character");
    out += c;
  }
  return out;
}

void read_path(std::string_view path, Request& request) {
  if (!path.starts_with('/')) refuse("does not begin with /");
  path.remove_prefix(1);
  while (!path.empty()) {
    const std::size_t slash = path.find('/');
    const std::string segment = decoded(path.substr(0, slash), false);
    if (segment.empty()) refuse("has two slashes in a row");
    if (segment.find_first_not_of('.') == std::string::npos) refuse("has a segment of dots");
    if (segment.find_first_of("/\\") != std::string::npos) refuse("has a slash inside a segment");
    request.path.push_back(segment);
    path.remove_prefix(slash == std::string_view::npos ? path.size() : slash + 1);
  }
}

void read_query(std::string_view query, Request& request) {
  while (!query.empty()) {
    const std::size_t end = query.find('&');
    const std::string_view one = query.substr(0, end);
    const std::size_t equals = one.find('=');
    const std::string name = decoded(one.substr(0, equals), true);
    const std::string value =
        equals == std::string_view::npos ? "" : decoded(one.substr(equals + 1), true);
    if (!one.empty() && !request.query.emplace(name, value).second)
      refuse("gives a query parameter twice");
    query.remove_prefix(end == std::string_view::npos ? query.size() : end + 1);
  }
}

}  // namespace

void read_target(std::string_view target, Request& request) {
  if (target.find('#') != std::string_view::npos) refuse("has a fragment");
  const std::size_t question = target.find('?');
  read_path(target.substr(0, question), request);
  if (question != std::string_view::npos) read_query(target.substr(question + 1), request);
}

void check_header(const Request& request, bool http_1_1, bool chunked) {
  const std::size_t hosts = request.headers.count("Host");
  if (hosts > 1 || (hosts == 0 && http_1_1))
    throw HttpProblem(400, "bad_host", "the request needs exactly one Host header");
  if (request.headers.find("Transfer-Encoding") && !chunked)
    throw HttpProblem(400, "bad_http", "the only transfer encoding understood is chunked");
  const auto expect = request.headers.find("Expect");
  if (expect && !same_ignoring_case(*expect, "100-continue"))
    throw HttpProblem(417, "bad_expect", "only 'Expect: 100-continue' is understood");
}

RequestIds::RequestIds() {
  std::array<char, 16> text{};
  std::snprintf(text.data(), text.size(), "%08x-", std::random_device()());
  prefix_ = text.data();
}

std::string RequestIds::next() { return prefix_ + std::to_string(++count_); }

}  // namespace regarment
