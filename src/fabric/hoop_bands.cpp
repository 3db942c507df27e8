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
#include "fabric/strips.h"
#include "garment/drawn_line.h"
#include "garment/particles.h"
#include "garment/worn_normals.h"

namespace regarment {
namespace {

constexpr double kDepends = 0.02;  // share below which a dimension does not matter
constexpr double kKnown = 0.5;     // least sum of shares of a strip that tells of dimensions
constexpr double kNudge = 1e-3;    // relative change of a dimension, for the shares
constexpr double kMostTurn = 1.5;  // rad between two vertices; more is a crease, not an arc

using Edges3 = Eigen::Matrix<double, 3, 2>;

Edges3 worn_sides(const std::vector<Vec3>& x, const Triangle& t) {
  Edges3 out;
  out << x[t[1]] - x[t[0]], x[t[2]] - x[t[0]];
  return out;
}

// How much longer the cloth at one level is than a tape pulled tight round it, as a logarithm; of
// all limbs it goes round together.
double fold_at(const Pattern& pattern, const std::vector<Vec3>& draped,
               const std::vector<StripPiece>& pieces, const Strips& strips, double position) {
  const double level = strips.within(position);
  std::map<std::string, std::vector<Vec3>> sections;
  double length = 0;
  for (const StripPiece& piece : pieces) {
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
  const std::vector<double> area = strips.sum([](const StripPiece&) { return 1.0; });
  std::vector<double> out = strips.sum([&](const StripPiece& piece) {
    const Triangle& t = pattern.triangles[piece.triangle];
    const Eigen::Matrix2d map = flat_sides(moved, t) * flat_sides(pattern, t).inverse();
    return (map * piece.along).norm() - 1;
  });
  for (std::size_t k = 0; k < out.size(); ++k) {
    out[k] = area[k] > 0 ? out[k] / area[k] / nudge : 0.0;
  }
  return out;
}

// Normals of the worn cloth, one per pattern vertex, unit or zero.
std::vector<Vec3> vertex_normals(const Pattern& pattern, const std::vector<Vec3>& draped) {
  const std::vector<Vec3> normals = worn_normals(pattern, particle_positions(pattern, draped));
  std::vector<Vec3> out;
  for (const int p : pattern.particle) out.push_back(normals[static_cast<std::size_t>(p)]);
  return out;
}

// How much longer a strip is within a triangle than flat. A triangle is a chord of the curved
// cloth: over an arc that turns by a, the arc is longer by a^2 / 24.
double stretch_within(const Pattern& pattern, const std::vector<Vec3>& draped,
                      const std::vector<Vec3>& normals, const StripPiece& piece) {
  const Triangle& t = pattern.triangles[piece.triangle];
  const Vec2 across = flat_sides(pattern, t).inverse() * piece.along;
  const double chord = (worn_sides(draped, t) * across).norm();
  const double side = std::sqrt(4 * piece.area / std::numbers::sqrt3);
  const double turn = std::min(side * (worn_sides(normals, t) * across).norm(), kMostTurn);
  return chord * (1 + turn * turn / 24);
}

// Where the strips go round the limb, from and to, m: on the longer side of those that end at a
// seam to another limb.
std::array<double, 2> whole_part(const Pattern& pattern, const std::vector<StripPiece>& pieces) {
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
  for (const StripPiece& piece : pieces) {
    low = std::min(low, piece.position);
    high = std::max(high, piece.position);
    for (const auto v : pattern.triangles[piece.triangle]) {
      if (!between[static_cast<std::size_t>(pattern.particle[v])]) continue;
      from = std::min(from, piece.position);
      to = std::max(to, piece.position);
    }
  }
  if (from > to) return {low - Strips::kStep, high + Strips::kStep};
  if (from - low > high - to) return {low - Strips::kStep, from};
  return {to, high + Strips::kStep};
}

HoopFamily family_of(const GarmentTemplate& garment, const Dimensions& worn, const Pattern& pattern,
                     const std::vector<Vec3>& draped, const std::vector<DrawnLine>& lines,
                     const std::vector<std::string>& candidates) {
  const std::vector<StripPiece> pieces = strip_pieces(pattern, lines);
  if (pieces.empty()) return {};
  const Strips strips(pieces);
  const std::vector<double> area = strips.sum([](const StripPiece&) { return 1.0; });
  const std::vector<Vec3> normals = vertex_normals(pattern, draped);
  const std::vector<double> length = strips.sum(
      [&](const StripPiece& piece) { return stretch_within(pattern, draped, normals, piece); });
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
    const std::optional<double> level =
        level_among(lines, drawn_lines(garment, worn, pattern, name));
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
