#include "synthetic/dress.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/error.h"
#include "garment/find_template.h"
#include "synthetic/body_girths.h"
#include "synthetic/body_shape.h"
#include "synthetic/penetration.h"
#include "synthetic/put_on.h"

namespace regarment {
namespace {

Mesh body_with_arms(double angle, double back) {
  BodyShape shape;
  shape.arm_angle = {angle, angle};
  shape.arms_back = back;
  return make_body(shape);
}

std::vector<Mesh> lowering_the_arms() {
  return {body_with_arms(1.08, 0.4), body_with_arms(0.9, 0.2), body_with_arms(0.6, 0.0)};
}

// Coarse, so that it takes a second.
DressOptions coarse() {
  DressOptions options;
  options.edge_length = 0.03;
  return options;
}

double worn_length(const WornGarment& garment, const std::string& edge) {
  const PatternEdge& loop = edge_named(garment.pattern, edge);
  double sum = 0;
  for (std::size_t i = 0; i < loop.vertices.size(); ++i) {
    const int a = loop.vertices[i], b = loop.vertices[(i + 1) % loop.vertices.size()];
    sum += (garment.particles[garment.pattern.particle[a]] -
            garment.particles[garment.pattern.particle[b]])
               .norm();
  }
  return sum;
}

Dimensions shirt() {
  return {{"length", 0.62},
          {"width", 1.02},
          {"sleeve_length", 0.18},
          {"sleeve_opening", 0.36},
          {"sleeve_seam", 0.46}};
}

TEST(PutOn, HoldsAShirtClearOfTheBody) {
  const Mesh body = body_with_arms(1.08, 0.4);
  const Pattern pattern = make_pattern(find_template("tshirt"), shirt(), 0.03);
  const std::vector<Vec3> x = put_on(pattern, {&body}, 0.0, 0.012);
  std::vector<Triangle> corners;  // the particles alone: a side may cut a corner of the body
  for (std::uint32_t p = 0; p < x.size(); ++p) corners.push_back({p, p, p});
  EXPECT_EQ(deepest_inside(body, corners, x), 0.0);
}

TEST(DressPerson, ASkirtHangsFromTheWaistAndKeepsItsHem) {
  const std::vector<Mesh> poses = lowering_the_arms();
  const BodyGirths girths = body_girths(poses.back());
  GarmentWish skirt;
  skirt.template_name = "skirt";
  skirt.dimensions = {
      {"length", 0.5}, {"waist", 0.99 * girths.waist}, {"hip", 1.08 * girths.hip}, {"width", 1.3}};
  skirt.band = 0.03;
  skirt.top_height = girths.waist_height;
  const Dressing out = dress_person(poses, {skirt}, coarse());
  ASSERT_EQ(out.person.garments.size(), 1U);
  EXPECT_EQ(out.reports[0].deepest, 0.0);
  EXPECT_LT(out.reports[0].fastest, 0.05);
  const WornGarment& worn = out.person.garments[0];
  EXPECT_NEAR(worn_length(worn, "hem"), 1.3, 0.013);  // nothing holds a loose hem
  EXPECT_GE(worn_length(worn, "waist"), girths.waist);
  const PatternEdge& waist = edge_named(worn.pattern, "waist");
  EXPECT_NEAR(worn.particles[worn.pattern.particle[waist.vertices[0]]].y(), skirt.top_height, 0.03);
}

TEST(DressPerson, ATuckedShirtLiesUnderTheSkirt) {
  const std::vector<Mesh> poses = lowering_the_arms();
  const BodyGirths girths = body_girths(poses.back());
  GarmentWish skirt, top;
  skirt.template_name = "skirt";
  skirt.dimensions = {
      {"length", 0.5}, {"waist", 1.1 * girths.waist}, {"hip", 1.12 * girths.hip}, {"width", 1.3}};
  skirt.top_height = girths.waist_height;
  top.template_name = "tshirt";
  top.dimensions = shirt();
  const Dressing out = dress_person(poses, {skirt, top}, coarse());
  ASSERT_EQ(out.person.garments.size(), 2U);
  EXPECT_EQ(out.person.garments[0].template_name, "skirt");
  // Two fingers below the skirt's top edge the shirt is nearer to the body's middle all round.
  const double level = skirt.top_height - 0.04;
  const auto girth_at = [&](const WornGarment& garment) {
    double sum = 0, n = 0;
    for (const Vec3& p : garment.particles)
      if (std::abs(p.y() - level) < 0.02 && std::abs(p.x()) < 0.25)
        sum += Vec2(p.x(), p.z()).norm(), n += 1;
    return sum / n;
  };
  EXPECT_LT(girth_at(out.person.garments[1]), girth_at(out.person.garments[0]));
}

TEST(DressPerson, WhoWearsNothingIsAsTheyWere) {
  const std::vector<Mesh> poses = lowering_the_arms();
  const Dressing out = dress_person(poses, {});
  EXPECT_TRUE(out.person.garments.empty());
  EXPECT_EQ(out.person.body.positions, poses.back().positions);
}

TEST(DressPerson, RefusesPosesOfDifferentBodies) {
  std::vector<Mesh> poses = lowering_the_arms();
  poses[1].triangles.pop_back();
  EXPECT_THROW(dress_person(poses, {}), InvalidInput);
  EXPECT_THROW(dress_person({}, {}), InvalidInput);
}

}  // namespace
}  // namespace regarment
