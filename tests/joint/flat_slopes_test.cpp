#include "joint/flat_slopes.h"

#include <gtest/gtest.h>

#include "garment/find_template.h"

namespace regarment {
namespace {

class EveryTemplate : public testing::TestWithParam<const char*> {};

// Against whole patterns made anew on both sides.
TEST_P(EveryTemplate, SlopesAreThoseOfTheRestLengths) {
  const GarmentTemplate garment = find_template(GetParam());
  const Dimensions at = garment.typical();
  Pattern pattern = make_pattern(garment, at, 0.06);
  const std::vector<Spring> links = springs(pattern);
  const FlatSlopes slopes = flat_slopes(garment, at, pattern);
  const std::vector<double> found = rest_length_slopes(slopes, pattern, links);
  constexpr double kStep = 1e-5;
  for (std::size_t k = 0; k < slopes.size(); ++k) {
    std::vector<Spring> above = links, below = links;
    Dimensions moved = at;
    moved[slopes.names[k]] += kStep;
    move_pattern(garment, moved, pattern);
    update_rest_lengths(pattern, above);
    moved[slopes.names[k]] -= 2 * kStep;
    move_pattern(garment, moved, pattern);
    update_rest_lengths(pattern, below);
    for (std::size_t s = 0; s < links.size(); ++s)
      ASSERT_NEAR(found[s * slopes.size() + k],
                  (above[s].rest_length - below[s].rest_length) / (2 * kStep), 1e-4)
          << slopes.names[k] << ", spring " << s;
  }
}

INSTANTIATE_TEST_SUITE_P(Templates, EveryTemplate, testing::Values("skirt", "tshirt"));

}  // namespace
}  // namespace regarment
