#include "garment/cut_piece.h"

#include <gtest/gtest.h>

#include "garment/plane.h"
#include "garments.h"

namespace regarment {
namespace {

std::vector<CutPiece> pieces_of(const std::string& garment, const Dimensions& dimensions) {
  return cut_pieces(find_template(garment), dimensions);
}

TEST(CutPiece, EveryPanelIsAClosedPieceThatRunsClockwise) {
  for (const CutPiece& piece : pieces_of("tshirt", whole_tshirt())) {
    for (std::size_t e = 0; e < piece.edges.size(); ++e) {
      const CutEdge& next = piece.edges[(e + 1) % piece.edges.size()];
      EXPECT_EQ(piece.edges[e].points.back(), next.points.front()) << piece.name;
    }
    EXPECT_GT(polygon_area(cut_outline(piece)), 0.0) << piece.name;  // y points down
  }
}

TEST(CutPiece, SleevesComeInTwoMirroredPairs) {
  std::map<std::string, bool> turned;
  for (const CutPiece& piece : pieces_of("tshirt", whole_tshirt()))
    turned[piece.name] = piece.turned;
  EXPECT_EQ(turned["left_sleeve_front"], turned["right_sleeve_back"]);
  EXPECT_EQ(turned["left_sleeve_back"], turned["right_sleeve_front"]);
  EXPECT_NE(turned["left_sleeve_front"], turned["left_sleeve_back"]);
}

TEST(CutPiece, ASleevesGrainRunsAlongItsUpperEdge) {
  const double slope = 28.0 * M_PI / 180.0;  // of the upper edge, by the template
  for (const CutPiece& piece : pieces_of("tshirt", whole_tshirt())) {
    if (piece.name != "left_sleeve_front") continue;
    const Vec2 along = (piece.grain[1] - piece.grain[0]).normalized();
    EXPECT_NEAR(std::abs(along.dot(Vec2(std::cos(slope), std::sin(slope)))), 1.0, 1e-9);
    for (const Vec2& end : piece.grain) EXPECT_TRUE(is_inside(cut_outline(piece), end));
  }
}

TEST(CutPiece, NotchesLieOnTheOutlineAndPointInside) {
  for (const CutPiece& piece : pieces_of("tshirt", whole_tshirt())) {
    const std::vector<Vec2> outline = cut_outline(piece);
    EXPECT_GE(piece.notches.size(), 2u) << piece.name;
    for (const Notch& notch : piece.notches) {
      bool on_outline = false;
      for (std::size_t i = 0; i < outline.size(); ++i)
        on_outline = on_outline ||
                     is_on_segment(notch.at, outline[i], outline[(i + 1) % outline.size()], 1e-9);
      EXPECT_TRUE(on_outline) << piece.name << " " << notch.at.transpose();
      EXPECT_NEAR(notch.inward.norm(), 1.0, 1e-12);
      EXPECT_TRUE(is_inside(outline, notch.at + 0.001 * notch.inward)) << piece.name;
    }
  }
}

// The hip line lies 20 cm down, 48 cm long; the skirt's side bends there.
TEST(CutPiece, ConstructionLinesGoFromSideToSide) {
  const CutPiece front = pieces_of("skirt", whole_skirt())[0];
  ASSERT_EQ(front.lines.size(), 1u);
  EXPECT_EQ(front.lines[0].title, "hip line");
  EXPECT_NEAR((front.lines[0].from - front.lines[0].to).norm(), 0.48, 1e-12);
  EXPECT_NEAR(front.lines[0].from.y(), 0.20, 1e-12);
}

}  // namespace
}  // namespace regarment
