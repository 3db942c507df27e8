// Jobs under fire: an owner process submits them and keeps workers running, while workers, owner
// and the store's server are killed without warning. Every job must end once, none lost, none
// twice.
//
//   jobs_chaos PROGRAM|tiny JOBS WORKER_KILLS OWNER_KILLS [sqlite|postgres [STORE_KILLS]]
//
// The jobs are real and quick, pictures of a mesh of twelve triangles (`regarment render`), or,
// with "tiny", a shell script. The full measures, which print one line of figures each:
//
//   jobs_chaos build/release/regarment 200 50 5
//   jobs_chaos tiny 10000 100 2 sqlite
//   jobs_chaos tiny 10000 100 2 postgres 2
//
// The line of "tiny" ends with one hash of all results (tests/campaign compares them).

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
#include "jobs/worker.h"
#include "postgres_server.h"
#include "support/folders.h"
#include "tiny_work.h"

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

constexpr int kSkipped = 77;

struct Plan {
  fs::path self, program;
  bool tiny = false, postgres = false;
  int jobs = 0, worker_kills = 0, owner_kills = 0, store_kills = 0;
  std::string store = {};
};

// What a client does while the service answers 503.
template <typename Act>
auto patiently(const Act& act) {
  for (;;) {
    try {
      return act();
    } catch (const TemporaryError&) {
      std::this_thread::sleep_for(50ms);
    }
  }
}

// Submits what was not submitted before: a key stands for each job, as a client's would.
void submit(const JobFolders& folders, JobStore& store, const Plan& plan) {
  for (int i = 0; i < plan.jobs; ++i) {
    NewJob job;
    job.id = new_job_id();
    job.kind = plan.tiny ? JobKind::Fit : JobKind::Render;
    if (plan.tiny) job.garments = {"skirt"};
    job.name = tiny_name(i);
    job.idempotency_key = job.name;
    std::ofstream(folders.begin_upload(job.id) / "scan.ply")
        << (plan.tiny ? tiny_scan(i) : std::string(kScan));
    folders.accept_upload(job.id);
    const Created created = patiently([&] { return store.create(job); });
    if (created.job.id != job.id) folders.remove(job.id);
  }
}

// What `serve` is to its workers. Never comes back.
[[noreturn]] void own(const Plan& plan, const fs::path& data, pid_t parent) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != parent) ::_exit(1);
  const JobFolders folders(data);
  const auto store = patiently([&] { return open_job_store(plan.store); });
  const std::vector<std::string> worker_command =
      plan.tiny
          ? std::vector<std::string>{plan.self, "--worker", data, plan.program}
          : std::vector<std::string>{plan.program, "worker", "--data=" + data.string(), "--quiet"};
  std::vector<std::unique_ptr<ChildProcess>> workers(kWorkers);
  const auto keep = [&] {
    for (auto& worker : workers) {
      ChildEnd end;
      if (worker) worker->look_after();
      if (!worker || worker->ended(end)) {
        worker = std::make_unique<ChildProcess>(worker_command);
      }
    }
  };
  keep();
  submit(folders, *store, plan);
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
  int workers = 0, owners = 0, stores = 0;
};

// Kills, spread over the jobs, until all have ended.
Kills fire(const Plan& plan, const fs::path& data, JobStore& store, PostgresServer* server) {
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
    if (done.stores < plan.store_kills && done.stores < due(plan.store_kills)) {
      server->kill();
      server->start(), ++done.stores;
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

bool is_right(const Plan& plan, const fs::path& result, const Job& job) {
  return plan.tiny ? is_tiny_result(result, tiny_number(job.name)) : is_whole(result);
}

struct Count {
  std::map<std::string, fs::path> right;  // of the jobs that succeeded with the right result
  int ended = 0, succeeded = 0, twice = 0, broken = 0, attempts = 0;
};

Count count(const Plan& plan, const JobFolders& folders, JobStore& store) {
  Count out;
  JobFilter filter;
  filter.limit = 500;
  do {
    const JobPage page = store.list(filter);
    for (const Job& job : page.jobs) {
      const int successes = succeeded_events(store, job);
      out.ended += has_ended(job.state) ? 1 : 0;
      out.succeeded += job.state == JobState::Succeeded ? 1 : 0;
      out.twice += successes > 1 ? 1 : 0;
      if (job.state == JobState::Succeeded) {
        const fs::path result = folders.result(job);
        const bool right = is_right(plan, result, job);
        out.broken += right ? 0 : 1;
        if (right) out.right[job.name] = result;
      }
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

int run(Plan plan) {
  if (plan.postgres && !PostgresServer::is_installed()) {
    std::puts("skipped: postgresql-15 is not installed");
    return kSkipped;
  }
  const TemporaryFolder folder;
  std::unique_ptr<PostgresServer> server;
  if (plan.postgres) server = std::make_unique<PostgresServer>(true);
  // Short leases, and attempts without end: kills are no fault of the job.
  ::setenv("REGARMENT_LEASE_SECONDS", "2", 1);
  ::setenv("REGARMENT_MAX_ATTEMPTS", "100", 1);
  const JobFolders folders(folder.path() / "data");
  if (plan.tiny) plan.program = write_tiny_program(folder.path());
  plan.store = server ? server->make_database() : folders.default_store().string();
  ::setenv("REGARMENT_STORE", plan.store.c_str(), 1);
  const auto store = open_job_store(plan.store);
  const auto begin = std::chrono::steady_clock::now();
  const Kills kills = fire(plan, folders.data(), *store, server.get());
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
  const Count found = count(plan, folders, *store);
  const bool sound = plan.postgres || is_sound(folders.default_store());
  std::printf(
      "%s, %d jobs in %.0f s: %d ended, %d succeeded, %d lost, %d twice, %d broken; %d workers, %d "
      "owners and %d stores killed, %d attempts; store %s%s\n",
      plan.postgres ? "postgres" : "sqlite", plan.jobs, took.count(), found.ended, found.succeeded,
      plan.jobs - static_cast<int>(found.right.size()), found.twice, found.broken, kills.workers,
      kills.owners, kills.stores, found.attempts, sound ? "sound" : "damaged",
      plan.tiny ? ("; results " + tiny_digest(found.right)).c_str() : "");
  const bool good = sound && found.ended == plan.jobs && found.succeeded == plan.jobs &&
                    found.right.size() == static_cast<std::size_t>(plan.jobs) && found.twice == 0 &&
                    found.broken == 0 && kills.workers >= plan.worker_kills &&
                    kills.owners >= plan.owner_kills && kills.stores >= plan.store_kills;
  return good ? 0 : 1;
}

// A worker whose program is the tiny one; the store is named by the environment.
int be_a_worker(const fs::path& data, const fs::path& program) {
  const ServiceConfig config = read_service_config({}).config;
  WorkerOptions options = WorkerOptions::from(config);
  options.program = program;
  options.poll = 5ms;
  options.pause = 0ms;
  options.memory_mb = 0;
  const auto store = patiently([&] { return open_job_store(config.store_or_default()); });
  SharedFiles files{JobFolders(data)};
  run_worker(*store, files, options, [] { return true; });
  return 0;
}

Plan plan_of(const std::vector<std::string>& words) {
  Plan plan;
  plan.self = fs::read_symlink("/proc/self/exe");
  plan.tiny = words[0] == "tiny";
  if (!plan.tiny) plan.program = fs::absolute(words[0]);
  plan.jobs = std::stoi(words[1]);
  plan.worker_kills = std::stoi(words[2]);
  plan.owner_kills = std::stoi(words[3]);
  plan.postgres = words.size() > 4 && words[4] == "postgres";
  if (words.size() > 5) plan.store_kills = std::stoi(words[5]);
  return plan;
}

}  // namespace
}  // namespace regarment

int main(int argc, char** argv) {
  const std::vector<std::string> words(argv + 1, argv + argc);
  if (words.size() == 3 && words[0] == "--worker") {
    return regarment::be_a_worker(words[1], words[2]);
  }
  const bool postgres = words.size() > 4 && words[4] == "postgres";
  if (words.size() < 4 || words.size() > (postgres ? 6 : 5)) {
    std::fprintf(stderr,
                 "usage: jobs_chaos PROGRAM|tiny JOBS WORKER_KILLS OWNER_KILLS "
                 "[sqlite|postgres [STORE_KILLS]]\n");
    return 2;
  }
  return regarment::run(regarment::plan_of(words));
}
