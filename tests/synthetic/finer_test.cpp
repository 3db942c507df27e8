#include "synthetic/finer.h"

#include <gtest/gtest.h>

#include "garment/find_template.h"

namespace regarment {
namespace {

// A map of the panels to space that is straight in every triangle is carried over exactly, but for
// the neckline's curve, which the coarser panel cuts short.
TEST(Finer, CarriesAnEvenlyPlacedGarmentOver) {
  const GarmentTemplate garment = find_template("tshirt");
  const Pattern coarse = make_pattern(garment, garment.typical(), 0.05);
  const Pattern fine = make_pattern(garment, garment.typical(), 0.02);
  const auto place = [](const Pattern& p, std::size_t v) {
    return Vec3(p.flat[v].x(), 2 - p.flat[v].y(), 0.3 * p.flat[v].x() + 0.1 * p.flat[v].y());
  };
  std::vector<Vec3> x(static_cast<std::size_t>(coarse.particle_count));
  for (std::size_t v = 0; v < coarse.flat.size(); ++v) x[coarse.particle[v]] = place(coarse, v);
  const std::vector<Vec3> y = onto_finer(coarse, x, fine);
  ASSERT_EQ(y.size(), static_cast<std::size_t>(fine.particle_count));
  for (std::size_t v = 0; v < fine.flat.size(); ++v)
    EXPECT_LT((y[fine.particle[v]] - place(fine, v)).norm(), 1e-9) << "vertex " << v;
}

}  // namespace
}  // namespace regarment
