#include "jobs/job_files.h"

#include "jobs/job_inputs.h"

namespace regarment {

void SharedFiles::fetch(const Claim& claim, JobStore& store, const KeepGoing& /*go*/) {
  folders_.remove_leftovers(claim.job.id, -1);
  prepare_inputs(claim.job, folders_, store);
}

std::uint64_t SharedFiles::deliver(const Claim& claim, const KeepGoing& /*go*/) {
  return folders_.bytes(claim.job.id);
}

}  // namespace regarment
