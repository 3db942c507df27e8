#include "store_places.h"

namespace regarment {

std::unique_ptr<StorePlace> new_store_place() { return std::make_unique<SqlitePlace>(); }

}  // namespace regarment
