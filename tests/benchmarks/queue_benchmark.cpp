// How many jobs a second go through each store: made by one process, then claimed and ended by
// several, which do nothing in between. Every commit is durable.
//
//   queue_benchmark [JOBS [WORKERS]]

#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>

#include "jobs/job_store.h"
#include "postgres_server.h"

namespace regarment {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begin) {
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

[[noreturn]] void be_a_worker(const std::string& where) {
  {
    const auto store = open_job_store(where);
    while (const auto claim = store->claim("w", std::chrono::seconds(30), 3)) {
      store->succeed(claim->job.id, claim->token, 1);
    }
  }
  ::_exit(0);
}

void measure(const char* name, const std::string& where, int jobs, int workers) {
  const auto store = open_job_store(where);
  auto begin = Clock::now();
  for (int i = 0; i < jobs; ++i) {
    NewJob job;
    job.id = new_job_id();
    job.garments = {"skirt"};
    store->create(job);
  }
  const double made = seconds_since(begin);
  begin = Clock::now();
  std::vector<pid_t> all;
  for (int i = 0; i < workers; ++i) {
    all.push_back(::fork());
    if (all.back() == 0) be_a_worker(where);
  }
  for (const pid_t one : all) ::waitpid(one, nullptr, 0);
  const double ended = seconds_since(begin);
  const auto succeeded = store->facts().jobs[static_cast<std::size_t>(JobState::Succeeded)];
  std::printf("%-10s %d jobs, %d workers: %.0f made/s, %.0f claimed and ended/s (%d succeeded)\n",
              name, jobs, workers, jobs / made, jobs / ended, static_cast<int>(succeeded));
  std::fflush(stdout);
}

}  // namespace
}  // namespace regarment

int main(int argc, char** argv) {
  using namespace regarment;
  const int jobs = argc > 1 ? std::stoi(argv[1]) : 10000;
  const int workers = argc > 2 ? std::stoi(argv[2]) : 4;
  const TemporaryFolder folder;
  measure("sqlite", (folder.path() / "store.sqlite3").string(), jobs, workers);
  if (!PostgresServer::is_installed()) {
    std::puts("postgres   not measured: postgresql-15 is not installed");
    return 0;
  }
  PostgresServer server(true);
  measure("postgres", server.make_database(), jobs, workers);
}
