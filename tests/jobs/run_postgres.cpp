// A PostgreSQL server with an empty database for tests in other languages: prints its address, and
// ends when standard input does. Exit status 77 where none is installed.

#include <cstdio>

#include "postgres_server.h"

int main() {
  if (!regarment::PostgresServer::is_installed()) return 77;
  regarment::PostgresServer server;
  std::puts(server.make_database().c_str());
  std::fflush(stdout);
  while (std::getchar() != EOF) {
  }
}
