#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "jobs/job_store.h"
#include "support/folders.h"

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

/// How a kind of store is made for a test.
using MakePlace = std::unique_ptr<StorePlace> (*)();

inline std::unique_ptr<StorePlace> sqlite_place() { return std::make_unique<SqlitePlace>(); }

/// What every JobStore is held to; instantiated once per kind of store.
class JobStoreTest : public testing::TestWithParam<MakePlace> {
 protected:
  std::unique_ptr<StorePlace> place_ = GetParam()();
  HandClock time_;
  std::unique_ptr<JobStore> store_ = open_job_store(place_->where(), time_.clock());

  std::string queue(const NewJob& like = {}) {
    NewJob job = like;
    job.id = new_job_id();
    return store_->create(job).job.id;
  }
  JobState state(const std::string& id) { return store_->find(id)->state; }
};

constexpr std::chrono::milliseconds kLease{30000};
constexpr int kAttempts = 3;

}  // namespace regarment
