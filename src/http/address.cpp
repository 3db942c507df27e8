#include "http/address.h"

#include <arpa/inet.h>

#include <algorithm>
#include <charconv>

#include "base/error.h"
#include "http/headers.h"

namespace regarment {
namespace {

constexpr std::size_t kLongestName = 253;
constexpr std::uint16_t kPlainPort = 80, kTlsPort = 443;

[[noreturn]] void refuse() {
  throw UsageError(
      "the address of a server is http://HOST:PORT or https://HOST:PORT, without path, user or "
      "password");
}

bool is_ipv6(const std::string& host) {
  in6_addr ignored{};
  return ::inet_pton(AF_INET6, host.c_str(), &ignored) == 1;
}

bool is_name(std::string_view host) {
  const auto fits = [](char c) {
    return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '-' ||
           c == '.' || c == '_';
  };
  return !host.empty() && host.size() <= kLongestName &&
         std::all_of(host.begin(), host.end(), fits);
}

std::uint16_t port_of(std::string_view text) {
  std::uint16_t port = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), port);
  if (error != std::errc() || end != text.data() + text.size() || port == 0) refuse();
  return port;
}

}  // namespace

HttpAddress HttpAddress::parse(const std::string& text) {
  HttpAddress out;
  std::string_view rest = text;
  out.tls = rest.starts_with("https://");
  if (!out.tls && !rest.starts_with("http://")) refuse();
  rest.remove_prefix(rest.find("//") + 2);
  if (rest.ends_with('/')) rest.remove_suffix(1);
  std::string_view port;
  if (rest.starts_with('[')) {
    const std::size_t end = rest.find(']');
    if (end == std::string_view::npos) refuse();
    out.host = rest.substr(1, end - 1);
    port = rest.substr(end + 1);
    if (!is_ipv6(out.host)) refuse();
  } else {
    const std::size_t colon = std::min(rest.find(':'), rest.size());
    out.host = rest.substr(0, colon);
    port = rest.substr(colon);
    if (!is_name(out.host)) refuse();
  }
  out.port = out.tls ? kTlsPort : kPlainPort;
  if (!port.empty() && port[0] != ':') refuse();
  if (!port.empty()) out.port = port_of(port.substr(1));
  return out;
}

std::string HttpAddress::text() const { return (tls ? "https://" : "http://") + authority(); }

std::string HttpAddress::authority() const {
  const bool ipv6 = host.find(':') != std::string::npos;
  return (ipv6 ? "[" + host + "]" : host) + ":" + std::to_string(port);
}

bool HttpAddress::is_loopback() const {
  in_addr v4{};
  if (::inet_pton(AF_INET, host.c_str(), &v4) == 1)
    return (ntohl(v4.s_addr) >> 24U) == IN_LOOPBACKNET;
  in6_addr v6{};
  if (::inet_pton(AF_INET6, host.c_str(), &v6) == 1) return IN6_IS_ADDR_LOOPBACK(&v6);
  return same_ignoring_case(host, "localhost");
}

}  // namespace regarment
