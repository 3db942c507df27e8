#include "segmentation/caps.h"

#include <gtest/gtest.h>

#include "dressed.h"

namespace regarment {
namespace {

using test::Dressed;
using test::MadePart;
using test::MadeSkirt;

MadePart part_of(const Dressed& dressed, const Triangle& t) {
  for (std::uint32_t v : t)
    if (dressed.person.part[v] == MadePart::Cap) return MadePart::Cap;
  return dressed.person.part[t[0]];
}

TEST(FindCaps, FindsTheDiscThatClosesAHemAndNothingElse) {
  MadeSkirt skirt;
  skirt.capped = true;
  const Dressed dressed(test::in_skirt(skirt));
  const std::vector<std::uint8_t> caps = find_caps(dressed.scan, dressed.edges);
  const Mesh& mesh = dressed.scan.mesh;
  ASSERT_EQ(caps.size(), mesh.triangles.size());
  std::size_t inside = 0, missed = 0, wrong = 0;
  for (std::size_t f = 0; f < caps.size(); ++f) {
    const Triangle& t = mesh.triangles[f];
    if (part_of(dressed, t) != MadePart::Cap) {
      wrong += caps[f];
      continue;
    }
    double outermost = 0;
    for (std::uint32_t v : t)
      outermost = std::max(outermost, std::hypot(mesh.positions[v].x(), mesh.positions[v].z()));
    if (outermost > skirt.hem_radius - 0.015) continue;  // the last ring is cloth and cap at once
    ++inside;
    missed += caps[f] == 0;
  }
  EXPECT_GT(inside, 1000U);
  EXPECT_LT(static_cast<double>(missed), 0.01 * static_cast<double>(inside));
  EXPECT_EQ(wrong, 0U);
  EXPECT_EQ(count_caps(dressed.scan, caps), 1);
}

TEST(FindCaps, FindsNoneUnderAnOpenHem) {
  const Dressed dressed(test::in_skirt());
  const std::vector<std::uint8_t> caps = find_caps(dressed.scan, dressed.edges);
  EXPECT_EQ(std::count(caps.begin(), caps.end(), 1), 0);
  EXPECT_EQ(count_caps(dressed.scan, caps), 0);
}

TEST(FindCaps, OfACloudIsEmpty) {
  const test::PersonPlan plan = test::in_skirt();
  const Dressed dressed(plan, test::cloud_of(test::make_person(plan).mesh, 0.006, 72));
  EXPECT_TRUE(find_caps(dressed.scan, dressed.edges).empty());
}

TEST(CountCaps, CountsConnectedPiecesOfEnoughArea) {
  // Two squares of 4 cm^2 and 9 cm^2 apart, and one of 25 cm^2 that is no cap.
  Scan scan;
  std::vector<std::uint8_t> cap;
  for (const double side : {0.02, 0.03, 0.05}) {
    const auto first = static_cast<std::uint32_t>(scan.mesh.positions.size());
    for (const Vec2& p : {Vec2(0, 0), Vec2(side, 0), Vec2(side, side), Vec2(0, side)})
      scan.mesh.positions.emplace_back(p.x() + 10 * side, 0, p.y());
    scan.mesh.triangles.push_back({first, first + 1, first + 2});
    scan.mesh.triangles.push_back({first, first + 2, first + 3});
    cap.insert(cap.end(), 2, side < 0.04 ? 1 : 0);
  }
  EXPECT_EQ(count_caps(scan, cap, 3e-4), 2);
  EXPECT_EQ(count_caps(scan, cap, 5e-4), 1);
  EXPECT_EQ(count_caps(scan, cap, 1e-3), 0);
  EXPECT_EQ(count_caps(scan, {}), 0);
}

}  // namespace
}  // namespace regarment
