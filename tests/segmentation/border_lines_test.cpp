#include "segmentation/border_lines.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "made_garment.h"

namespace regarment {
namespace {

using test::MadeGarment;
using test::MadePart;
using test::MadeSkirt;

/// A made person in a skirt with the true labels.
struct Labelled {
  Scan scan;
  std::vector<std::uint8_t> label;

  explicit Labelled(bool cloud) {
    test::PersonPlan plan;
    plan.skirt = MadeSkirt{};
    const test::MadePerson person = test::make_person(plan);
    const auto is_cloth = [&](std::uint32_t v) { return person.part[v] == MadePart::Skirt; };
    if (cloud) {
      std::vector<std::uint32_t> from;
      scan = test::scan_of(test::cloud_of(person.mesh, 0.004, 5, &from), 0.002);
      for (const std::uint32_t v : from) label.push_back(is_cloth(v) ? 1 : 0);
    } else {
      scan = test::scan_of(person.mesh);
      for (std::uint32_t v = 0; v < person.part.size(); ++v) label.push_back(is_cloth(v) ? 1 : 0);
    }
  }
};

class BorderLines : public testing::TestWithParam<bool> {};

TEST_P(BorderLines, LieOnTheMadeEdgesThoughTheGarmentIsLaidBesideThem) {
  const Labelled labelled(GetParam());
  const MadeSkirt skirt;
  const MadeGarment raised(skirt, 0.012);
  const std::vector<BorderLine> lines =
      border_lines(labelled.scan, labelled.label, 1, raised.pattern, raised.draped);
  ASSERT_EQ(lines.size(), 2U);
  for (const BorderLine& line : lines) {
    const bool hem = line.edge == "hem";
    EXPECT_GT(line.shown, 0.95) << line.edge;
    double length = 0, mean = 0;
    for (std::size_t i = 0; i < line.points.size(); ++i) {
      const Vec3 &p = line.points[i], &q = line.points[(i + 1) % line.points.size()];
      mean +=
          (p.y() - (hem ? skirt.hem_y : skirt.waist_y)) / static_cast<double>(line.points.size());
      length += (q - p).norm();
      EXPECT_LT((q - p).norm(), 0.012) << line.edge << " has a jump";
    }
    // A point halfway to the next skin may lie half a triangle or a spacing off the edge.
    EXPECT_NEAR(mean, 0, 0.003) << line.edge;
    const double circle = 2 * std::numbers::pi * (hem ? skirt.hem_radius : skirt.waist_radius);
    EXPECT_NEAR(length, circle, 0.02 * circle) << line.edge;
  }
}

TEST_P(BorderLines, BridgeAHole) {
  Labelled labelled(GetParam());
  const MadeSkirt skirt;
  // What a scanner did not see: a fifth of the way round, from top to bottom.
  const auto unseen = [](const Vec3& p) { return std::abs(std::atan2(p.x(), p.z())) < 0.6; };
  Mesh& mesh = labelled.scan.mesh;
  std::erase_if(mesh.triangles, [&](const Triangle& t) { return unseen(mesh.positions[t[0]]); });
  for (std::size_t v = 0; v < mesh.positions.size(); ++v)
    if (unseen(mesh.positions[v])) labelled.scan.outlier[v] = 1, labelled.label[v] = 0;
  const MadeGarment garment(skirt);
  const std::vector<BorderLine> lines =
      border_lines(labelled.scan, labelled.label, 1, garment.pattern, garment.draped);
  ASSERT_EQ(lines.size(), 2U);
  for (const BorderLine& line : lines) {
    EXPECT_LT(line.shown, 0.95) << line.edge;
    EXPECT_GT(line.shown, 0.8) << line.edge;
    for (std::size_t i = 0; i < line.points.size(); ++i)
      EXPECT_LT((line.points[i] - line.points[(i + 1) % line.points.size()]).norm(), 0.012);
  }
}

INSTANTIATE_TEST_SUITE_P(Scans, BorderLines, testing::Bool(), [](const auto& kind) {
  return std::string(kind.param ? "cloud" : "mesh");
});

TEST(BorderLinesOfNothing, AreNone) {
  Labelled labelled(false);
  const MadeGarment garment(MadeSkirt{});
  labelled.label.assign(labelled.label.size(), 0);
  EXPECT_TRUE(
      border_lines(labelled.scan, labelled.label, 1, garment.pattern, garment.draped).empty());
  labelled.label.pop_back();
  EXPECT_THROW(border_lines(labelled.scan, labelled.label, 1, garment.pattern, garment.draped),
               InvalidInput);
}

}  // namespace
}  // namespace regarment
