#pragma once

#include "postgres_server.h"
#include "store_places.h"

namespace regarment {

/// The server of this test program, started once.
PostgresServer& test_server();

/// An empty database of it.
class PostgresPlace : public StorePlace {
 public:
  std::string where() const override { return where_; }

 private:
  std::string where_ = test_server().make_database();
};

}  // namespace regarment
