#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "garment/drawn_line.h"
#include "garment/pattern.h"

namespace regarment {

/// A triangle of a flat garment that belongs to a strip: where it lies across the strips and which
/// way they run through it.
struct StripPiece {
  std::size_t triangle = 0;
  double position = 0;                 // m, of its middle
  double area = 0;                     // m^2
  Vec2 along = Vec2::Zero();           // unit, (s, t)
  std::array<double, 3> corners = {};  // m, positions of its corners
};

/// Sides b - a and c - a of a flat triangle as columns, (s, t), m.
Eigen::Matrix2d flat_sides(const Pattern& pattern, const Triangle& triangle);

/// Whether a line of one set is nearly parallel to one of the other on the same panel.
bool run_alike(const std::vector<DrawnLine>& a, const std::vector<DrawnLine>& b);

/// The triangles of the panels `lines` lie on, in the pattern's order. Positions grow down the
/// garment and are 0 on the lines; mirrored lines count alike.
std::vector<StripPiece> strip_pieces(const Pattern& pattern, const std::vector<DrawnLine>& lines);

/// Position of another line among strips along `lines`, m; nothing when it runs otherwise.
std::optional<double> level_among(const std::vector<DrawnLine>& lines,
                                  const std::vector<DrawnLine>& other);

/// Adds up what strips of cloth see of one quantity of their triangles. Keeps a reference to the
/// pieces, of which there must be one.
class Strips {
 public:
  static constexpr double kStep = 0.02;  // m between strips

  explicit Strips(const std::vector<StripPiece>& pieces) : pieces_(pieces) {
    double low = pieces.front().position, high = low;
    for (const StripPiece& piece : pieces) {
      low = std::min(low, piece.position);
      high = std::max(high, piece.position);
    }
    low_ = low;
    high_ = high;
    count_ = 2 + static_cast<std::size_t>((high - low) / kStep);
  }

  std::size_t count() const { return count_; }
  double position(std::size_t strip) const { return low_ + kStep * static_cast<double>(strip); }

  /// The position itself or, at an end, the nearest where there is cloth on all sides.
  double within(double position) const { return std::clamp(position, low_, high_); }

  /// Sum over a strip's triangles of area times value; each shared out to the two strips beside it.
  template <typename Value>
  std::vector<double> sum(const Value& value) const {
    std::vector<double> out(count_, 0.0);
    for (const StripPiece& piece : pieces_) {
      const double at = (piece.position - low_) / kStep;
      const auto strip = std::min(static_cast<std::size_t>(at), count_ - 2);
      const double right = at - static_cast<double>(strip);
      const double amount = piece.area * value(piece);
      out[strip] += (1 - right) * amount;
      out[strip + 1] += right * amount;
    }
    return out;
  }

 private:
  const std::vector<StripPiece>& pieces_;
  double low_ = 0, high_ = 0;  // m, of the outermost triangles' middles
  std::size_t count_ = 0;
};

}  // namespace regarment
