#pragma once

#include <chrono>
#include <map>
#include <mutex>
#include <optional>
#include <string>

#include "http/request.h"
#include "jobs/job_store.h"
#include "service/caller.h"

namespace regarment {

/// Who may ask, and from where. Any thread may call it.
///   - As soon as one key exists, every request needs one: "Authorization: Bearer KEY", "X-API-Key:
///     KEY", or the cookie of a session that a key began.
///   - Without keys only this machine is served, by names that mean it, so that no foreign page can
///     reach it through a name of its own (DNS rebinding).
///   - What changes something is refused to pages of another origin (Origin, Sec-Fetch-Site).
class Access {
 public:
  explicit Access(JobStore& store);

  /// Throws HttpProblem 401 "no_key", 403 "foreign_page" or 421 "foreign_host".
  Caller admit(const Request& request);

  /// Whether a key is needed now; looked up at most once a second.
  bool needs_key();

  /// Begins a session for pages: the value of a Set-Cookie header, HttpOnly and SameSite=Strict.
  /// Throws 401 unless `key` is one.
  std::string begin_session(const std::string& key);
  /// Ends the session of this request, if it has one; the value of a Set-Cookie header.
  std::string end_session(const Request& request);

 private:
  using Clock = std::chrono::steady_clock;
  struct Session {
    std::string key_id;
    Clock::time_point end;
  };

  std::optional<ApiKey> key_of(const Request& request);
  std::optional<ApiKey> session_key(const Request& request);

  JobStore& store_;
  std::mutex mutex_;
  bool needs_key_ = true;
  Clock::time_point asked_;                  // when needs_key_ was looked up
  std::map<std::string, Session> sessions_;  // by the hash of their secret
};

/// Whether a Host header means this machine: localhost, 127.0.0.1 or [::1], with any port.
bool means_this_machine(std::string_view host);

/// Whether a request that changes something may come from where it says it comes from: a program
/// (neither Origin nor Sec-Fetch-Site) or a page of this very host.
bool is_own_page(const Request& request);

}  // namespace regarment
