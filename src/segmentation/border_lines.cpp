#include "segmentation/border_lines.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>

#include "base/error.h"
#include "geometry/border_edges.h"
#include "geometry/parallel.h"
#include "geometry/point_tree.h"
#include "segmentation/scan_links.h"

namespace regarment {
namespace {

constexpr std::size_t kGrain = 2048;
constexpr double kStep = 0.005;       // m between points of a line
constexpr double kReach = 0.03;       // m from the draped edge at which its border is looked for
constexpr double kNearAgain = 0.012;  // m from the first line: what belongs to it
constexpr double kSmooth = 2;         // points, standard deviation of the smoothing
constexpr int kWindow = 6;            // points on both sides that are averaged
constexpr std::size_t kRound = 17;    // a point of a cloud and those round it
constexpr double kEmptyAngle = 2.1;   // radians without cloth: there it ends
constexpr std::size_t kMostPoints = 100'000;

std::vector<Vec3> resampled(const std::vector<Vec3>& loop) {
  std::vector<Vec3> out;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Vec3 &a = loop[i], &b = loop[(i + 1) % loop.size()];
    const double steps = std::clamp(std::round((b - a).norm() / kStep), 1.0, 1000.0);
    for (double k = 0; k < steps; ++k) out.emplace_back(a + (b - a) * (k / steps));
  }
  if (out.size() > kMostPoints) out.resize(kMostPoints);
  return out;
}

/// Adds the middles of edges at which a mesh ends and both ends have the label.
void add_open_edges(const Scan& scan, const std::vector<std::uint8_t>& label, int layer,
                    const std::vector<std::uint8_t>& wanted, std::vector<Vec3>& out) {
  const Mesh& mesh = scan.mesh;
  std::vector<std::uint32_t> near;
  for (std::uint32_t f = 0; f < mesh.triangles.size(); ++f) {
    const Triangle& t = mesh.triangles[f];
    if (wanted[t[0]] || wanted[t[1]] || wanted[t[2]]) near.push_back(f);
  }
  const std::vector<std::uint8_t> flags = border_flags(mesh.triangles, near, mesh.positions.size());
  for (std::size_t i = 0; i < near.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k) {
      const Triangle& t = mesh.triangles[near[i]];
      const std::uint32_t a = t[(k + 1) % 3], b = t[(k + 2) % 3];  // the edge facing corner k
      if ((flags[i] >> (3 + k) & 1U) == 0 || !wanted[a] || !wanted[b]) continue;
      if (label[a] == layer && label[b] == layer)
        out.emplace_back(0.5 * (mesh.positions[a] + mesh.positions[b]));
    }
}

/// Points halfway between neighbours one of which has the label, and where an open mesh ends.
std::vector<Vec3> ends_on_mesh(const Scan& scan, const std::vector<std::uint8_t>& label, int layer,
                               const std::vector<std::uint8_t>& wanted) {
  const std::vector<Vec3>& positions = scan.mesh.positions;
  std::vector<Vec3> out;
  for (const CutLink& link : scan_links(scan, wanted))
    if ((label[link.a] == layer) != (label[link.b] == layer))
      out.emplace_back(0.5 * (positions[link.a] + positions[link.b]));
  add_open_edges(scan, label, layer, wanted, out);
  return out;
}

/// The widest angle at `p` that no neighbour lies in, seen along its normal, radians.
double widest_gap(const Vec3& p, const Vec3& normal, std::span<const Vec3> neighbours) {
  const Vec3 across = normal.unitOrthogonal(), along = normal.cross(across);
  std::vector<double> angles;
  for (const Vec3& q : neighbours)
    if (q != p) angles.push_back(std::atan2((q - p).dot(along), (q - p).dot(across)));
  if (angles.empty()) return 2 * std::numbers::pi;
  std::sort(angles.begin(), angles.end());
  double gap = angles.front() + 2 * std::numbers::pi - angles.back();
  for (std::size_t i = 1; i < angles.size(); ++i) gap = std::max(gap, angles[i] - angles[i - 1]);
  return gap;
}

/// Points of a cloud at which those of the label end: none of them lies in a wide angle.
std::vector<Vec3> ends_in_cloud(const Scan& scan, const std::vector<std::uint8_t>& label, int layer,
                                const std::vector<std::uint8_t>& wanted) {
  std::vector<Vec3> points;
  std::vector<std::uint32_t> vertex;
  for (std::uint32_t v = 0; v < label.size(); ++v)
    if (label[v] == layer) points.push_back(scan.mesh.positions[v]), vertex.push_back(v);
  const PointTree tree(points);
  std::vector<std::uint8_t> ends(points.size(), 0);
  parallel_for(points.size(), kGrain, [&](std::size_t begin, std::size_t end) {
    std::array<PointNeighbour, kRound> near;
    std::array<Vec3, kRound> neighbours;
    for (std::size_t i = begin; i < end; ++i) {
      if (!wanted[vertex[i]]) continue;
      const std::size_t count = tree.nearest(points[i], near);
      for (std::size_t k = 0; k < count; ++k) neighbours[k] = points[near[k].index];
      ends[i] = widest_gap(points[i], scan.mesh.normals[vertex[i]], {neighbours.data(), count}) >
                kEmptyAngle;
    }
  });
  std::vector<Vec3> out;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (ends[i]) out.push_back(points[i]);
  return out;
}

/// Where the label ends near any of the loops.
std::vector<Vec3> ends_of_label(const Scan& scan, const std::vector<std::uint8_t>& label, int layer,
                                const std::vector<Vec3>& loops) {
  const std::vector<Vec3>& positions = scan.mesh.positions;
  std::vector<std::uint8_t> wanted(positions.size(), 0);
  const PointTree near(loops);
  parallel_for(positions.size(), kGrain, [&](std::size_t begin, std::size_t end) {
    PointNeighbour found;
    for (std::size_t v = begin; v < end; ++v)
      wanted[v] = near.nearest(positions[v], {&found, 1}, kReach) > 0;
  });
  return scan.mesh.is_cloud() ? ends_in_cloud(scan, label, layer, wanted)
                              : ends_on_mesh(scan, label, layer, wanted);
}

/// Means of what was found beside each point, smoothed round the loop; where nothing was found
/// within the window they are NaN.
std::vector<Vec3> smoothed(const std::vector<Vec3>& sum, const std::vector<double>& count) {
  const int n = static_cast<int>(sum.size());
  const int window = std::min(kWindow, (n - 1) / 2);
  std::vector<Vec3> out(sum.size());
  for (int i = 0; i < n; ++i) {
    Vec3 mean = Vec3::Zero();
    double weight = 0;
    for (int d = -window; d <= window; ++d) {
      const int j = (i + d + n) % n;
      if (count[j] == 0) continue;
      const double w = std::exp(-0.5 * d * d / (kSmooth * kSmooth));
      mean += w / count[j] * sum[j], weight += w;
    }
    out[i] = mean / weight;
  }
  return out;
}

/// Fills entries that are NaN between their neighbours round the loop.
void bridge(std::vector<Vec3>& offset) {
  const std::size_t n = offset.size();
  std::vector<std::size_t> known;
  for (std::size_t i = 0; i < n; ++i)
    if (!offset[i].hasNaN()) known.push_back(i);
  for (std::size_t k = 0; k < known.size(); ++k) {
    const std::size_t from = known[k], to = known[(k + 1) % known.size()];
    const std::size_t gap = (to + n - from - 1) % n + 1;
    for (std::size_t i = 1; i < gap; ++i) {
      const double share = static_cast<double>(i) / static_cast<double>(gap);
      offset[(from + i) % n] = (1 - share) * offset[from] + share * offset[to];
    }
  }
}

/// Moves a closed line to the ends of the label within `reach` of it. Returns the share of its
/// points beside which there is one; 0 leaves it as it is.
double move_to(const std::vector<Vec3>& found, double reach, std::vector<Vec3>& line) {
  const PointTree tree(line);
  std::vector<Vec3> sum(line.size(), Vec3::Zero());
  std::vector<double> count(line.size(), 0.0);
  for (const Vec3& p : found) {
    PointNeighbour nearest;
    if (tree.nearest(p, {&nearest, 1}, reach) == 0) continue;
    sum[nearest.index] += p - line[nearest.index];
    count[nearest.index] += 1;
  }
  std::vector<Vec3> offset = smoothed(sum, count);
  const auto shown =
      std::count_if(offset.begin(), offset.end(), [](const Vec3& o) { return !o.hasNaN(); });
  if (shown == 0) return 0;
  bridge(offset);
  for (std::size_t i = 0; i < line.size(); ++i) line[i] += offset[i];
  return static_cast<double>(shown) / static_cast<double>(line.size());
}

}  // namespace

std::vector<BorderLine> border_lines(const Scan& scan, const std::vector<std::uint8_t>& label,
                                     int layer, const Pattern& pattern,
                                     const std::vector<Vec3>& draped) {
  if (label.size() != scan.mesh.positions.size() || scan.mesh.normals.size() != label.size() ||
      draped.size() != pattern.flat.size())
    throw InvalidInput(
        "border_lines: one label and normal per scan vertex, one position per pattern vertex");
  std::vector<BorderLine> lines;
  std::vector<Vec3> loops;
  for (const PatternEdge& edge : pattern.edges) {
    std::vector<Vec3> loop;
    for (const int v : edge.vertices) loop.push_back(draped[v]);
    lines.push_back({edge.name, resampled(loop), 0});
    loops.insert(loops.end(), lines.back().points.begin(), lines.back().points.end());
  }
  const std::vector<Vec3> found = ends_of_label(scan, label, layer, loops);
  for (BorderLine& line : lines) {
    line.shown = move_to(found, kReach, line.points);
    if (line.shown == 0) continue;
    line.points = resampled(line.points);
    line.shown = move_to(found, kNearAgain, line.points);
  }
  std::erase_if(lines, [](const BorderLine& line) { return line.shown == 0; });
  return lines;
}

}  // namespace regarment
