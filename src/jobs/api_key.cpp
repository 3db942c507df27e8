#include "jobs/api_key.h"

#include <algorithm>
#include <span>

#include "base/error.h"
#include "base/sha256.h"
#include "jobs/job_store.h"

namespace regarment {
namespace {

constexpr std::array<std::string_view, kScopes.size()> kScopeNames = {"submit", "read", "review",
                                                                      "work", "admin"};
constexpr std::string_view kPrefix = "rgm_";
constexpr std::size_t kIdBytes = 6, kSecretBytes = 32;
constexpr std::size_t kIdEnd = kPrefix.size() + 2 * kIdBytes;
constexpr std::size_t kLongestName = 100;

// As long for any difference as for none.
bool same_in_constant_time(std::string_view a, std::string_view b) {
  if (a.size() != b.size()) return false;
  unsigned difference = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    difference |= static_cast<unsigned char>(a[i]) ^ static_cast<unsigned char>(b[i]);
  }
  return difference == 0;
}

}  // namespace

std::string_view name_of(Scope scope) { return kScopeNames[static_cast<std::size_t>(scope)]; }

std::optional<Scope> scope_named(std::string_view name) {
  const auto* found = std::find(kScopeNames.begin(), kScopeNames.end(), name);
  if (found == kScopeNames.end()) return std::nullopt;
  return static_cast<Scope>(found - kScopeNames.begin());
}

bool ApiKey::may(Scope scope) const {
  return std::any_of(scopes.begin(), scopes.end(),
                     [&](Scope has) { return has == scope || has == Scope::Admin; });
}

std::string key_hash(std::string_view secret) {
  return sha256_hex(std::as_bytes(std::span(secret)));
}

std::string issue_key(JobStore& store, const std::string& name, const std::vector<Scope>& scopes) {
  if (name.empty() || name.size() > kLongestName) {
    throw UsageError("a key needs a name of 1 to 100 characters, so that people can tell it apart");
  }
  if (scopes.empty()) throw UsageError("a key needs a scope: submit, read, review, work or admin");
  const std::string id = random_hex(kIdBytes), secret = random_hex(kSecretBytes);
  store.add_key({id, name, scopes, {}, {}}, key_hash(secret));
  return std::string(kPrefix) + id + "_" + secret;
}

std::optional<ApiKey> find_presented_key(JobStore& store, std::string_view presented) {
  if (presented.size() != kIdEnd + 1 + 2 * kSecretBytes || !presented.starts_with(kPrefix) ||
      presented[kIdEnd] != '_') {
    return std::nullopt;
  }
  const auto stored = store.find_key(presented.substr(kPrefix.size(), 2 * kIdBytes));
  if (!stored || stored->key.revoked) return std::nullopt;
  if (!same_in_constant_time(key_hash(presented.substr(kIdEnd + 1)), stored->hash)) {
    return std::nullopt;
  }
  return stored->key;
}

}  // namespace regarment
