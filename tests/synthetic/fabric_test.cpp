#include "synthetic/fabric.h"

#include <gtest/gtest.h>

#include <limits>
#include <string>

#include "base/error.h"

namespace regarment {
namespace {

TEST(SheetFabric, TheDefaultIsFine) { EXPECT_NO_THROW(SheetFabric{}.check()); }

TEST(SheetFabric, NamesTheFieldThatIsWrong) {
  SheetFabric fabric;
  fabric.bending = std::numeric_limits<double>::quiet_NaN();
  try {
    fabric.check();
    FAIL() << "a fabric that bends by no number was taken";
  } catch (const InvalidInput& e) {
    EXPECT_NE(std::string(e.what()).find("bending"), std::string::npos) << e.what();
  }
}

}  // namespace
}  // namespace regarment
