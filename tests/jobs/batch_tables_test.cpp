#include "jobs/batch_tables.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "jobs/job_store.h"
#include "report/csv_table.h"
#include "report/files.h"
#include "results.h"
#include "support/folders.h"

namespace regarment {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

class BatchTablesTest : public testing::Test {
 protected:
  // A finished fit of a skirt of this length, and of a true one where it is known.
  std::string finish(const std::string& name, double length_cm, std::optional<double> truth_cm,
                     JobKind kind = JobKind::Fit) {
    std::string id = queue(name, kind);
    const auto claim = store_->claim("w", 1min, 3);
    Result result = example_result();
    std::vector<ResultMeasurement>& all = result.garments[0].measurements;
    all.resize(1);
    ResultMeasurement& length = all.front();
    length.value_cm = length_cm, length.low_cm = length_cm - 1, length.high_cm = length_cm + 1;
    length.truth_cm = truth_cm;
    const fs::path folder = folders_.result(id, claim->token);
    fs::create_directory(folder);
    write_file(folder / "result.json", result_json(result));
    store_->succeed(id, claim->token, 1);
    return id;
  }
  std::string queue(const std::string& name, JobKind kind) {
    NewJob job;
    job.id = new_job_id(), job.kind = kind, job.name = name, job.batch = batch_;
    folders_.begin_upload(job.id);
    folders_.accept_upload(job.id);
    store_->create(job);
    return job.id;
  }
  BatchTables write() {
    job_ = *store_->find(queue("evaluation", JobKind::Evaluate));
    return write_batch_tables(job_, folders_, *store_);
  }
  static CsvTable read(const fs::path& file) {
    return CsvTable::parse(read_file(file, 1U << 20U), file.filename().string());
  }

  TemporaryFolder folder_;
  JobFolders folders_{folder_.path() / "data"};
  std::unique_ptr<JobStore> store_ = open_job_store(folders_.default_store().string());
  std::string batch_ = store_->create_batch("b", "").id;
  Job job_;
};

TEST_F(BatchTablesTest, HoldTheNewestResultOfEachNameAndItsTruth) {
  finish("a.ply", 50, 54.0);
  const std::string corrected = finish("a.ply", 53.25, 54.0, JobKind::Refit);
  finish("b.ply", 60, {});
  const BatchTables tables = write();
  const CsvTable results = read(tables.results), truth = read(tables.truth);
  ASSERT_EQ(results.size(), 2U);
  EXPECT_EQ(results.cell(0, "scan"), "b.ply");
  EXPECT_EQ(results.cell(1, "scan"), "a.ply");
  EXPECT_EQ(results.number(1, "value_cm"), 53.25);
  EXPECT_EQ(results.number(1, "high_cm"), 54.25);
  EXPECT_EQ(results.cell(1, "report"), "/v1/jobs/" + corrected + "/report");
  ASSERT_EQ(truth.size(), 1U);
  EXPECT_EQ(truth.cell(0, "scan"), "a.ply");
  EXPECT_EQ(truth.number(0, "value_cm"), 54.0);
}

TEST_F(BatchTablesTest, KeepNamesAsTheyAre) {
  const std::string name = "=cmd(), \"the\" @first";
  finish(name, 50, 54.0);
  const BatchTables tables = write();
  EXPECT_EQ(read(tables.results).cell(0, "scan"), name);
  EXPECT_EQ(read(tables.truth).cell(0, "scan"), name);
}

TEST_F(BatchTablesTest, TakeTheTableThatWasSent) {
  finish("a.ply", 50, {});
  const fs::path sent = folders_.job(queue("evaluation", JobKind::Evaluate)) / "truth.csv";
  write_file(sent, "scan,template,measurement,value_cm\na,skirt,length,52\n");
  Job job = *store_->find(sent.parent_path().filename().string());
  EXPECT_EQ(write_batch_tables(job, folders_, *store_).truth, sent);
}

TEST_F(BatchTablesTest, AreWrittenAnewByAnotherAttempt) {
  finish("a.ply", 50, 54.0);
  const BatchTables first = write();
  store_->claim("w", 1min, 3);  // the evaluation, so that the next claim is of the fit
  const std::string again = finish("a.ply", 51, 54.0);
  const BatchTables second = write_batch_tables(job_, folders_, *store_);
  EXPECT_EQ(second.results, first.results);
  EXPECT_EQ(read(second.results).cell(0, "report"), "/v1/jobs/" + again + "/report");
  EXPECT_EQ(batch_tables(job_, folders_).truth, second.truth);
}

TEST_F(BatchTablesTest, LeaveOutWhatIsDeletedAndOtherBatches) {
  const std::string gone = finish("a.ply", 50, 54.0);
  finish("b.ply", 60, 61.0);
  folders_.remove(gone);
  batch_ = store_->create_batch("another", "").id;
  finish("c.ply", 70, 71.0);
  batch_ = store_->find(gone)->batch;
  const CsvTable results = read(write().results);
  ASSERT_EQ(results.size(), 1U);
  EXPECT_EQ(results.cell(0, "scan"), "b.ply");
}

TEST_F(BatchTablesTest, AreRefusedWithoutResultOrTruth) {
  EXPECT_THROW(write(), UsageError);
  finish("a.ply", 50, {});
  EXPECT_THROW(write(), UsageError);
}

}  // namespace
}  // namespace regarment
