#include "joint/worn_lines.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "garment/drawn_line.h"
#include "garment/particles.h"
#include "garment/plane.h"
#include "garment/template_data.h"
#include "garment/worn_normals.h"

namespace regarment {
namespace {

constexpr double kStep = 0.006;  // m between points of a line
constexpr double kOutside =
    -0.02;  // share of a triangle's height that a line may leave its panel by
constexpr double kMostArc = 1.25;

/// One panel of a worn pattern.
class WornPanel {
 public:
  WornPanel(const Pattern& pattern, const std::vector<Vec3>& positions,
            const std::vector<Vec3>& normals, int panel)
      : pattern_(pattern), positions_(positions), normals_(normals) {
    for (const Triangle& t : pattern.triangles)
      if (pattern.panel[t[0]] == panel) triangles_.push_back(t);
  }

  /// Where a flat point lies; nothing when it is not on the panel.
  std::optional<Vec3> at(const Vec2& p) const {
    double best = kOutside;
    std::optional<Vec3> out;
    for (const Triangle& t : triangles_) {
      const Vec3 share =
          barycentric(pattern_.flat[t[0]], pattern_.flat[t[1]], pattern_.flat[t[2]], p);
      if (!(share.minCoeff() > best)) continue;
      best = share.minCoeff();
      out = curved(t, share);
      if (best >= 0) break;
    }
    return out;
  }

  /// Worn length of a straight line of the flat panel; nothing when it leaves the panel.
  std::optional<double> length(const Vec2& from, const Vec2& to) const {
    const int parts = std::max(2, static_cast<int>(std::lround((to - from).norm() / kStep)));
    double sum = 0;
    std::optional<Vec3> last;
    for (int i = 0; i <= parts; ++i) {
      const auto here = at(from + static_cast<double>(i) / parts * (to - from));
      if (!here) return std::nullopt;
      if (last) sum += (*here - *last).norm();
      last = here;
    }
    return sum;
  }

 private:
  /// A point of a triangle, bulged by the normals at its corners [Boubekeur and Alexa 2008, "Phong
  /// tessellation"]; half of it makes arcs of circles out of chords.
  Vec3 curved(const Triangle& t, const Vec3& share) const {
    Vec3 plane = Vec3::Zero(), bulged = Vec3::Zero();
    for (int k = 0; k < 3; ++k) plane += share[k] * positions_[t[k]];
    for (int k = 0; k < 3; ++k) {
      const Vec3& normal = normals_[pattern_.particle[t[k]]];
      bulged += share[k] * (plane - normal.dot(plane - positions_[t[k]]) * normal);
    }
    return 0.5 * (plane + bulged);
  }

  const Pattern& pattern_;
  const std::vector<Vec3>&positions_, &normals_;
  std::vector<Triangle> triangles_;
};

}  // namespace

double arc_over_chord(const Vec3& chord, const Vec3& normal_a, const Vec3& normal_b) {
  const double length = chord.norm();
  if (length < 1e-9 || normal_a.isZero() || normal_b.isZero()) return 1;
  const Vec3 along = chord / length;
  const Vec3 up = normal_a + normal_b - along.dot(normal_a + normal_b) * along;
  if (up.norm() < 1e-6) return 1;
  const Vec3 over = up.normalized();
  const double a = std::atan2(normal_a.dot(along), normal_a.dot(over));
  const double b = std::atan2(normal_b.dot(along), normal_b.dot(over));
  const double half = std::abs(b - a) / 2;
  if (half < 1e-6) return 1;
  if (!(half < 1.2)) return kMostArc;
  return std::min(kMostArc, half / std::sin(half));
}

std::map<std::string, double> worn_lines(const GarmentTemplate& garment,
                                         const Dimensions& dimensions, const Pattern& pattern,
                                         const std::vector<Vec3>& positions) {
  const std::vector<Vec3> normals = worn_normals(pattern, particle_positions(pattern, positions));
  std::vector<WornPanel> panels;
  for (std::size_t p = 0; p < pattern.panel_names.size(); ++p)
    panels.emplace_back(pattern, positions, normals, static_cast<int>(p));
  std::map<std::string, double> out;
  for (const MeasureArrow& arrow : garment.data().arrows) {
    double sum = 0, count = 0;
    for (const DrawnLine& line : drawn_lines(garment, dimensions, pattern, arrow.dimension)) {
      const auto length = panels[static_cast<std::size_t>(line.panel)].length(line.from, line.to);
      if (length) sum += *length, count += 1;
    }
    if (count > 0) out[arrow.dimension] = sum / count / arrow.share;
  }
  return out;
}

}  // namespace regarment
