#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "jobs/job.h"

namespace regarment {

class JobStore;

/// What a key may do. Read: see jobs and results. Submit: make, change and remove its own jobs.
/// Review: give verdicts and corrections. Work: fetch the files of jobs that a worker has claimed,
/// and deliver their results. Admin: everything, of everybody's.
enum class Scope { Submit, Read, Review, Work, Admin };
inline constexpr std::array kScopes = {Scope::Submit, Scope::Read, Scope::Review, Scope::Work,
                                       Scope::Admin};
std::string_view name_of(Scope scope);
std::optional<Scope> scope_named(std::string_view name);

struct ApiKey {
  std::string id;             // 12 hexadecimal digits; public
  std::string name;           // for people
  std::vector<Scope> scopes;  // at least one
  JobTime created;
  std::optional<JobTime> revoked;

  /// Whether it has the scope; Admin has all.
  bool may(Scope scope) const;
};

struct StoredKey {
  ApiKey key;
  std::string hash;
};

/// SHA-256, hexadecimal. The secret has 256 random bits, so nothing slower is needed.
std::string key_hash(std::string_view secret);

/// Makes a key and stores it. Returns what its holder sends, "rgm_ID_SECRET", which nobody can
/// find out again. Throws UsageError for an empty or long name or no scope.
std::string issue_key(JobStore& store, const std::string& name, const std::vector<Scope>& scopes);

/// The key behind what a client sent, or nothing when it is unknown, revoked or malformed. Secrets
/// are compared in constant time.
std::optional<ApiKey> find_presented_key(JobStore& store, std::string_view presented);

}  // namespace regarment
