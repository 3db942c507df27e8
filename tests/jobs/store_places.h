#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "base/error.h"
#include "jobs/job_store.h"
#include "support/folders.h"
#include "support/texts.h"

namespace regarment {

/// A clock that stands still until it is moved.
class HandClock {
 public:
  JobClock clock() const {
    return [this] { return now_; };
  }
  void pass(std::chrono::milliseconds time) { now_ += time; }
  JobTime now() const { return now_; }

 private:
  JobTime now_{std::chrono::hours(24 * 365 * 50)};
};

/// An empty store of some kind that may be opened any number of times, also by other processes.
class StorePlace {
 public:
  virtual ~StorePlace() = default;
  virtual std::string where() const = 0;
};

class SqlitePlace : public StorePlace {
 public:
  std::string where() const override { return (folder_.path() / "store.sqlite3").string(); }

 private:
  TemporaryFolder folder_;
};

/// A place of the kind that the test program is for: sqlite_place.cpp, postgres_place.cpp.
std::unique_ptr<StorePlace> new_store_place();

/// What every JobStore is held to; the same tests are built into a program for each kind of store.
class JobStoreTest : public testing::Test {
 protected:
  std::unique_ptr<StorePlace> place_ = new_store_place();
  HandClock time_;
  std::unique_ptr<JobStore> store_ = open_job_store(place_->where(), time_.clock());

  std::string queue(const NewJob& like = {}) {
    NewJob job = like;
    job.id = new_job_id();
    return store_->create(job).job.id;
  }
  JobState state(const std::string& id) { return store_->find(id)->state; }
};

/// Why a store is not opened there; nothing when it is.
inline std::string refusal(const std::string& where) {
  return refusal_of<UsageError>([&] { open_job_store(where); });
}

constexpr std::chrono::milliseconds kLease{30000};
constexpr int kAttempts = 3;

}  // namespace regarment
