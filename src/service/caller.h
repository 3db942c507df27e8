#pragma once

#include <string>

#include "jobs/api_key.h"

namespace regarment {

/// Who asks. Where no keys exist everybody on this machine may do everything.
struct Caller {
  ApiKey key;  // its id is empty where no keys exist

  bool may(Scope scope) const { return key.may(scope); }
  /// Readers, reviewers and administrators see every job, a submitter its own.
  bool may_see(const Job& job) const {
    return may(Scope::Read) || may(Scope::Review) || may_change(job);
  }
  bool may_change(const Job& job) const {
    return may(Scope::Admin) || (may(Scope::Submit) && key.id == job.owner);
  }
};

}  // namespace regarment
