// What is special about the store in an SQLite file.

#include "jobs/sqlite_database.h"

#include <signal.h>
#include <sys/resource.h>

#include <fstream>

#include "base/error.h"
#include "jobs/store_schema.h"
#include "store_places.h"

namespace regarment {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

TEST(SqliteStore, MigratesStepByStepAndOnlyOnce) {
  const TemporaryFolder folder;
  const char* steps[] = {"CREATE TABLE a (x); INSERT INTO a VALUES (1)",
                         "ALTER TABLE a ADD y DEFAULT 7", "UPDATE a SET x = x + 1"};
  SqliteDatabase database(folder.path() / "s");
  migrate(database, std::span(steps, 1));
  EXPECT_EQ(database.number("PRAGMA user_version"), 1);
  migrate(database, steps);
  migrate(database, steps);
  EXPECT_EQ(database.number("PRAGMA user_version"), 3);
  EXPECT_EQ(database.number("SELECT x * 10 + y FROM a"), 27);
}

TEST(SqliteStore, LeavesAFileAsItWasWhereAStepFails) {
  const TemporaryFolder folder;
  const char* steps[] = {"CREATE TABLE a (x)", "CREATE TABLE b (x); no SQL"};
  SqliteDatabase database(folder.path() / "s");
  EXPECT_THROW(migrate(database, steps), InvalidInput);
  EXPECT_EQ(database.number("PRAGMA user_version"), 0);
  EXPECT_EQ(database.number("SELECT count(*) FROM sqlite_master"), 0);
}

TEST(SqliteStore, RefusesANewerSchemaPolitely) {
  const SqlitePlace place;
  open_job_store(place.where());
  SqliteDatabase(place.where()).run("PRAGMA user_version = 99");
  EXPECT_NE(refusal(place.where()).find("schema 99"), std::string::npos);
  EXPECT_EQ(refusal(place.where()).find('\n'), std::string::npos);
  EXPECT_EQ(SqliteDatabase(place.where()).number("PRAGMA user_version"), 99);
}

TEST(SqliteStore, RefusesWhatIsNoStore) {
  const TemporaryFolder folder;
  std::ofstream(folder.path() / "text") << std::string(5000, 'x');
  EXPECT_NE(refusal(folder.path() / "text"), "");
  EXPECT_EQ(bytes_of(folder.path() / "text"), std::string(5000, 'x'));
  SqliteDatabase(folder.path() / "other").run("CREATE TABLE songs (title)");
  EXPECT_NE(refusal(folder.path() / "other").find("another program"), std::string::npos);
  EXPECT_NE(refusal(folder.path()), "");
  EXPECT_NE(refusal("/dev/null"), "");
  EXPECT_NE(refusal(""), "");
  EXPECT_NE(refusal("mysql://host/x").find("mysql"), std::string::npos);
}

TEST(SqliteStore, LeavesNothingOfARemovedJobInItsFiles) {
  const SqlitePlace place;
  const auto store = open_job_store(place.where());
  NewJob job;
  job.id = new_job_id(), job.name = "anna-secret-name.ply";
  store->create(job);
  const auto holds_name = [&] {
    return (bytes_of(place.where()) + bytes_of(place.where() + "-wal")).find(job.name) !=
           std::string::npos;
  };
  EXPECT_TRUE(holds_name());
  store->remove(job.id);
  EXPECT_FALSE(holds_name());
}

// A file that may not grow stands for a disk that is full; the limit is lifted again.
TEST(SqliteStore, SaysWhenTheDiskIsFullAndGoesOnWhenItIsNot) {
  const SqlitePlace place;
  const auto store = open_job_store(place.where());
  NewJob job;
  job.id = new_job_id();
  store->create(job);
  struct rlimit before {};
  ::getrlimit(RLIMIT_FSIZE, &before);
  const auto old = ::signal(SIGXFSZ, SIG_IGN);
  const struct rlimit full { fs::file_size(place.where() + "-wal"), before.rlim_max };
  ::setrlimit(RLIMIT_FSIZE, &full);
  bool typed = false;
  NewJob second;
  second.id = new_job_id(), second.options = std::string(200000, 'x');
  try {
    store->create(second);
  } catch (const TemporaryError&) {
    typed = true;
  }
  ::setrlimit(RLIMIT_FSIZE, &before);
  ::signal(SIGXFSZ, old);
  EXPECT_TRUE(typed);
  EXPECT_FALSE(store->find(second.id));
  EXPECT_TRUE(store->find(job.id));
  EXPECT_EQ(store->create(second).kind, Created::Kind::Made);
  EXPECT_EQ(open_job_store(place.where())->find(second.id)->options, second.options);
}

}  // namespace
}  // namespace regarment
