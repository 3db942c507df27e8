#include "base/error.h"
#include "base/one_line.h"
#include "report/csv_table.h"
#include "report/files.h"
#include "report/ground_truth.h"
#include "service/submit.h"

namespace regarment {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kMostTable = 16'000'000;
constexpr std::size_t kLongestName = 255;
constexpr int kPage = 500;
constexpr const char* kTruth = "ground_truth";
constexpr const char* kBatch = "batch";

void check_names(const Upload& upload) {
  for (const std::string& name : upload.part_names())
    if (name != kTruth && name != "name" && name != kBatch)
      throw HttpProblem(400, "bad_part",
                        "'" + one_line(name, 60) +
                            "' is no part of a batch's evaluation; send ground_truth or name");
}

// Whether a finished fit of the batch was sent with its true sizes.
bool brings_truth(const Service& service, const std::string& batch) {
  JobFilter filter{.states = {JobState::Succeeded}, .batch = batch, .kind = JobKind::Fit};
  filter.limit = kPage;
  do {
    const JobPage page = service.store.list(filter);
    for (const Job& job : page.jobs) {
      std::error_code ignored;
      if (fs::is_regular_file(service.folders.job(job.id) / "truth.csv", ignored)) return true;
    }
    filter.after = page.next;
  } while (!filter.after.empty());
  return false;
}

// The table somebody sent, if one did; a body of nothing is none.
bool place_table(const Upload& upload) {
  if (!upload.has(kTruth)) return false;
  const fs::path file = upload.file(kTruth);
  const std::string text = read_file(file, kMostTable);
  if (text.empty()) {
    fs::remove(file);
    return false;
  }
  try {
    if (truth_rows(CsvTable::parse(text, kTruth)).empty())
      throw ReadError("ground_truth: no row has a value");
  } catch (const ReadError& error) {
    throw HttpProblem(422, "bad_ground_truth", error.what());
  }
  fs::rename(file, upload.folder() / "truth.csv");
  return true;
}

Response submit(const Service& service, const Call& call, const Batch& batch, Upload& upload) {
  check_names(upload);
  if (!place_table(upload) && !brings_truth(service, batch.id))
    throw HttpProblem(422, "no_truth",
                      "no finished scan of the batch came with its true sizes; send a table of "
                      "them as the part 'ground_truth'");
  NewJob job;
  job.kind = JobKind::Evaluate;
  job.batch = batch.id;
  job.owner = call.caller.key.id;
  const std::string name = upload.text("name");
  job.name = one_line(name.empty() ? "Evaluation of " + batch.name : name, kLongestName);
  return queue_job(service, std::move(job), upload, call.request);
}

}  // namespace

std::unique_ptr<Exchange> begin_batch_evaluation(const Service& service, const Call& call,
                                                 const Batch& batch) {
  check_room(service, call.caller.key.id);
  if (batch.jobs[static_cast<std::size_t>(JobState::Succeeded)] == 0)
    throw HttpProblem(409, "no_result", "no job of the batch has succeeded yet");
  auto upload = std::make_unique<Upload>(service.folders,
                                         std::map<std::string, std::uint64_t>{{kTruth, kMostTable}},
                                         !call.request.headers.get("Idempotency-Key").empty());
  // An Idempotency-Key stands for this batch alone.
  upload->add_text(kBatch, batch.id);
  return begin_upload(
      call, std::move(upload), kTruth, kMostTable,
      [&service, batch](const Call& now, Upload& got) { return submit(service, now, batch, got); });
}

}  // namespace regarment
