#include "segmentation/segment_by_cut.h"

#include <gtest/gtest.h>

#include <numbers>

#include "base/error.h"
#include "dressed.h"

namespace regarment {
namespace {

using test::Dressed;
using test::MadePart;
using test::MadeSkirt;

constexpr int kAround = 96, kRows = 40;

/// The made skirt itself as a draped garment, one particle per vertex.
struct MadeGarment {
  Pattern pattern;
  std::vector<Vec3> draped;

  explicit MadeGarment(const MadeSkirt& skirt, double raised = 0) {
    for (int i = 0; i <= kRows; ++i)
      for (int j = 0; j < kAround; ++j) {
        const double y = skirt.hem_y + (skirt.waist_y - skirt.hem_y) * i / kRows;
        const double phi = 2 * std::numbers::pi * j / kAround, r = skirt.radius(y);
        draped.emplace_back(r * std::sin(phi), y + raised, r * std::cos(phi));
      }
    pattern.flat.resize(draped.size());
    pattern.particle_count = static_cast<int>(draped.size());
    for (int v = 0; v < pattern.particle_count; ++v) pattern.particle.push_back(v);
    const auto at = [](int row, int column) {
      return static_cast<std::uint32_t>(row * kAround + column % kAround);
    };
    for (int i = 0; i < kRows; ++i)
      for (int j = 0; j < kAround; ++j) {
        pattern.triangles.push_back({at(i, j), at(i, j + 1), at(i + 1, j)});
        pattern.triangles.push_back({at(i, j + 1), at(i + 1, j + 1), at(i + 1, j)});
      }
    pattern.edges = {{"hem", "torso", {}, {}}, {"waist", "torso", {}, {}}};
    for (int j = 0; j < kAround; ++j) {
      pattern.edges[0].vertices.push_back(j);
      pattern.edges[1].vertices.push_back(kRows * kAround + j);
    }
  }
};

Labels cut(const Dressed& dressed, const MadeGarment& garment, const Scan& scan, Labels labels = {},
           int layer = 1, const CutOptions& options = {}) {
  segment_by_cut(scan, dressed.parts, GarmentRegion(dressed.edges, dressed.body), garment.pattern,
                 garment.draped, layer, options, labels);
  return labels;
}

/// Share of the vertices labelled or truly cloth that are both. Vertices within 2 mm of the made
/// edges are neither: a whole ring of them lies on the border itself.
double intersection_over_union(const Dressed& dressed, const Labels& labels,
                               const std::vector<bool>& cloth) {
  const MadeSkirt& skirt = *dressed.plan.skirt;
  double both = 0, either = 0;
  for (std::size_t v = 0; v < cloth.size(); ++v) {
    const double y = dressed.scan.mesh.positions[v].y();
    if (std::min(std::abs(y - skirt.hem_y), std::abs(y - skirt.waist_y)) < 0.002) continue;
    both += labels.label[v] == 1 && cloth[v];
    either += labels.label[v] == 1 || cloth[v];
  }
  return both / either;
}

TEST(SegmentByCut, FindsTheSkirtOfAMesh) {
  const Dressed dressed(test::in_skirt());
  const Labels labels = cut(dressed, MadeGarment(*dressed.plan.skirt), dressed.scan);
  std::vector<bool> cloth;
  for (MadePart p : dressed.person.part) cloth.push_back(p == MadePart::Skirt);
  EXPECT_GT(intersection_over_union(dressed, labels, cloth), 0.99);
}

TEST(SegmentByCut, FindsTheSkirtOfACloud) {
  const test::PersonPlan plan = test::in_skirt();
  const test::MadePerson person = test::make_person(plan);
  std::vector<std::uint32_t> from;
  const Dressed dressed(plan, test::cloud_of(person.mesh, 0.0037, 71, &from));
  std::vector<bool> cloth;
  for (std::uint32_t v : from) cloth.push_back(person.part[v] == MadePart::Skirt);
  const Labels labels = cut(dressed, MadeGarment(*plan.skirt), dressed.scan);
  EXPECT_GT(intersection_over_union(dressed, labels, cloth), 0.99);
}

TEST(SegmentByCut, FollowsTheCreaseWhereTheGarmentIsLaidWrong) {
  const Dressed dressed(test::in_skirt());
  const MadeGarment raised(*dressed.plan.skirt, 0.02);
  std::vector<bool> cloth;
  for (MadePart p : dressed.person.part) cloth.push_back(p == MadePart::Skirt);
  EXPECT_GT(intersection_over_union(dressed, cut(dressed, raised, dressed.scan), cloth), 0.99);
}

TEST(SegmentByCut, LeavesOuterGarmentsAndOutliersAlone) {
  Dressed dressed(test::in_skirt());
  const std::size_t n = dressed.scan.mesh.positions.size();
  Labels labels{std::vector<std::uint8_t>(n, 0), std::vector<float>(n, 0.75F)};
  dressed.scan.outlier.assign(n, 0);
  for (std::size_t v = 0; v < n; ++v) {
    const bool front = dressed.scan.mesh.positions[v].z() > 0.05;
    labels.label[v] = front ? 1 : 0;
    dressed.scan.outlier[v] = dressed.scan.mesh.positions[v].z() < -0.05;
  }
  const Labels found = cut(dressed, MadeGarment(*dressed.plan.skirt), dressed.scan, labels, 2);
  std::size_t taken = 0;
  for (std::size_t v = 0; v < n; ++v) {
    ASSERT_LE(found.probability[v], 0.75F);
    if (labels.label[v] == 1 || dressed.scan.outlier[v]) {
      ASSERT_EQ(found.label[v], labels.label[v]) << v;
    }
    taken += found.label[v] == 2;
  }
  EXPECT_GT(taken, 100U);
}

TEST(SegmentByCut, RefusesWhatDoesNotFit) {
  const Dressed dressed(test::in_skirt());
  const MadeGarment garment(*dressed.plan.skirt);
  for (const int layer : {-1, 0, 256})
    EXPECT_THROW(cut(dressed, garment, dressed.scan, {}, layer), InvalidInput);
  EXPECT_THROW(cut(dressed, garment, dressed.scan, {{0}, {1.0F}}), InvalidInput);
  MadeGarment torn = garment;
  torn.draped.pop_back();
  EXPECT_THROW(cut(dressed, torn, dressed.scan), InvalidInput);
  CutOptions wrong;
  wrong.smoothness = -1;
  EXPECT_THROW(cut(dressed, garment, dressed.scan, {}, 1, wrong), InvalidInput);
  wrong = {};
  wrong.edge_error["hem"] = std::nan("");
  EXPECT_THROW(cut(dressed, garment, dressed.scan, {}, 1, wrong), InvalidInput);
}

}  // namespace
}  // namespace regarment
