#include "report/content_policy.h"

#include <gtest/gtest.h>

namespace regarment {
namespace {

// The hash of the example in the Content Security Policy specification, and that of nothing.
TEST(ContentPolicy, LetsTheseTextsRunAndNothingElse) {
  EXPECT_EQ(content_policy("", "alert('Hello, world.');"),
            "default-src 'none'; img-src data:; "
            "style-src 'sha256-47DEQpj8HBSa+/TImW+5JCeuQeRkm5NMpJWZG3hSuFU='; "
            "script-src 'sha256-qznLcsROx4GACP2dm0UCKCzCG+HiZ1guq6ZZDob/Tng='; "
            "base-uri 'none'; form-action 'none'");
}

}  // namespace
}  // namespace regarment
