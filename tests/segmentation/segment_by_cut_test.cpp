#include "segmentation/segment_by_cut.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "dressed.h"
#include "made_garment.h"

namespace regarment {
namespace {

using test::Dressed;
using test::MadeGarment;
using test::MadePart;
using test::MadeSkirt;

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
  cloth.reserve(from.size());
  for (std::uint32_t v : from) cloth.push_back(person.part[v] == MadePart::Skirt);
  const Labels labels = cut(dressed, MadeGarment(*plan.skirt), dressed.scan);
  EXPECT_GT(intersection_over_union(dressed, labels, cloth), 0.99);
}

TEST(SegmentByCut, FollowsWhereTheClothEndsWhenTheGarmentIsLaidWrong) {
  const Dressed dressed(test::in_skirt());
  const MadeGarment raised(*dressed.plan.skirt, 0.02);
  std::vector<bool> cloth;
  for (MadePart p : dressed.person.part) cloth.push_back(p == MadePart::Skirt);
  EXPECT_GT(intersection_over_union(dressed, cut(dressed, raised, dressed.scan), cloth), 0.99);
}

TEST(SegmentByCut, IsLessSureAtTheBorderThanAwayFromIt) {
  const test::PersonPlan plan = test::in_skirt();
  const Dressed dressed(plan, test::cloud_of(test::make_person(plan).mesh, 0.006, 72));
  const MadeSkirt& skirt = *plan.skirt;
  const Labels labels = cut(dressed, MadeGarment(skirt), dressed.scan);
  double at_border = 0, n_border = 0, away = 0, n_away = 0;
  for (std::size_t v = 0; v < labels.label.size(); ++v) {
    ASSERT_GE(labels.probability[v], 0.5F);
    ASSERT_LE(labels.probability[v], 0.99F);
    const double off = std::abs(dressed.scan.mesh.positions[v].y() - skirt.waist_y);
    if (off < 0.004) at_border += static_cast<double>(labels.probability[v]), n_border += 1;
    if (off > 0.05) away += static_cast<double>(labels.probability[v]), n_away += 1;
  }
  EXPECT_LT(at_border / n_border, away / n_away - 0.03);
  EXPECT_GT(away / n_away, 0.95);
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
