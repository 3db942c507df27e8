// Jobs under fire: an owner process submits them and keeps workers running, while workers and owner
// are killed without warning. Every job must end once, none lost, none twice.
//
//   jobs_chaos PROGRAM JOBS WORKER_KILLS OWNER_KILLS
//
// The full measure is `jobs_chaos build/release/regarment 200 50 5`; it prints one line of figures.
// The jobs are real and quick: pictures of a mesh of twelve triangles (`regarment render`).

#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <charconv>
#include <cstdio>
#include <fstream>
#include <random>
#include <set>
#include <thread>

#include "base/child_process.h"
#include "base/error.h"
#include "jobs/job_folder.h"
#include "jobs/job_store.h"
#include "jobs/sqlite_database.h"
#include "support/folders.h"

namespace regarment {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

constexpr int kWorkers = 2;
constexpr auto kPatience = 20min;

// A box of the size of a person, its corners counted in binary.
constexpr const char* kScan = R"ply(ply
format ascii 1.0
element vertex 8
property float x
property float y
property float z
element face 12
property list uchar int vertex_indices
end_header
0 0 0
1 0 0
0 1 0
1 1 0
0 0 2
1 0 2
0 1 2
1 1 2
3 0 2 1
3 1 2 3
3 4 5 6
3 5 7 6
3 0 1 4
3 1 5 4
3 2 6 3
3 3 6 7
3 0 4 2
3 2 4 6
3 1 3 5
3 3 7 5
)ply";

struct Plan {
  fs::path program;
  int jobs = 0, worker_kills = 0, owner_kills = 0;
};

// Submits what was not submitted before: a key stands for each job, as a client's would.
void submit(const JobFolders& folders, JobStore& store, int jobs) {
  for (int i = 0; i < jobs; ++i) {
    NewJob job;
    job.id = new_job_id();
    job.kind = JobKind::Render;
    job.idempotency_key = "job-" + std::to_string(i);
    std::ofstream(folders.begin_upload(job.id) / "scan.ply") << kScan;
    folders.accept_upload(job.id);
    if (store.create(job).kind != Created::Kind::Made) folders.remove(job.id);
  }
}

// What `serve` is to its workers. Never comes back.
[[noreturn]] void own(const Plan& plan, const fs::path& data, pid_t parent) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != parent) ::_exit(1);
  const JobFolders folders(data);
  const auto store = open_job_store(folders.default_store().string());
  std::vector<std::unique_ptr<ChildProcess>> workers(kWorkers);
  const auto keep = [&] {
    for (auto& worker : workers) {
      ChildEnd end;
      if (worker) worker->look_after();
      if (!worker || worker->ended(end)) {
        worker = std::make_unique<ChildProcess>(std::vector<std::string>{
            plan.program.string(), "worker", "--data=" + data.string(), "--quiet"});
      }
    }
  };
  keep();
  submit(folders, *store, plan.jobs);
  for (;;) {
    std::vector<const ChildProcess*> all;
    all.reserve(workers.size());
    for (const auto& worker : workers) all.push_back(worker.get());
    wait_for_children(all, 20ms);
    keep();
  }
}

pid_t start_owner(const Plan& plan, const fs::path& data) {
  const pid_t parent = ::getpid();
  const pid_t owner = ::fork();
  if (owner == 0) own(plan, data, parent);
  return owner;
}

// The process in "host/4711-1a2b3c".
pid_t process_of(const std::string& worker) {
  const auto slash = worker.rfind('/');
  pid_t pid = 0;
  std::from_chars(worker.data() + slash + 1, worker.data() + worker.size(), pid);
  return pid;
}

// A worker that has a job just now; 0 when none does.
pid_t busy_worker(JobStore& store, std::mt19937& dice) {
  std::vector<pid_t> busy;
  for (const Job& job : store.list({.states = {JobState::Running}, .limit = 500}).jobs) {
    const pid_t pid = process_of(job.worker);
    if (pid > 0 && ::kill(pid, 0) == 0) busy.push_back(pid);
  }
  if (busy.empty()) return 0;
  return busy[std::uniform_int_distribution<std::size_t>(0, busy.size() - 1)(dice)];
}

std::uint64_t ended_jobs(JobStore& store) {
  const auto jobs = store.facts().jobs;
  std::uint64_t ended = 0;
  for (const JobState state : kJobStates) {
    if (has_ended(state)) ended += jobs[static_cast<std::size_t>(state)];
  }
  return ended;
}

struct Kills {
  int workers = 0, owners = 0;
};

// Kills, spread over the jobs, until all have ended.
Kills fire(const Plan& plan, const fs::path& data, JobStore& store) {
  std::mt19937 dice(1);
  Kills done;
  pid_t owner = start_owner(plan, data);
  const auto begin = std::chrono::steady_clock::now();
  for (;;) {
    const auto ended = static_cast<int>(ended_jobs(store));
    if (ended >= plan.jobs || std::chrono::steady_clock::now() > begin + kPatience) break;
    // So many kills are due by now; the last falls before the last jobs.
    const auto due = [&](int kills) { return 1 + ended * kills / std::max(1, plan.jobs * 4 / 5); };
    if (done.owners < plan.owner_kills && done.owners < due(plan.owner_kills)) {
      ::kill(owner, SIGKILL);
      ::waitpid(owner, nullptr, 0);
      owner = start_owner(plan, data), ++done.owners;
    }
    if (done.workers < plan.worker_kills && done.workers < due(plan.worker_kills)) {
      const pid_t pid = busy_worker(store, dice);
      if (pid > 0 && ::kill(pid, SIGKILL) == 0) ++done.workers;
    }
    // Any moment of a job may be hit.
    std::this_thread::sleep_for(
        std::chrono::milliseconds(std::uniform_int_distribution<int>(1, 60)(dice)));
  }
  ::kill(owner, SIGKILL);
  ::waitpid(owner, nullptr, 0);
  return done;
}

int succeeded_events(JobStore& store, const Job& job) {
  int found = 0;
  for (const JobEvent& event : store.events(job.id, 0, 1'000'000)) {
    if (event.data.find(R"("state":"succeeded")") != std::string::npos) ++found;
  }
  return found;
}

// Four pictures, each a whole PNG: it ends with the mark that stands at the end of one.
bool is_whole(const fs::path& result) {
  int pictures = 0;
  std::error_code none;
  for (const auto& entry : fs::directory_iterator(result, none)) {
    std::ifstream file(entry.path(), std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(file), {}};
    if (bytes.size() < 12 || bytes.substr(bytes.size() - 8, 4) != "IEND") return false;
    ++pictures;
  }
  return pictures == 4;
}

struct Count {
  int ended = 0, succeeded = 0, twice = 0, broken = 0, attempts = 0;
};

Count count(const JobFolders& folders, JobStore& store) {
  Count out;
  JobFilter filter;
  do {
    const JobPage page = store.list(filter);
    for (const Job& job : page.jobs) {
      const int successes = succeeded_events(store, job);
      out.ended += has_ended(job.state) ? 1 : 0;
      out.succeeded += job.state == JobState::Succeeded ? 1 : 0;
      out.twice += successes > 1 ? 1 : 0;
      out.broken += job.state == JobState::Succeeded && !is_whole(folders.result(job)) ? 1 : 0;
      out.attempts += static_cast<int>(job.token);
    }
    filter.after = page.next;
  } while (!filter.after.empty());
  return out;
}

bool is_sound(const fs::path& file) {
  SqliteDatabase database(file);
  SqlStatement check(database, "PRAGMA integrity_check");
  return check.step() && check.text(0) == "ok";
}

int run(const Plan& plan) {
  const TemporaryFolder folder;
  // Short leases, and attempts without end: kills are no fault of the job.
  ::setenv("REGARMENT_LEASE_SECONDS", "2", 1);
  ::setenv("REGARMENT_MAX_ATTEMPTS", "100", 1);
  const JobFolders folders(folder.path() / "data");
  const auto store = open_job_store(folders.default_store().string());
  const Kills kills = fire(plan, folders.data(), *store);
  const Count found = count(folders, *store);
  const bool sound = is_sound(folders.default_store());
  std::printf(
      "%d jobs: %d ended, %d succeeded, %d lost, %d twice, %d broken; %d workers and %d owners "
      "killed, %d attempts; store %s\n",
      plan.jobs, found.ended, found.succeeded, plan.jobs - found.ended, found.twice, found.broken,
      kills.workers, kills.owners, found.attempts, sound ? "sound" : "damaged");
  const bool good = sound && found.ended == plan.jobs && found.succeeded == plan.jobs &&
                    found.twice == 0 && found.broken == 0 && kills.workers >= plan.worker_kills &&
                    kills.owners >= plan.owner_kills;
  return good ? 0 : 1;
}

}  // namespace
}  // namespace regarment

int main(int argc, char** argv) {
  if (argc != 5) {
    std::fprintf(stderr, "usage: jobs_chaos PROGRAM JOBS WORKER_KILLS OWNER_KILLS\n");
    return 2;
  }
  return regarment::run({std::filesystem::absolute(argv[1]), std::atoi(argv[2]), std::atoi(argv[3]),
                         std::atoi(argv[4])});
}
