// How many jobs a second go through each store: made by one process, then claimed and ended by
// several, which do nothing in between but say NOTES times how far they are. Every commit is
// durable. The bytes are those of the database once all is done.
//
//   queue_benchmark [JOBS [WORKERS [NOTES]]]     prints a line of JSON per store

#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <nlohmann/json.hpp>

#include "jobs/job_store.h"
#include "jobs/postgres_database.h"
#include "postgres_server.h"

namespace regarment {
namespace {

using Clock = std::chrono::steady_clock;

struct Load {
  int jobs = 10000, workers = 4, notes = 0;
};

double seconds_since(Clock::time_point begin) {
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

[[noreturn]] void be_a_worker(const std::string& where, int notes) {
  {
    const auto store = open_job_store(where);
    while (const auto claim = store->claim("w", std::chrono::seconds(30), 3)) {
      for (int i = 0; i < notes; ++i) {
        store->progress(claim->job.id, claim->token, static_cast<double>(i) / notes, "fit", "");
      }
      store->succeed(claim->job.id, claim->token, 1);
    }
  }
  ::_exit(0);
}

void make_jobs(JobStore& store, int jobs) {
  for (int i = 0; i < jobs; ++i) {
    NewJob job;
    job.id = new_job_id();
    job.garments = {"skirt"};
    store.create(job);
  }
}

void end_jobs(const std::string& where, const Load& load) {
  std::vector<pid_t> all;
  for (int i = 0; i < load.workers; ++i) {
    all.push_back(::fork());
    if (all.back() == 0) be_a_worker(where, load.notes);
  }
  for (const pid_t one : all) ::waitpid(one, nullptr, 0);
}

nlohmann::ordered_json measure(const char* name, const std::string& where, const Load& load) {
  const auto store = open_job_store(where);
  auto begin = Clock::now();
  make_jobs(*store, load.jobs);
  const double made = seconds_since(begin);
  begin = Clock::now();
  end_jobs(where, load);
  const double ended = seconds_since(begin);
  const auto succeeded = store->facts().jobs[static_cast<std::size_t>(JobState::Succeeded)];
  return {{"store", name},
          {"jobs", load.jobs},
          {"workers", load.workers},
          {"notes", load.notes},
          {"succeeded", succeeded},
          {"made_per_s", load.jobs / made},
          {"ended_per_s", load.jobs / ended}};
}

void print(nlohmann::ordered_json figures, std::uint64_t bytes) {
  figures["database_bytes"] = bytes;
  std::printf("%s\n", figures.dump().c_str());
  std::fflush(stdout);
}

// What is still in the log goes into the file when the last connection closes.
void measure_sqlite(const Load& load) {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "store.sqlite3";
  const auto figures = measure("sqlite", file.string(), load);
  print(figures, std::filesystem::file_size(file));
}

void measure_postgres(const Load& load) {
  PostgresServer server(true);
  const std::string where = server.make_database();
  const auto figures = measure("postgres", where, load);
  PostgresDatabase database(PostgresAddress::parse(where));
  SqlStatement size(database, "SELECT pg_database_size(current_database())");
  size.step();
  print(figures, static_cast<std::uint64_t>(size.integer(0)));
}

}  // namespace
}  // namespace regarment

int main(int argc, char** argv) {
  using namespace regarment;
  Load load;
  if (argc > 1) load.jobs = std::stoi(argv[1]);
  if (argc > 2) load.workers = std::stoi(argv[2]);
  if (argc > 3) load.notes = std::stoi(argv[3]);
  measure_sqlite(load);
  if (PostgresServer::is_installed()) {
    measure_postgres(load);
  } else {
    std::fputs("postgres is not measured: postgresql-15 is not installed\n", stderr);
  }
}
