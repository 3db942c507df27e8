#include "scan/file_flaws.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdio>
#include <limits>
#include <numeric>

#include "scan/mesh_edges.h"

namespace regarment {
namespace {

constexpr double kCoarseStep = 0.0005, kUselessStep = 0.005;  // m, of coordinates
constexpr double kSparseCloud = 0.008, kSparseMesh = 0.025;   // m, between neighbours
constexpr double kNoisy = 0.004;                              // m
constexpr double kTwoSided = 0.1;  // of all faces: so many faces back to back are no folds
constexpr std::uint64_t kBeyondSingle = (1u << 29) - 1;  // bits of a double that a float lacks
constexpr double kNoArea = 1e-14;                        // of the squared extent

std::string millimetres(double metres) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.2g mm", 1000 * metres);
  return text.data();
}

std::size_t faces_without_area(const Mesh& mesh, const Welded& welded) {
  Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity()), high = -low;
  for (const Vec3& p : welded.positions) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const double least = kNoArea * (high - low).squaredNorm();
  std::size_t without = 0;
  for (const Triangle& t : mesh.triangles) {
    std::array<Vec3, 3> corners;
    bool known = true;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t at = welded.of_vertex[t[i]];
      known = known && at != Welded::kNone;
      if (known) corners[i] = welded.positions[at];
    }
    if (!known) continue;
    const Vec3 area = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
    without += area.norm() <= least ? 1 : 0;
  }
  return without;
}

void note_step(double step, std::vector<Finding>& findings) {
  if (!(step > kCoarseStep)) return;
  findings.push_back({"far_from_origin", step > kUselessStep ? Severity::Problem : Severity::Advice,
                      "The scan lies so far from the origin that its numbers, in single precision, "
                      "go in steps of " +
                          millimetres(step),
                      "It was moved to the origin in double precision",
                      "Export it near the origin, or with more digits"});
}

/// A triangle's corners in order, and whether they had to be swapped an even number of times.
struct Turned {
  Triangle corners{};
  bool even = true;
  std::uint32_t index = 0;
};

Turned turned(const Triangle& triangle, std::uint32_t index, const Welded& welded) {
  Turned turned{{}, true, index};
  for (std::size_t i = 0; i < 3; ++i) turned.corners[i] = welded.of_vertex[triangle[i]];
  auto& [a, b, c] = turned.corners;
  const auto order = [&](std::uint32_t& one, std::uint32_t& other) {
    if (one <= other) return;
    std::swap(one, other);
    turned.even = !turned.even;
  };
  order(a, b);
  order(b, c);
  order(a, b);
  return turned;
}

/// The triangles by their corners; of those with the same, those swapped evenly first, then by
/// index.
std::vector<Turned> by_corners(const std::vector<Triangle>& triangles, const Welded& welded) {
  // Filed under their lowest corner first: sorting a few at a time is quicker than all. What has
  // no position comes last.
  const std::size_t places = welded.positions.size();
  std::vector<std::uint32_t> next(places + 2, 0);
  const auto file_of = [&](const Turned& t) { return std::min<std::size_t>(t.corners[0], places); };
  for (std::uint32_t t = 0; t < triangles.size(); ++t)
    ++next[file_of(turned(triangles[t], t, welded)) + 1];
  std::partial_sum(next.begin(), next.end(), next.begin());
  const std::vector<std::uint32_t> first = next;
  std::vector<Turned> order(triangles.size());
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    const Turned one = turned(triangles[t], t, welded);
    order[next[file_of(one)]++] = one;
  }
  for (std::size_t file = 0; file <= places; ++file)
    std::sort(order.begin() + first[file], order.begin() + first[file + 1],
              [](const Turned& a, const Turned& b) {
                if (a.corners != b.corners) return a.corners < b.corners;
                return a.even != b.even ? a.even : a.index < b.index;
              });
  return order;
}

}  // namespace

std::size_t drop_repeated(std::vector<Triangle>& triangles, const Welded& welded) {
  const std::vector<Turned> order = by_corners(triangles, welded);
  std::vector<std::uint32_t> same, opposite;
  std::size_t first = 0;  // of those with the same corners
  for (std::size_t i = 1; i < order.size(); ++i) {
    const Turned &before = order[i - 1], &here = order[i];
    if (here.corners != before.corners) first = i;
    // What names a position twice, or none, is no face to repeat.
    const auto [a, b, c] = here.corners;
    if (here.corners != before.corners || a == b || b == c || c == Welded::kNone) continue;
    if (here.even == before.even) {
      same.push_back(here.index);
    } else {
      opposite.push_back(std::max(order[first].index, here.index));
    }
  }
  const bool two_sided =
      static_cast<double>(opposite.size()) > kTwoSided * static_cast<double>(triangles.size());
  if (two_sided) same.insert(same.end(), opposite.begin(), opposite.end());
  if (same.empty()) return 0;
  std::sort(same.begin(), same.end());
  std::size_t kept = 0;
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    if (!std::binary_search(same.begin(), same.end(), t)) triangles[kept++] = triangles[t];
  }
  triangles.resize(kept);
  return same.size();
}

double float_step(std::span<const Vec3> vertices) {
  Vec3 farthest = Vec3::Zero();
  for (const Vec3& p : vertices) {
    if (!p.allFinite()) continue;
    for (int axis = 0; axis < 3; ++axis) {
      if ((std::bit_cast<std::uint64_t>(p[axis]) & kBeyondSingle) != 0) return 0;
      farthest[axis] = std::max(farthest[axis], std::abs(p[axis]));
    }
  }
  const auto most = static_cast<float>(farthest.maxCoeff());
  const float next = std::nextafter(most, std::numeric_limits<float>::infinity());
  return std::isfinite(next) ? static_cast<double>(next) - static_cast<double>(most) : 0;
}

FileFlaws find_file_flaws(Mesh& mesh, const Welded& welded) {
  FileFlaws flaws;
  flaws.not_numbers = static_cast<std::size_t>(
      std::count(welded.of_vertex.begin(), welded.of_vertex.end(), Welded::kNone));
  // In a mesh that is how seams of texture and parts of a figure are made, and says nothing.
  if (mesh.is_cloud()) {
    flaws.together = mesh.positions.size() - flaws.not_numbers - welded.positions.size();
  }
  flaws.step = float_step(mesh.positions);
  flaws.repeated = drop_repeated(mesh.triangles, welded);
  flaws.flat = faces_without_area(mesh, welded);
  const std::vector<Triangle> triangles = weld_triangles(mesh.triangles, welded);
  flaws.crowded = find_edges(triangles, welded.positions.size()).crowded;
  return flaws;
}

void note_file_flaws(const FileFlaws& flaws, double metres, std::vector<Finding>& findings) {
  const auto note = [&](const char* code, std::size_t count, const char* one, const char* many,
                        const char* rest, const char* done) {
    if (count == 0) return;
    findings.push_back({code, Severity::Note, counted(count, one, many) + rest, done, ""});
  };
  if (flaws.not_numbers > 0) {
    findings.push_back(
        {"not_a_number", Severity::Advice,
         counted(flaws.not_numbers, "vertex has a coordinate", "vertices have coordinates") +
             " that are no numbers",
         "Left out of every measurement", "Export the scan again"});
  }
  note("duplicates", flaws.together, "point lies", "points lie", " exactly where another does",
       "They count once");
  note("duplicates", flaws.repeated, "face repeats", "faces repeat", " another one",
       "They count once");
  note("zero_area", flaws.flat, "face has", "faces have", " no area", "Passed over");
  note("non_manifold", flaws.crowded, "edge belongs", "edges belong", " to more than two faces",
       "The surface was taken apart there");
  note_step(flaws.step * metres, findings);
}

void note_sampling(const Scan& scan, std::vector<Finding>& findings) {
  const ScanFacts& facts = scan.facts;
  if (facts.spacing > (scan.mesh.is_cloud() ? kSparseCloud : kSparseMesh)) {
    findings.push_back({"sparse", Severity::Advice,
                        "Neighbouring points lie " + millimetres(facts.spacing) + " apart",
                        "Edges of cloth are found no finer", "Scan at a higher resolution"});
  }
  // Of points far apart the shape between them would be taken for noise.
  if (facts.noise > kNoisy && facts.spacing < kSparseCloud) {
    findings.push_back({"noisy", Severity::Advice,
                        "Points scatter by " + millimetres(facts.noise) + " about the surface",
                        "Steps of cloth thickness drown in it",
                        "Let the person stand still; check the scanner's calibration"});
  }
}

}  // namespace regarment
