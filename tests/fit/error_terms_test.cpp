// Eq. (1) on cases by hand. E_stretch is the mean over springs, each counted once: as printed, the
// double sum over neighbours counts every spring twice and would be 2 at rest, where the root's
// |1 - E_stretch| asks for 1.
#include "fit/error_terms.h"

#include <gtest/gtest.h>

#include "base/error.h"

namespace regarment {
namespace {

/// A mask drawn with '#' for covered pixels, rows from the top.
Silhouette mask(const std::vector<std::string>& rows) {
  Silhouette out;
  out.size = static_cast<int>(rows.size());
  for (const std::string& row : rows)
    for (const char pixel : row) out.covered.push_back(pixel == '#');
  return out;
}

TEST(TotalError, IsTheWeightedSumOfItsTerms) {
  // 2 * 0.03 + 10 * sqrt(0.04) + 5 * 0.5
  const ErrorTerms terms{0.03, 1.04, 0.5};
  EXPECT_DOUBLE_EQ(total_error(terms, {2, 10, 5}), 0.06 + 2 + 2.5);
  EXPECT_DOUBLE_EQ(total_error(terms, {2, 10, 5}, false), 0.06 + 0.4 + 2.5);
}

TEST(TotalError, IsZeroForAGarmentAtRestOnTheScan) {
  EXPECT_EQ(total_error({0, 1, 0}, {1, 1, 1}), 0);
  EXPECT_EQ(total_error({0, 1, 0}, {1, 1, 1}, false), 0);
}

TEST(TotalError, WeighsEachTermAlone) {
  const ErrorTerms terms{0.25, 0.75, 8};
  EXPECT_DOUBLE_EQ(total_error(terms, {4, 0, 0}), 1);
  EXPECT_DOUBLE_EQ(total_error(terms, {0, 4, 0}), 2);
  EXPECT_DOUBLE_EQ(total_error(terms, {0, 4, 0}, false), 1);
  EXPECT_DOUBLE_EQ(total_error(terms, {0, 0, 4}), 32);
  EXPECT_EQ(total_error(terms, {0, 0, 0}), 0);
}

TEST(TotalError, TreatsTooLongAndTooShortAlike) {
  for (const double off : {0.0, 1.0 / 1024, 1.0 / 16, 0.25, 1.0}) {
    for (const bool root : {true, false}) {
      const double longer = total_error({0, 1 + off, 0}, {1, 1, 1}, root);
      EXPECT_EQ(longer, total_error({0, 1 - off, 0}, {1, 1, 1}, root));
      EXPECT_DOUBLE_EQ(longer, root ? std::sqrt(off) : off);
    }
  }
}

TEST(SilhouetteError, CountsPixelsThatDifferOverTheGarments) {
  const Silhouette model = mask({"....", ".##.", ".##.", "...."});
  const Silhouette garment = mask({"....", "..##", "..##", "..##"});
  // Two pixels of the model alone and four of the garment alone, over the garment's six.
  EXPECT_DOUBLE_EQ(silhouette_error({{model}}, {{garment}}), 6.0 / 6);
  // The other way round over the model's four: the term is not symmetric.
  EXPECT_DOUBLE_EQ(silhouette_error({{garment}}, {{model}}), 6.0 / 4);
  EXPECT_EQ(silhouette_error({{garment}}, {{garment}}), 0);
}

TEST(SilhouetteError, SumsOverTheSides) {
  const Silhouette whole = mask({"##", "##"}), half = mask({"#.", "#."}), dot = mask({"#.", ".."});
  // 2/2 + 3/1 + 0/4 + 1/2
  const std::vector<Silhouette> model = {whole, whole, whole, dot};
  const std::vector<Silhouette> garment = {half, dot, whole, half};
  EXPECT_DOUBLE_EQ(silhouette_error(model, garment), 1 + 3 + 0 + 0.5);
  EXPECT_EQ(silhouette_error({}, {}), 0);
}

TEST(SilhouetteError, FallsWhenAGarmentInsideTheModelGrows) {
  // The paper's bias: what is covered more divides by more.
  const Silhouette model = mask({"####", "####", "####", "####"});
  EXPECT_DOUBLE_EQ(silhouette_error({{model}}, {{mask({"##..", "##..", "....", "...."})}}), 3);
  EXPECT_DOUBLE_EQ(silhouette_error({{model}}, {{mask({"###.", "###.", "##..", "...."})}}), 1);
}

TEST(SilhouetteError, OfAnEmptyModelIsOnePerSide) {
  const Silhouette none = mask({"..", ".."}), half = mask({"#.", "#."});
  EXPECT_DOUBLE_EQ(silhouette_error({{none, none}}, {{half, half}}), 2);
}

TEST(SilhouetteError, RefusesAGarmentThatIsNotSeen) {
  const Silhouette none = mask({"..", ".."}), half = mask({"#.", "#."});
  EXPECT_THROW(silhouette_error({{half, half}}, {{half, none}}), NoGarmentError);
  EXPECT_THROW(silhouette_error({{none}}, {{none}}), NoGarmentError);
}

TEST(UnseenError, NoGarmentThatIsSeenHasALargerOne) {
  const Silhouette model = mask({"##.", "##.", "..."}), dot = mask({"...", "...", "..#"});
  // A pixel beside the model: 4 + 1 differ, over 1; any other garment is nearer or larger.
  EXPECT_DOUBLE_EQ(unseen_error({{model}}), 5);
  EXPECT_DOUBLE_EQ(silhouette_error({{model}}, {{dot}}), 5);
  for (unsigned bits = 1; bits < 512; ++bits) {
    Silhouette garment = dot;
    for (unsigned i = 0; i < 9; ++i) garment.covered[i] = (bits >> i) & 1U;
    EXPECT_LE(silhouette_error({{model}}, {{garment}}), 5) << bits;
  }
  EXPECT_DOUBLE_EQ(unseen_error({{model, model, dot}}), 5 + 5 + 2);
}

TEST(SilhouetteError, RefusesSidesAndSizesThatDoNotMatch) {
  const Silhouette small = mask({"##", "##"}), large = mask({"###", "###", "###"});
  EXPECT_THROW(silhouette_error({{small, small}}, {{small}}), InvalidInput);
  EXPECT_THROW(silhouette_error({{small}}, {{large}}), InvalidInput);
}

}  // namespace
}  // namespace regarment
