#include "service/access.h"

#include <algorithm>

#include "http/problem.h"

namespace regarment {
namespace {

constexpr std::string_view kCookie = "regarment_session";
constexpr std::chrono::hours kSessionTime{12};
constexpr std::size_t kMostSessions = 10'000;
constexpr std::size_t kSecretBytes = 32;

[[noreturn]] void ask_for_key() {
  throw HttpProblem(401, "no_key",
                    "this service needs a key; send 'Authorization: Bearer KEY' with one that "
                    "'regarment key add' made",
                    {{"WWW-Authenticate", "Bearer realm=\"regarment\""}});
}

bool changes_something(const Request& request) {
  return request.method != "GET" && request.method != "HEAD";
}

std::string cookie_of(const Request& request) {
  std::string_view cookies = request.headers.get("Cookie");
  while (!cookies.empty()) {
    const std::size_t end = std::min(cookies.find(';'), cookies.size());
    const std::string_view one = trimmed(cookies.substr(0, end));
    if (one.starts_with(kCookie) && one.substr(kCookie.size()).starts_with('='))
      return std::string(one.substr(kCookie.size() + 1));
    cookies.remove_prefix(std::min(end + 1, cookies.size()));
  }
  return {};
}

std::string set_cookie(const std::string& value, std::chrono::seconds time) {
  return std::string(kCookie) + "=" + value +
         "; Path=/; HttpOnly; SameSite=Strict; Max-Age=" + std::to_string(time.count());
}

Caller everybody() {
  Caller out;
  out.key.scopes = {Scope::Admin};
  return out;
}

}  // namespace

bool means_this_machine(std::string_view host) {
  std::string_view name = host;
  if (const std::size_t colon = host.rfind(':');
      colon != std::string_view::npos && host.find(']', colon) == std::string_view::npos &&
      host.find_first_not_of("0123456789", colon + 1) == std::string_view::npos)
    name = host.substr(0, colon);
  return same_ignoring_case(name, "localhost") || name == "127.0.0.1" || name == "[::1]";
}

bool is_own_page(const Request& request) {
  const auto site = request.headers.find("Sec-Fetch-Site");
  if (site && *site != "same-origin" && *site != "none") return false;
  const auto origin = request.headers.find("Origin");
  if (!origin) return true;
  const std::string host(request.headers.get("Host"));
  return *origin == "http://" + host || *origin == "https://" + host;
}

Access::Access(JobStore& store) : store_(store) {}

bool Access::needs_key() {
  constexpr std::chrono::seconds kFresh{1};
  const std::lock_guard lock(mutex_);
  const auto now = Clock::now();
  if (asked_ == Clock::time_point() || now - asked_ > kFresh) {
    const std::vector<ApiKey> keys = store_.keys();
    needs_key_ = std::any_of(keys.begin(), keys.end(), [](const ApiKey& k) { return !k.revoked; });
    asked_ = now;
  }
  return needs_key_;
}

Caller Access::admit(const Request& request) {
  const bool keyed = needs_key();
  if (!keyed && !means_this_machine(request.headers.get("Host")))
    throw HttpProblem(421, "foreign_host",
                      "this service answers to localhost and 127.0.0.1 only; use one of these, or "
                      "make a key with 'regarment key add'");
  if (changes_something(request) && !is_own_page(request))
    throw HttpProblem(403, "foreign_page",
                      "a page of another origin asked; use this service's own pages");
  if (!keyed) return everybody();
  std::optional<ApiKey> key = key_of(request);
  if (!key) ask_for_key();
  return {std::move(*key)};
}

std::optional<ApiKey> Access::key_of(const Request& request) {
  constexpr std::string_view kBearer = "Bearer ";
  const std::string_view authorization = request.headers.get("Authorization");
  if (same_ignoring_case(authorization.substr(0, kBearer.size()), kBearer))
    return find_presented_key(store_, trimmed(authorization.substr(kBearer.size())));
  if (const auto key = request.headers.find("X-API-Key")) return find_presented_key(store_, *key);
  return session_key(request);
}

std::optional<ApiKey> Access::session_key(const Request& request) {
  const std::string secret = cookie_of(request);
  if (secret.empty()) return std::nullopt;
  std::string id;
  {
    const std::lock_guard lock(mutex_);
    const auto found = sessions_.find(key_hash(secret));
    if (found == sessions_.end() || found->second.end < Clock::now()) return std::nullopt;
    id = found->second.key_id;
  }
  const std::optional<StoredKey> stored = store_.find_key(id);
  if (!stored || stored->key.revoked) return std::nullopt;
  return stored->key;
}

std::string Access::begin_session(const std::string& key) {
  const std::optional<ApiKey> found = find_presented_key(store_, key);
  if (!found) ask_for_key();
  const std::string secret = random_hex(kSecretBytes);
  const std::lock_guard lock(mutex_);
  const auto now = Clock::now();
  std::erase_if(sessions_, [&](const auto& one) { return one.second.end < now; });
  if (sessions_.size() >= kMostSessions)
    throw HttpProblem(503, "too_many_sessions", "too many sessions are open; ask again later",
                      {{"Retry-After", "600"}});
  sessions_[key_hash(secret)] = {found->id, now + kSessionTime};
  return set_cookie(secret, kSessionTime);
}

std::string Access::end_session(const Request& request) {
  const std::lock_guard lock(mutex_);
  sessions_.erase(key_hash(cookie_of(request)));
  return set_cookie("", std::chrono::seconds(0));
}

}  // namespace regarment
