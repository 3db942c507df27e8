// What is special about the store in a PostgreSQL database.

#include "base/error.h"
#include "cutting_proxy.h"
#include "jobs/postgres_database.h"
#include "jobs/store_schema.h"
#include "postgres_place.h"

namespace regarment {
namespace {

using namespace std::chrono_literals;

PostgresDatabase connect(const StorePlace& place) {
  return PostgresDatabase(PostgresAddress::parse(place.where()));
}

// Ends every connection to the databases of the server but the one that asks.
void cut_connections() {
  test_server().run("postgres",
                    "SELECT pg_terminate_backend(pid) FROM pg_stat_activity "
                    "WHERE pid <> pg_backend_pid() AND backend_type = 'client backend'");
}

TEST(PostgresStore, MigratesStepByStepAndOnlyOnce) {
  const PostgresPlace place;
  const char* steps[] = {"CREATE TABLE a (x INTEGER); INSERT INTO a VALUES (1)",
                         "ALTER TABLE a ADD y INTEGER DEFAULT 7", "UPDATE a SET x = x + 1"};
  PostgresDatabase database = connect(place);
  EXPECT_EQ(database.schema_version(), 0);
  migrate(database, std::span(steps, 1));
  EXPECT_EQ(database.schema_version(), 1);
  migrate(database, steps);
  migrate(database, steps);
  EXPECT_EQ(database.schema_version(), 3);
  EXPECT_EQ(database.number("SELECT x * 10 + y FROM a"), 27);
}

TEST(PostgresStore, LeavesADatabaseAsItWasWhereAStepFails) {
  const PostgresPlace place;
  const char* steps[] = {"CREATE TABLE a (x INTEGER)", "CREATE TABLE b (x INTEGER); no SQL"};
  PostgresDatabase database = connect(place);
  EXPECT_THROW(migrate(database, steps), InvalidInput);
  EXPECT_EQ(database.schema_version(), 0);
  EXPECT_EQ(database.number("SELECT count(*) FROM pg_namespace WHERE nspname = 'regarment'"), 0);
}

TEST(PostgresStore, RefusesANewerSchemaPolitely) {
  const PostgresPlace place;
  open_job_store(place.where());
  connect(place).run("UPDATE schema_version SET version = 99");
  EXPECT_NE(refusal(place.where()).find("schema 99"), std::string::npos);
  EXPECT_EQ(refusal(place.where()).find('\n'), std::string::npos);
  EXPECT_EQ(connect(place).schema_version(), 99);
}

TEST(PostgresStore, RefusesWhatIsNotForIt) {
  const PostgresPlace place;
  connect(place).run("CREATE SCHEMA regarment; CREATE TABLE regarment.songs (title TEXT)");
  EXPECT_NE(refusal(place.where()).find("another program"), std::string::npos);
  EXPECT_NE(refusal(test_server().address("nowhere")).find("does not exist"), std::string::npos);
  const std::string latin = test_server().make_database("ENCODING 'LATIN1' TEMPLATE template0");
  EXPECT_NE(refusal(latin).find("UTF8"), std::string::npos);
}

TEST(PostgresStore, LeavesTheTablesOfOthersAlone) {
  const PostgresPlace place;
  connect(place).run("CREATE TABLE public.jobs (song TEXT); INSERT INTO public.jobs VALUES ('a')");
  open_job_store(place.where());
  EXPECT_EQ(connect(place).number("SELECT count(*) FROM public.jobs WHERE song = 'a'"), 1);
}

TEST(PostgresStore, TakesTheTimeOfTheServer) {
  const PostgresPlace place;
  const auto store = open_job_store(place.where());
  PostgresDatabase asked = connect(place);
  const char* const time = "SELECT floor(extract(epoch FROM clock_timestamp()) * 1000)::bigint";
  const JobTime before{std::chrono::milliseconds(asked.number(time))};
  NewJob job;
  job.id = new_job_id();
  const JobTime created = store->create(job).job.created;
  const JobTime after{std::chrono::milliseconds(asked.number(time))};
  EXPECT_LE(before, created + 1ms);  // either is rounded
  EXPECT_LE(created, after + 1ms);
}

TEST(PostgresStore, DoesNotLetACutConnectionShow) {
  const PostgresPlace place;
  const auto store = open_job_store(place.where());
  NewJob job;
  job.id = new_job_id();
  store->create(job);
  cut_connections();
  EXPECT_TRUE(store->find(job.id));
  cut_connections();
  EXPECT_TRUE(store->claim("w", kLease, kAttempts));
  EXPECT_EQ(store->events(job.id, 0, 10).size(), 2U);
}

TEST(PostgresStore, LosesATransactionWithItsConnectionAltogether) {
  const PostgresPlace place;
  PostgresDatabase database = connect(place);
  migrate(database, job_store_migrations());
  {
    SqlTransaction transaction(database);
    database.run("INSERT INTO batches (id, name, owner, created) VALUES ('a', '', '', 0)");
    cut_connections();
    EXPECT_THROW(database.number("SELECT count(*) FROM batches"), TemporaryError);
    // Not on a new connection, outside the transaction that it belongs to.
    EXPECT_THROW(database.run("DELETE FROM batches"), TemporaryError);
  }
  EXPECT_EQ(database.number("SELECT count(*) FROM batches"), 0);
}

TEST(PostgresStore, GoesOnOnceAKilledServerIsBack) {
  const PostgresPlace place;
  const auto store = open_job_store(place.where());
  std::vector<std::string> ids(5);
  for (std::string& id : ids) {
    NewJob job;
    job.id = id = new_job_id();
    store->create(job);
  }
  const auto claim = store->claim("w", kLease, kAttempts);
  test_server().kill();
  EXPECT_THROW(store->find(ids[0]), TemporaryError);
  EXPECT_THROW(store->claim("w", kLease, kAttempts), TemporaryError);
  EXPECT_THROW(store->check_writable(), TemporaryError);
  EXPECT_THROW(open_job_store(place.where()), TemporaryError);
  test_server().start();
  EXPECT_TRUE(store->succeed(claim->job.id, claim->token, 1));
  EXPECT_EQ(store->claim("w", kLease, kAttempts)->job.id, ids[1]);
  for (const std::string& id : ids) EXPECT_TRUE(store->find(id));
}

// The job that a store made while the connection was cut at the commit: through the proxy, and seen
// past it.
struct CutJob {
  PostgresPlace place;
  TemporaryFolder folder;
  CuttingProxy proxy{test_server().socket_folder(), folder.path()};
  std::unique_ptr<JobStore> store = open_job_store(
      place.where().substr(0, place.where().find("host=")) + "host=" + folder.path().string());
  NewJob job;

  explicit CutJob(CuttingProxy::Cut cut) {
    job.id = new_job_id();
    proxy.cut(cut);
  }
  bool is_kept() const { return open_job_store(place.where())->find(job.id).has_value(); }
};

TEST(PostgresStore, KnowsOfACommitWhoseAnswerWasLostThatItWasKept) {
  CutJob cut(CuttingProxy::Cut::AfterCommit);
  EXPECT_EQ(cut.store->create(cut.job).kind, Created::Kind::Made);
  EXPECT_TRUE(cut.proxy.was_cut());
  EXPECT_TRUE(cut.is_kept());
}

TEST(PostgresStore, KnowsOfACommitThatNeverArrivedThatItWasNot) {
  CutJob cut(CuttingProxy::Cut::BeforeCommit);
  EXPECT_THROW(cut.store->create(cut.job), TemporaryError);
  EXPECT_TRUE(cut.proxy.was_cut());
  EXPECT_FALSE(cut.is_kept());
  EXPECT_EQ(cut.store->create(cut.job).kind, Created::Kind::Made);
}

TEST(PostgresStore, WaitsForNobodyForEver) {
  const PostgresPlace place;
  PostgresDatabase held = connect(place), other = connect(place);
  held.run("CREATE TABLE public.t (x INTEGER)");
  SqlTransaction transaction(held);
  held.run("LOCK TABLE public.t");
  other.run("SET lock_timeout = '20ms'");
  EXPECT_THROW(other.number("SELECT count(*) FROM public.t"), TemporaryError);
}

}  // namespace
}  // namespace regarment
