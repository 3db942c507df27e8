#pragma once

#include <array>
#include <string>
#include <vector>

#include "garment/garment_template.h"
#include "garment/notches.h"

namespace regarment {

/// One edge of a piece as it is cut.
struct CutEdge {
  std::string name;  // "left_armhole"
  bool is_sewn = false;
  std::vector<Vec2> controls;  // Bezier: none straight, 1 quadratic, 2 cubic
  std::vector<Vec2> points;    // both ends and, of a curve, points on it with chords of about 3 mm
};

struct CutLine {
  std::string title;  // "hip line"
  Vec2 from = Vec2::Zero(), to = Vec2::Zero();
};

/// A panel as a pattern maker sees it: the right side of the cloth up, whole also when it is cut on
/// the fold, without seam allowance. Coordinates in metres, x to the right, y down (as a sheet of
/// paper, and SVG), those of the panel but for backs, which are turned over.
struct CutPiece {
  std::string name, title;  // "left_sleeve_front", "Left sleeve front"
  // Closed: each starts where the one before ends. They run clockwise, as seen; the halves of a
  // piece cut on the fold one after the other.
  std::vector<CutEdge> edges;
  std::vector<Notch> notches;
  std::vector<CutLine> lines;  // construction lines with a title
  std::array<Vec2, 2> grain = {Vec2::Zero(), Vec2::Zero()};
  bool on_fold = false;  // symmetric about x = 0
  int shape = 0;         // pieces of one shape are alike, or mirror images of each other,
  bool turned = false;   // as this tells
};

/// The pieces of a garment, one per panel, in the template's order. A panel whose grain line the
/// template does not draw has one square to its longest free edge. Throws InvalidInput when
/// `dimensions` make no garment.
std::vector<CutPiece> cut_pieces(const GarmentTemplate& garment, const Dimensions& dimensions);

/// Length of an edge, m.
double cut_length(const CutEdge& edge);

/// The outline as a closed polygon, first point not repeated.
std::vector<Vec2> cut_outline(const CutPiece& piece);

}  // namespace regarment
