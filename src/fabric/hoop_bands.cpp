#include "fabric/hoop_bands.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>

#include "base/error.h"
#include "fabric/level_section.h"
#include "garment/drawn_line.h"
#include "garment/plane.h"

namespace regarment {
namespace {

constexpr double kStep = 0.02;      // m between strips
constexpr double kParallel = 0.05;  // rad within which lines run alike
constexpr double kDepends = 0.02;   // share below which a dimension does not matter
constexpr double kKnown = 0.5;      // least sum of shares of a strip that tells of dimensions
constexpr double kNudge = 1e-3;     // relative change of a dimension, for the shares
constexpr double kMostTurn = 1.5;   // rad between two vertices; more is a crease, not an arc

using Edges2 = Eigen::Matrix2d;
using Edges3 = Eigen::Matrix<double, 3, 2>;

Edges2 flat_sides(const Pattern& pattern, const Triangle& t) {
  Edges2 out;
  out << pattern.flat[t[1]] - pattern.flat[t[0]], pattern.flat[t[2]] - pattern.flat[t[0]];
  return out;
}

Edges3 worn_sides(const std::vector<Vec3>& x, const Triangle& t) {
  Edges3 out;
  out << x[t[1]] - x[t[0]], x[t[2]] - x[t[0]];
  return out;
}

bool run_alike(const std::vector<DrawnLine>& a, const std::vector<DrawnLine>& b) {
  return std::any_of(a.begin(), a.end(), [&](const DrawnLine& p) {
    return std::any_of(b.begin(), b.end(), [&](const DrawnLine& q) {
      const Vec2 u = p.along(), v = q.along();
      return p.panel == q.panel && std::abs(u.x() * v.y() - u.y() * v.x()) < kParallel;
    });
  });
}

// A triangle that belongs to a strip: where it lies and which way the strip runs through it.
struct Piece {
  std::size_t triangle = 0;
  double position = 0;  // m
  double area = 0;      // m^2
  Vec2 along = Vec2::Zero();
  std::array<double, 3> corners = {};  // m, positions of the triangle's corners
};

// Of a line and its mirror image on one panel, the one on the triangle's side.
const DrawnLine* line_of(const std::vector<DrawnLine>& lines, int panel, const Vec2& middle) {
  const DrawnLine* out = nullptr;
  double nearest = 0;
  for (const DrawnLine& line : lines) {
    const double distance = (0.5 * (line.from + line.to) - middle).norm();
    if (line.panel != panel || (out != nullptr && distance >= nearest)) continue;
    out = &line;
    nearest = distance;
  }
  return out;
}

// How far a point of a panel lies across the strips, m.
double position_of(const DrawnLine& line, const Vec2& point) {
  const Vec2 u = line.along(), off = point - line.from;
  // Mirrored lines run the other way round; down the garment is positive on all of them.
  const double sign = line.from.x() + line.to.x() < -1e-9 ? -1 : 1;
  return sign * (u.x() * off.y() - u.y() * off.x());
}

std::vector<Piece> pieces_along(const Pattern& pattern, const std::vector<DrawnLine>& lines) {
  std::vector<Piece> out;
  for (std::size_t k = 0; k < pattern.triangles.size(); ++k) {
    const Triangle& t = pattern.triangles[k];
    const Vec2 middle = (pattern.flat[t[0]] + pattern.flat[t[1]] + pattern.flat[t[2]]) / 3;
    const DrawnLine* line = line_of(lines, pattern.panel[t[0]], middle);
    const double area = 0.5 * std::abs(flat_sides(pattern, t).determinant());
    if (line == nullptr || area <= 0) continue;
    Piece piece{k, position_of(*line, middle), area, line->along(), {}};
    for (std::size_t c = 0; c < 3; ++c) piece.corners[c] = position_of(*line, pattern.flat[t[c]]);
    out.push_back(piece);
  }
  return out;
}

// The level of a dimension's line among strips along `lines`; nothing when it runs otherwise.
std::optional<double> level_of(const std::vector<DrawnLine>& lines,
                               const std::vector<DrawnLine>& of_dimension) {
  if (!run_alike(lines, of_dimension)) return std::nullopt;
  for (const DrawnLine& line : of_dimension) {
    const Vec2 middle = 0.5 * (line.from + line.to);
    const DrawnLine* beside = line_of(lines, line.panel, middle);
    if (beside != nullptr) return position_of(*beside, middle);
  }
  return std::nullopt;
}

// Adds up what the strips see of one quantity of their triangles.
class Strips {
 public:
  explicit Strips(const std::vector<Piece>& pieces) : pieces_(pieces) {
    double low = pieces.front().position, high = low;
    for (const Piece& piece : pieces) {
      low = std::min(low, piece.position);
      high = std::max(high, piece.position);
    }
    low_ = low;
    high_ = high;
    count_ = 2 + static_cast<std::size_t>((high - low) / kStep);
  }

  std::size_t count() const { return count_; }
  double position(std::size_t strip) const { return low_ + kStep * static_cast<double>(strip); }

  // The position itself or, at an end, the nearest where there is cloth on all sides.
  double within(double position) const { return std::clamp(position, low_, high_); }

  // Sum over a strip's triangles of area times value; each shared out to the two strips beside it.
  template <typename Value>
  std::vector<double> sum(const Value& value) const {
    std::vector<double> out(count_, 0.0);
    for (const Piece& piece : pieces_) {
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
  const std::vector<Piece>& pieces_;
  double low_ = 0, high_ = 0;  // m, of the outermost triangles' middles
  std::size_t count_ = 0;
};

// How much longer the cloth at one level is than a tape pulled tight round it, as a logarithm; of
// all limbs it goes round together.
double fold_at(const Pattern& pattern, const std::vector<Vec3>& draped,
               const std::vector<Piece>& pieces, const Strips& strips, double position) {
  const double level = strips.within(position);
  std::map<std::string, std::vector<Vec3>> sections;
  double length = 0;
  for (const Piece& piece : pieces) {
    const Triangle& t = pattern.triangles[piece.triangle];
    std::vector<Vec3> ends;
    for (std::size_t c = 0; c < 3; ++c) {
      const std::size_t d = (c + 1) % 3;
      const double from = piece.corners[c] - level, to = piece.corners[d] - level;
      if ((from < 0) == (to < 0)) continue;
      ends.push_back(draped[t[c]] + from / (from - to) * (draped[t[d]] - draped[t[c]]));
    }
    if (ends.size() != 2) continue;
    length += (ends[1] - ends[0]).norm();
    const auto panel = static_cast<std::size_t>(pattern.panel[t[0]]);
    std::vector<Vec3>& section = sections[pattern.panel_limbs[panel]];
    section.insert(section.end(), ends.begin(), ends.end());
  }
  double tape = 0;
  for (const auto& [limb, section] : sections) tape += tape_length(section);
  return tape > 0 && length > tape ? std::log(length / tape) : 0.0;
}

// Moves the pattern to a dimension slightly larger, or slightly smaller where larger is no garment.
// Returns the relative change; 0 where neither is one.
double nudged(const GarmentTemplate& garment, const Dimensions& worn, const std::string& name,
              Pattern& moved) {
  for (const double nudge : {kNudge, -kNudge}) {
    Dimensions other = worn;
    other[name] *= 1 + nudge;
    try {
      move_pattern(garment, other, moved);
      return nudge;
    } catch (const InvalidInput&) {
      continue;
    }
  }
  return 0;
}

// d log(length) / d log(dimension) per strip.
std::vector<double> shares(const GarmentTemplate& garment, const Dimensions& worn,
                           const Pattern& pattern, const Strips& strips, const std::string& name) {
  Pattern moved = pattern;
  const double nudge = nudged(garment, worn, name, moved);
  if (nudge == 0) return std::vector<double>(strips.count(), 0.0);
  const std::vector<double> area = strips.sum([](const Piece&) { return 1.0; });
  std::vector<double> out = strips.sum([&](const Piece& piece) {
    const Triangle& t = pattern.triangles[piece.triangle];
    const Edges2 map = flat_sides(moved, t) * flat_sides(pattern, t).inverse();
    return (map * piece.along).norm() - 1;
  });
  for (std::size_t k = 0; k < out.size(); ++k) {
    out[k] = area[k] > 0 ? out[k] / area[k] / nudge : 0.0;
  }
  return out;
}

// Normals of the worn cloth, one per pattern vertex, unit or zero.
std::vector<Vec3> worn_normals(const Pattern& pattern, const std::vector<Vec3>& draped) {
  std::vector<Vec3> sum(static_cast<std::size_t>(pattern.particle_count), Vec3::Zero());
  for (const Triangle& t : pattern.triangles) {
    const Vec3 normal = (draped[t[1]] - draped[t[0]]).cross(draped[t[2]] - draped[t[0]]);
    for (const auto v : t) sum[static_cast<std::size_t>(pattern.particle[v])] += normal;
  }
  std::vector<Vec3> out;
  for (const int p : pattern.particle) {
    out.push_back(sum[static_cast<std::size_t>(p)].stableNormalized());
  }
  return out;
}

// How much longer a strip is within a triangle than flat. A triangle is a chord of the curved
// cloth: over an arc that turns by a, the arc is longer by a^2 / 24.
double stretch_within(const Pattern& pattern, const std::vector<Vec3>& draped,
                      const std::vector<Vec3>& normals, const Piece& piece) {
  const Triangle& t = pattern.triangles[piece.triangle];
  const Vec2 across = flat_sides(pattern, t).inverse() * piece.along;
  const double chord = (worn_sides(draped, t) * across).norm();
  const double side = std::sqrt(4 * piece.area / std::numbers::sqrt3);
  const double turn = std::min(side * (worn_sides(normals, t) * across).norm(), kMostTurn);
  return chord * (1 + turn * turn / 24);
}

// Where the strips go round the limb, from and to, m: on the longer side of those that end at a
// seam to another limb.
std::array<double, 2> whole_part(const Pattern& pattern, const std::vector<Piece>& pieces) {
  const auto limb = [&](std::size_t v) {
    return pattern.panel_limbs[static_cast<std::size_t>(pattern.panel[v])];
  };
  std::vector<std::string> first(static_cast<std::size_t>(pattern.particle_count));
  std::vector<bool> between(first.size());
  for (std::size_t v = 0; v < pattern.particle.size(); ++v) {
    const auto p = static_cast<std::size_t>(pattern.particle[v]);
    if (first[p].empty()) first[p] = limb(v);
    if (first[p] != limb(v)) between[p] = true;
  }
  double low = 1e9, high = -1e9, from = 1e9, to = -1e9;
  for (const Piece& piece : pieces) {
    low = std::min(low, piece.position);
    high = std::max(high, piece.position);
    for (const auto v : pattern.triangles[piece.triangle]) {
      if (!between[static_cast<std::size_t>(pattern.particle[v])]) continue;
      from = std::min(from, piece.position);
      to = std::max(to, piece.position);
    }
  }
  if (from > to) return {low - kStep, high + kStep};
  if (from - low > high - to) return {low - kStep, from};
  return {to, high + kStep};
}

HoopFamily family_of(const GarmentTemplate& garment, const Dimensions& worn, const Pattern& pattern,
                     const std::vector<Vec3>& draped, const std::vector<DrawnLine>& lines,
                     const std::vector<std::string>& candidates) {
  const std::vector<Piece> pieces = pieces_along(pattern, lines);
  if (pieces.empty()) return {};
  const Strips strips(pieces);
  const std::vector<double> area = strips.sum([](const Piece&) { return 1.0; });
  const std::vector<Vec3> normals = worn_normals(pattern, draped);
  const std::vector<double> length = strips.sum(
      [&](const Piece& piece) { return stretch_within(pattern, draped, normals, piece); });
  HoopFamily out;
  std::vector<std::vector<double>> share;
  for (const std::string& name : candidates) {
    share.push_back(shares(garment, worn, pattern, strips, name));
    const double most = *std::max_element(share.back().begin(), share.back().end());
    if (most < kDepends) {
      share.pop_back();
      continue;
    }
    out.dimensions.push_back(name);
    const std::optional<double> level = level_of(lines, drawn_lines(garment, worn, pattern, name));
    out.folds.push_back(level ? fold_at(pattern, draped, pieces, strips, *level) : 0.0);
  }
  const std::array<double, 2> whole = whole_part(pattern, pieces);
  for (std::size_t k = 0; k < strips.count(); ++k) {
    HoopBand band;
    band.position = strips.position(k);
    double known = 0;
    for (std::size_t d = 0; d < share.size(); ++d) {
      band.share.push_back(share[d][k]);
      band.girth += share[d][k] * worn.at(out.dimensions[d]);
      known += share[d][k];
    }
    const bool is_whole = band.position >= whole[0] && band.position <= whole[1];
    if (!is_whole || known < kKnown || area[k] <= 0) continue;
    band.girth /= known;
    band.excess = std::log(length[k] / area[k]);
    band.fold = fold_at(pattern, draped, pieces, strips, band.position);
    out.bands.push_back(band);
  }
  return out;
}

}  // namespace

std::vector<HoopFamily> hoop_families(const GarmentTemplate& garment, const Dimensions& worn,
                                      const Pattern& pattern, const std::vector<Vec3>& draped,
                                      const std::vector<std::string>& names,
                                      const std::vector<std::string>& others) {
  std::vector<std::string> candidates = names;
  candidates.insert(candidates.end(), others.begin(), others.end());
  std::vector<std::vector<DrawnLine>> done;
  std::vector<HoopFamily> out;
  for (const std::string& name : names) {
    const std::vector<DrawnLine> lines = drawn_lines(garment, worn, pattern, name);
    const bool seen = std::any_of(done.begin(), done.end(),
                                  [&](const auto& other) { return run_alike(lines, other); });
    if (lines.empty() || seen) continue;
    done.push_back(lines);
    out.push_back(family_of(garment, worn, pattern, draped, lines, candidates));
  }
  return out;
}

}  // namespace regarment
