#include "analysis/spread.h"

#include <algorithm>
#include <array>

#include "findings.h"
#include "scan/make_scan.h"

namespace regarment {
namespace {

struct Both {
  Analysis whole, thinned;
};

Both analysed(const Mesh& mesh) {
  const auto skirt = test::templates_of({"skirt"});
  Scan whole = make_scan(mesh), thinned = make_scan(mesh, {.most_vertices = 20'000});
  EXPECT_EQ(whole.thin, nullptr);
  EXPECT_NE(thinned.thin, nullptr);
  return {analyze(std::move(whole), skirt), analyze(std::move(thinned), skirt)};
}

Mesh skirted_person(bool capped) {
  test::PersonPlan plan;
  plan.skirt = test::MadeSkirt{};
  plan.skirt->capped = capped;
  plan.edge = 0.006;
  return test::make_person(plan).mesh;
}

TEST(Spread, GivesEveryVertexTheLabelItWouldHaveItself) {
  const Mesh mesh = skirted_person(false);
  ASSERT_GT(mesh.positions.size(), 25'000U);
  const auto [whole, thinned] = analysed(mesh);
  ASSERT_EQ(thinned.labels.size(), mesh.positions.size());
  ASSERT_EQ(thinned.label_probability.size(), mesh.positions.size());
  std::size_t other = 0;
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    other += thinned.labels[v] != whole.labels[v] ? 1 : 0;
    EXPECT_GE(thinned.label_probability[v], 0.5F);
  }
  EXPECT_LT(other, mesh.positions.size() / 100);  // a row beside hem and waist
  EXPECT_EQ(thinned.garments[0].vertices_labelled,
            static_cast<std::size_t>(std::count(thinned.labels.begin(), thinned.labels.end(), 1)));
  for (const char* name : {"length", "width", "waist"}) {
    EXPECT_NEAR(test::measured(thinned.garments[0], name).flat,
                test::measured(whole.garments[0], name).flat, 0.012);
  }
}

TEST(Spread, MarksTheTrianglesOfACap) {
  const auto [whole, thinned] = analysed(skirted_person(true));
  ASSERT_EQ(thinned.cap.size(), thinned.scan.mesh.triangles.size());
  ASSERT_EQ(whole.cap.size(), thinned.cap.size());
  std::array<std::size_t, 2> alike{}, all{};
  for (std::size_t t = 0; t < whole.cap.size(); ++t) {
    ++all[whole.cap[t]];
    alike[whole.cap[t]] += thinned.cap[t] == whole.cap[t] ? 1 : 0;
  }
  EXPECT_GT(all[1], 500U);
  EXPECT_GT(alike[1], all[1] * 9 / 10);
  EXPECT_GT(alike[0], all[0] * 99 / 100);
}

TEST(Spread, LeavesNumbersThatAreNoneToThePerson) {
  Mesh mesh = skirted_person(false);
  mesh.positions[5].z() = std::numeric_limits<double>::infinity();
  Scan scan = make_scan(mesh, {.most_vertices = 20'000});
  const Analysis analysis = analyze(std::move(scan), test::templates_of({"skirt"}));
  EXPECT_EQ(analysis.labels[5], 0);
  EXPECT_EQ(analysis.label_probability[5], 1.0F);
}

}  // namespace
}  // namespace regarment
