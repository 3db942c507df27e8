#pragma once

#include <cstdint>
#include <functional>
#include <utility>

#include "base/error.h"
#include "jobs/job_folder.h"
#include "jobs/job_store.h"

namespace regarment {

/// The claim under which something was asked for does not hold any more (exit status 1: it never
/// leaves an attempt).
struct ClaimLost : Error {
  ClaimLost() : Error(1, "the job belongs to another worker or is gone") {}
};

/// The server of the files does not let this worker in: its key, its version, its address. No job
/// is at fault (exit status 2).
struct NoAccess : UsageError {
  explicit NoAccess(const std::string& message) : UsageError(message) {}
};

/// Where a worker's jobs have their files from, and where their results go to. `go` is asked
/// several times a second while files are on their way; when it answers false this ends (Stopped).
/// What does not come through is tried again for a while; then TemporaryError. One thread.
class JobFiles {
 public:
  using KeepGoing = std::function<bool()>;
  virtual ~JobFiles() = default;

  /// Where the worker finds them, and leaves its results.
  virtual const JobFolders& folders() const = 0;
  /// Before a job is claimed. Throws TemporaryError while files cannot be had, NoAccess.
  virtual void check(const KeepGoing& go) = 0;
  /// Brings what the command of a job reads (job_inputs.h). Throws ClaimLost and NoAccess; what is
  /// wrong with the job itself as prepare_inputs and job_inputs do.
  virtual void fetch(const Claim& claim, JobStore& store, const KeepGoing& go) = 0;
  /// Takes the result of a claim to where clients find it, whole or not at all; the bytes that all
  /// files of the job take there. Throws ClaimLost and NoAccess.
  virtual std::uint64_t deliver(const Claim& claim, const KeepGoing& go) = 0;
  /// The attempt is over, in whatever way; for another one files are fetched again.
  virtual void forget(const Claim& claim) = 0;
};

/// Files in a folder that the worker shares with the server.
class SharedFiles : public JobFiles {
 public:
  explicit SharedFiles(JobFolders folders) : folders_(std::move(folders)) {}

  const JobFolders& folders() const override { return folders_; }
  void check(const KeepGoing& /*go*/) override {}
  void fetch(const Claim& claim, JobStore& store, const KeepGoing& go) override;
  std::uint64_t deliver(const Claim& claim, const KeepGoing& go) override;
  void forget(const Claim& /*claim*/) override {}

 private:
  JobFolders folders_;
};

}  // namespace regarment
