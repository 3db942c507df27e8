// The tests of every store, and those of this one, against a PostgreSQL server of their own.

#include "postgres_place.h"

#include <cstdio>

namespace regarment {
namespace {

PostgresServer* server = nullptr;

}  // namespace

PostgresServer& test_server() { return *server; }

std::unique_ptr<StorePlace> new_store_place() { return std::make_unique<PostgresPlace>(); }

}  // namespace regarment

int main(int argc, char** argv) {
  constexpr int kSkipped = 77;
  testing::InitGoogleTest(&argc, argv);
  if (!regarment::PostgresServer::is_installed()) {
    std::puts("skipped: postgresql-15 is not installed");
    return kSkipped;
  }
  regarment::PostgresServer mine;
  regarment::server = &mine;
  return RUN_ALL_TESTS();
}
