#include "segmentation/segment.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "dressed.h"

namespace regarment {
namespace {

using test::Dressed;
using test::MadePart;
using test::MadeSkirt;

/// Share of the vertices labelled or truly cloth that are both. Vertices within 2 mm of the made
/// edges are neither: a whole ring of them lies on the border itself.
double intersection_over_union(const Dressed& dressed, const std::vector<bool>& cloth) {
  const std::vector<std::uint8_t> label = dressed.labels().label;
  const MadeSkirt& skirt = *dressed.plan.skirt;
  double both = 0, either = 0;
  for (std::size_t v = 0; v < label.size(); ++v) {
    const double y = dressed.scan.mesh.positions[v].y();
    if (std::min(std::abs(y - skirt.hem_y), std::abs(y - skirt.waist_y)) < 0.002) continue;
    both += label[v] == 1 && cloth[v];
    either += label[v] == 1 || cloth[v];
  }
  return both / either;
}

struct Cut {
  const char* name;
  MadeSkirt skirt;
};

class Segment : public testing::TestWithParam<Cut> {};

TEST_P(Segment, LabelsTheVerticesOfTheSkirtOfAMesh) {
  const Dressed dressed(test::in_skirt(GetParam().skirt));
  std::vector<bool> cloth;
  for (MadePart p : dressed.person.part) cloth.push_back(p == MadePart::Skirt);
  ASSERT_EQ(dressed.labels().label.size(), cloth.size());
  EXPECT_GT(intersection_over_union(dressed, cloth), 0.97);
}

TEST_P(Segment, LabelsThePointsOfTheSkirtOfACloud) {
  const test::PersonPlan plan = test::in_skirt(GetParam().skirt);
  const test::MadePerson person = test::make_person(plan);
  std::vector<std::uint32_t> from;
  const Mesh cloud = test::cloud_of(person.mesh, 0.0037, 71, &from);
  std::vector<bool> cloth;
  for (std::uint32_t v : from) cloth.push_back(person.part[v] == MadePart::Skirt);
  EXPECT_GT(intersection_over_union(Dressed(plan, cloud), cloth), 0.97);
}

INSTANTIATE_TEST_SUITE_P(Skirts, Segment,
                         testing::Values(Cut{"knee", {}}, Cut{"narrow", {1.03, 0.129, 0.45, 0.21}},
                                         Cut{"wide", {1.02, 0.129, 0.40, 0.33}},
                                         Cut{"mini", {1.03, 0.129, 0.62, 0.235}}),
                         [](const auto& cut) { return std::string(cut.param.name); });

TEST(SegmentProbability, IsOneHalfAtTheBorderAndGrowsAwayFromIt) {
  const Dressed dressed(test::in_skirt());
  const Labels labels = dressed.labels();
  const GarmentRegion region(dressed.edges, dressed.body);
  std::vector<std::pair<double, float>> by_depth;
  for (std::size_t v = 0; v < labels.label.size(); ++v) {
    const double depth = region.depth(dressed.scan.mesh.positions[v], dressed.parts[v]);
    // As its manual says, at distance d from the border: 1 - exp(-d / 1 cm) / 2.
    ASSERT_NEAR(labels.probability[v], 1 - 0.5 * std::exp(-std::abs(depth) / 0.01), 1e-6) << v;
    ASSERT_EQ(labels.label[v], depth > 0 ? 1 : 0) << v;
    by_depth.emplace_back(std::abs(depth), labels.probability[v]);
  }
  std::sort(by_depth.begin(), by_depth.end());
  EXPECT_LT(by_depth.front().second,
            0.53);  // some vertex lies within half a millimetre of the border
  EXPECT_GT(by_depth.back().second, 0.999);
  for (std::size_t k = 1; k < by_depth.size(); ++k)
    ASSERT_GE(by_depth[k].second, by_depth[k - 1].second);
}

TEST(SegmentProbability, DepthIsTheDistanceAlongTheBodyFromTheMadeEdges) {
  const Dressed dressed(test::in_skirt());
  const GarmentRegion region(dressed.edges, dressed.body);
  const MadeSkirt& skirt = *dressed.plan.skirt;
  for (double y = skirt.hem_y - 0.05; y < skirt.waist_y + 0.05; y += 0.01) {
    const double radius = y < skirt.hem_y ? 0.1 : skirt.radius(std::min(y, skirt.waist_y));
    const double expected = std::min(y - skirt.hem_y, skirt.waist_y - y);
    // The edges found may be 5 mm beside the made ones.
    EXPECT_NEAR(region.depth({0, y, radius}, BodyPart::Trunk), expected, 0.006) << y;
  }
}

TEST(LabelRegion, LeavesOuterGarmentsAndOutliersAlone) {
  Dressed dressed(test::in_skirt());
  const Labels alone = dressed.labels();
  Labels labels = alone;
  // An outer garment that took every second vertex of the skirt, and outliers among the rest.
  dressed.scan.outlier.assign(alone.label.size(), 0);
  for (std::size_t v = 0; v < alone.label.size(); ++v) {
    labels.label[v] = v % 2 == 0 ? alone.label[v] : 0;
    dressed.scan.outlier[v] = v % 3 == 0;
  }
  label_region(dressed.scan, dressed.parts, GarmentRegion(dressed.edges, dressed.body), 2, labels);
  for (std::size_t v = 0; v < alone.label.size(); ++v) {
    const int expected = alone.label[v] == 0 ? 0 : v % 2 == 0 ? 1 : v % 3 == 0 ? 0 : 2;
    ASSERT_EQ(labels.label[v], expected) << v;
    ASSERT_LE(labels.probability[v], alone.probability[v]);
  }
}

TEST(VertexParts, FollowsTheSamplesAndLeavesTheRestLoose) {
  const test::MadePerson person = test::make_person({});
  Mesh mesh = person.mesh;
  mesh.positions.emplace_back(3, 1, 3);  // used by no triangle
  mesh.normals.push_back(Vec3::UnitX());
  const Scan scan = test::scan_of(mesh);
  const SurfaceSamples samples = sample_surface(mesh, 0.006);
  const Body body = find_body(samples, test::MadePerson::kHeight);
  const std::vector<BodyPart> parts = vertex_parts(scan, samples, body);
  ASSERT_EQ(parts.size(), mesh.positions.size());
  EXPECT_EQ(parts.back(), BodyPart::Loose);
  std::size_t hands = 0, loose = 0;
  for (std::size_t v = 0; v + 1 < parts.size(); ++v) {
    const Vec3& p = mesh.positions[v];
    // Of very small triangles some corner may have no sample of its own.
    loose += parts[v] == BodyPart::Loose;
    if (parts[v] == BodyPart::Loose) continue;
    if (std::abs(p.x()) > 0.35) {
      EXPECT_EQ(parts[v], p.x() > 0 ? BodyPart::LeftArm : BodyPart::RightArm);
      ++hands;
    }
    if (p.y() < 0.7) {
      EXPECT_EQ(parts[v], BodyPart::Trunk);
    }
  }
  EXPECT_GT(hands, 100U);
  EXPECT_LT(loose, parts.size() / 50);
  Body wrong = body;
  wrong.part.pop_back();
  EXPECT_THROW(vertex_parts(scan, samples, wrong), InvalidInput);
}

}  // namespace
}  // namespace regarment
