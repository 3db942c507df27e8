#pragma once

#include <string>
#include <vector>

#include "garment/cut_piece.h"

namespace regarment {

/// A piece as it is printed, in millimetres, y down, the grain line upright, its box with a border
/// of 8 mm from (0, 0) to `size`. Internal to this library.
struct PrintPiece {
  std::string title, cutting;                // "Front, back", "cut 2 on the fold"
  std::vector<std::vector<Vec2>> cut, fold;  // lines to cut by, and where the fold lies
  std::vector<std::vector<Vec2>> notches;    // from the outline inward
  std::vector<CutLine> lines;                // construction lines
  std::array<Vec2, 2> grain = {Vec2::Zero(), Vec2::Zero()};
  std::vector<Vec2> outline;  // closed
  Vec2 size = Vec2::Zero();
};

/// The different pieces among these, each once: alike and mirrored ones together.
std::vector<PrintPiece> print_pieces(const std::vector<CutPiece>& pieces);

}  // namespace regarment
