#include "synthetic/put_on.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "base/error.h"

namespace regarment {
namespace {

constexpr double kRow = 0.01;        // m, height of a row and width of a column
constexpr double kReach = 0.015;     // m above and below a row that count with it
constexpr double kGap = 0.04;        // m without surface that end the trunk, going outwards
constexpr double kNeck = 0.095;      // m from the middle, further in a garment does not lie on top
constexpr double kShoulder = 0.135;  // m from the middle, further out there is no head
constexpr double kRise = 0.06;       // m the shoulder rises from there to the neck at most
constexpr double kBelowArm = 0.08;   // m below the underarm the arms are clear of the trunk
constexpr double kPace = 0.012;      // m between points taken from a surface

int bin(double value) { return static_cast<int>(std::floor(value / kRow)); }

/// The convex outline of all that stands at one height, seen from above.
struct Row {
  std::vector<Vec2> points;       // x, z
  std::vector<Vec2> front, back;  // ends of its pieces, by ascending x
  double reach = 0.0;             // m, of the trunk to either side of the middle

  bool present() const { return front.size() >= 2; }
  /// z of the front (sign 1) or back (-1) at x; beyond the ends, of the end.
  double z(double x, double sign) const;
};

double Row::z(double x, double sign) const {
  const std::vector<Vec2>& line = sign > 0 ? front : back;
  if (x <= line.front().x()) return line.front().y();
  if (x >= line.back().x()) return line.back().y();
  std::size_t i = 1;
  while (line[i].x() < x) ++i;
  const double u = (x - line[i - 1].x()) / std::max(1e-12, line[i].x() - line[i - 1].x());
  return line[i - 1].y() + u * (line[i].y() - line[i - 1].y());
}

/// The half of a convex hull that bulges towards `sign` z, of points sorted by x.
std::vector<Vec2> half_hull(const std::vector<Vec2>& points, double sign) {
  std::vector<Vec2> out;
  for (const Vec2& p : points) {
    while (out.size() >= 2) {
      const Vec2 a = out.back() - out[out.size() - 2], b = p - out[out.size() - 2];
      if (sign * (a.x() * b.y() - a.y() * b.x()) < 0) break;
      out.pop_back();
    }
    out.push_back(p);
  }
  return out;
}

/// How far surface goes on without a gap from the middle, to the side that goes further.
double trunk_reach(const std::vector<Vec2>& sorted) {
  double reach = 0;
  for (const double side : {1.0, -1.0}) {
    std::vector<double> at;
    for (const Vec2& p : sorted)
      if (side * p.x() >= 0) at.push_back(side * p.x());
    std::sort(at.begin(), at.end());
    double end = 0.1;  // legs apart leave the middle free
    for (const double x : at) {
      if (x > end + kGap) break;
      end = std::max(end, x);
    }
    reach = std::max(reach, end);
  }
  return reach;
}

class Outlines {
 public:
  explicit Outlines(const std::vector<const Mesh*>& surfaces) {
    for (const Mesh* mesh : surfaces)
      for (const Triangle& t : mesh->triangles)
        add(mesh->positions[t[0]], mesh->positions[t[1]], mesh->positions[t[2]]);
    for (auto& [index, row] : rows_) {
      std::sort(row.points.begin(), row.points.end(), [](const Vec2& a, const Vec2& b) {
        return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y());
      });
      row.front = half_hull(row.points, 1);
      row.back = half_hull(row.points, -1);
      row.reach = trunk_reach(row.points);
    }
  }

  /// The row at a height, or the nearest one; nullptr without any surface.
  const Row* at(double y) const {
    const auto above = rows_.lower_bound(bin(y));
    if (above == rows_.end()) return rows_.empty() ? nullptr : &rows_.rbegin()->second;
    return &above->second;
  }
  /// Greatest height at x, or nothing there: -1. The head, which may be wider than a neckline, does
  /// not count: a garment is put on behind and before it.
  double top(double x) const {
    const auto it = heights_.find(bin(x));
    if (it == heights_.end()) return -1.0;
    const double side = std::copysign(kShoulder, x);
    const double most =
        std::abs(x) < kShoulder ? top(side) + kRise : std::numeric_limits<double>::infinity();
    double highest = -1.0;
    for (const double y : it->second)
      if (y <= most) highest = std::max(highest, y);
    return highest;
  }

 private:
  void add(const Vec3& a, const Vec3& b, const Vec3& c) {
    const double longest = std::max({(b - a).norm(), (c - b).norm(), (a - c).norm()});
    const int n = 1 + static_cast<int>(longest / kPace);
    for (int i = 0; i <= n; ++i)
      for (int j = 0; i + j <= n; ++j) add(a + (b - a) * i / n + (c - a) * j / n);
  }
  void add(const Vec3& p) {
    for (int k = bin(p.y() - kReach); k <= bin(p.y() + kReach); ++k)
      rows_[k].points.emplace_back(p.x(), p.z());
    heights_[bin(p.x())].push_back(p.y());
  }
  std::map<int, Row> rows_;
  std::map<int, std::vector<double>> heights_;  // by column
};

bool has_sleeves(const Pattern& pattern) {
  return std::any_of(pattern.panel_limbs.begin(), pattern.panel_limbs.end(),
                     [](const std::string& limb) { return limb != "torso"; });
}

/// Calls `visit` with panel and place of points along the sides of all triangles.
template <typename Visit>
void for_points(const Pattern& pattern, Visit visit) {
  for (const Triangle& t : pattern.triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec2 &a = pattern.flat[t[k]], &b = pattern.flat[t[(k + 1) % 3]];
      const int n = 1 + static_cast<int>(2 * (b - a).norm() / kRow);
      for (int i = 0; i <= n; ++i) visit(pattern.panel[t[k]], Vec2(a + (b - a) * i / n));
    }
}

/// Height of t = 0 at which the upper outline of the garment just clears the body's.
double hanging_height(const Pattern& pattern, const Outlines& outlines, double clearance) {
  std::map<int, double> upper;  // by column: least t
  for_points(pattern, [&](int, const Vec2& p) {
    if (std::abs(p.x()) < kNeck) return;
    const auto [it, fresh] = upper.try_emplace(bin(p.x()), p.y());
    if (!fresh) it->second = std::min(it->second, p.y());
  });
  double height = -1;
  for (const auto& [column, t] : upper) {
    const double top = outlines.top((column + 0.5) * kRow);
    if (top > 0) height = std::max(height, top + t + clearance);
  }
  if (height < 0) throw InvalidInput("put_on: there are no shoulders below the garment");
  return height;
}

/// Greatest t of a particle that a torso panel shares with a sleeve; -inf without sleeves.
double underarm(const Pattern& pattern) {
  std::vector<int> on(static_cast<std::size_t>(pattern.particle_count), 0);
  for (std::size_t v = 0; v < pattern.flat.size(); ++v)
    on[pattern.particle[v]] |= pattern.panel_limbs[pattern.panel[v]] == "torso" ? 1 : 2;
  double t = -std::numeric_limits<double>::infinity();
  for (std::size_t v = 0; v < pattern.flat.size(); ++v)
    if (on[pattern.particle[v]] == 3 && pattern.panel_limbs[pattern.panel[v]] == "torso")
      t = std::max(t, pattern.flat[v].y());
  return t;
}

/// Half width of the torso panels by rows of t.
std::map<int, double> half_widths(const Pattern& pattern) {
  std::map<int, double> out;
  for_points(pattern, [&](int panel, const Vec2& p) {
    if (pattern.panel_limbs[panel] != "torso") return;
    double& w = out[bin(p.y())];
    w = std::max(w, std::abs(p.x()));
  });
  return out;
}

}  // namespace

std::vector<Vec3> put_on(const Pattern& pattern, const std::vector<const Mesh*>& clothed,
                         double top_height, double clearance) {
  const Outlines outlines(clothed);
  if (outlines.at(0) == nullptr) throw InvalidInput("put_on: the body has no surface");
  const bool sleeves = has_sleeves(pattern);
  const double top = sleeves ? hanging_height(pattern, outlines, clearance) : top_height;
  const double clear_of_arms = sleeves ? underarm(pattern) + kBelowArm : -1.0;
  const std::map<int, double> half = half_widths(pattern);
  const auto n = static_cast<std::size_t>(pattern.particle_count);
  std::vector<Vec3> out(n, Vec3::Zero());
  std::vector<double> panels(n, 0.0);
  for (std::size_t v = 0; v < pattern.flat.size(); ++v) {
    const Vec2& p = pattern.flat[v];
    const Row& row = *outlines.at(top - p.y());
    double x = p.x();
    if (pattern.panel_limbs[pattern.panel[v]] == "torso" && p.y() > clear_of_arms) {
      const auto width = half.find(bin(p.y()));
      if (width != half.end() && width->second > 0)
        x *= std::max(1.0, (row.reach + 2 * clearance) / width->second);
    }
    const double sign = pattern.panel_is_front[pattern.panel[v]] ? 1 : -1;
    const bool beside = !row.present() || x < row.front.front().x() - clearance ||
                        x > row.front.back().x() + clearance;
    const double z = (row.present() ? row.z(x, sign) : 0.0) + sign * (beside ? 0.003 : clearance);
    out[pattern.particle[v]] += Vec3(x, top - p.y(), z);
    panels[pattern.particle[v]] += 1;
  }
  for (std::size_t i = 0; i < n; ++i) out[i] /= panels[i];
  return out;
}

}  // namespace regarment
