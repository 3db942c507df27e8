#include "synthetic/case_recipe.h"

#include <gtest/gtest.h>

#include <array>
#include <map>
#include <set>

#include "base/error.h"
#include "synthetic/truth_json.h"

namespace regarment {
namespace {

TEST(SampleCase, IsTheSameWhateverWasDrawnBefore) {
  const std::string alone = recipe_json(sample_case(3, 41));
  sample_case(3, 40);
  EXPECT_EQ(recipe_json(sample_case(3, 41)), alone);
  EXPECT_NE(recipe_json(sample_case(4, 41)), alone);
  EXPECT_NE(recipe_json(sample_case(3, 41, {}, 1)), alone);
}

TEST(SampleCase, AnotherAttemptIsAnotherPersonInTheSameOutfit) {
  const CaseRecipe first = sample_case(3, 5), second = sample_case(3, 5, {}, 1);
  EXPECT_EQ(first.outfit, second.outfit);
  EXPECT_EQ(first.kind, second.kind);
  EXPECT_NE(first.body.scale, second.body.scale);
}

TEST(SampleCase, CasesAreManyAndWithinWhatAScannerTakes) {
  std::map<ScanKind, int> kinds;
  std::set<Outfit> outfits;
  std::set<std::string> units, axes, faults;
  int undamaged = 0;
  for (std::uint32_t i = 0; i < 40; ++i) {
    const CaseRecipe recipe = sample_case(1, i);
    EXPECT_NO_THROW(recipe.scanner.check());
    EXPECT_NO_THROW(recipe.surface.check());
    EXPECT_NO_THROW(recipe.faults.check());
    EXPECT_NO_THROW(recipe.frame.check());
    ++kinds[recipe.kind];
    outfits.insert(recipe.outfit);
    units.insert(recipe.frame.units);
    axes.insert(recipe.frame.up);
    faults.insert(recipe.damage.begin(), recipe.damage.end());
    undamaged += recipe.damage.empty() ? 1 : 0;
  }
  // Shares of 40, give or take 4: the discrepancy of the sequence is below 3 there.
  EXPECT_NEAR(kinds[ScanKind::Cloud], 16, 4);
  EXPECT_NEAR(kinds[ScanKind::OpenMesh], 12, 4);
  EXPECT_NEAR(kinds[ScanKind::ClosedMesh], 12, 4);
  EXPECT_NEAR(undamaged, 13.6, 4);
  EXPECT_EQ(outfits.size(), 9U);
  EXPECT_EQ(units.size(), 4U);
  EXPECT_GE(axes.size(), 4U);
  EXPECT_GE(faults.size(), 7U);
}

TEST(SampleCase, KeepsToWhatIsWishedFor) {
  for (std::uint32_t i = 0; i < 6; ++i) {
    const CaseRecipe recipe = sample_case(1, i, {{"tshirt", "skirt"}, ScanKind::OpenMesh});
    EXPECT_EQ(recipe.outfit, Outfit::TshirtOverSkirt);
    EXPECT_EQ(recipe.kind, ScanKind::OpenMesh);
    EXPECT_EQ(recipe.garments.size(), 2U);
  }
}

TEST(SampleCase, RefusesGarmentsNobodyWearsTogether) {
  EXPECT_THROW(sample_case(1, 0, {{"skirt", "skirt"}, {}}), UsageError);
  try {
    check_wish({{"trousers"}, {}});
    FAIL() << "trousers were drawn";
  } catch (const UsageError& e) {
    EXPECT_NE(std::string(e.what()).find("trousers"), std::string::npos) << e.what();
  }
}

TEST(CaseRecipe, HasANameThatSorts) {
  CaseRecipe recipe;
  recipe.index = 7;
  EXPECT_EQ(recipe.name(), "case-0007");
  EXPECT_EQ(scan_file(recipe), "case-0007.cloud.ply");
  recipe.index = 12345;
  recipe.kind = ScanKind::OpenMesh;
  EXPECT_EQ(scan_file(recipe), "case-12345.mesh.ply");
}

}  // namespace
}  // namespace regarment
