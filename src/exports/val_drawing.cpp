#include "exports/val_drawing.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "garment/svg_text.h"

namespace regarment {
namespace {

constexpr double kCm = 100.0;            // per metre
constexpr double kSamePlace = 1e-9;      // m
constexpr double kPixels = 96.0 / 2.54;  // per cm: Valentina keeps places on the sheet in pixels

std::string number(double value, int digits) {
  char buffer[64];
  std::snprintf(buffer, sizeof buffer, "%.*f", digits, value);
  return buffer;
}

/// A point that a detail goes through, in order.
struct Node {
  int object = 0;  // of the calculation
  bool is_spline = false, has_notch = false;
};

class ValDrawing {
 public:
  ValDrawing(const CutPiece& piece, std::string prefix, const Vec2& corner, int& next_id)
      : piece_(piece), prefix_(std::move(prefix)), next_id_(next_id) {
    origin_ = piece.edges.front().points.front();
    Vec2 low = origin_;
    for (const Vec2& p : cut_outline(piece)) low = low.cwiseMin(p);
    origin_in_cm_ = corner + kCm * (origin_ - low);
  }

  std::string xml() {
    first_ = add_origin();
    int at = first_;
    for (std::size_t e = 0; e < piece_.edges.size(); ++e) at = add_edge(e, at);
    std::string modeling, nodes;
    for (const Node& node : nodes_) add_node(node, modeling, nodes);
    return "  <draw name=\"" + xml_escaped(piece_.title) + "\">\n    <calculation>\n" +
           calculation_ + "    </calculation>\n    <modeling>\n" + modeling +
           "    </modeling>\n    <details>\n" + detail(nodes) +
           "    </details>\n    <groups/>\n  </draw>\n";
  }

 private:
  std::string next_name() { return prefix_ + std::to_string(++named_); }

  Vec2 in_cm(const Vec2& p) const { return origin_in_cm_ + kCm * (p - origin_); }

  int add_origin() {
    calculation_ += "      <point id=\"" + std::to_string(next_id_) + "\" name=\"" + next_name() +
                    "\" type=\"single\" x=\"" + number(origin_in_cm_.x(), 6) + "\" y=\"" +
                    number(origin_in_cm_.y(), 6) + "\" mx=\"0.15\" my=\"0.3\"/>\n";
    return next_id_++;
  }

  /// A point by its length and angle from the first; angles run counter-clockwise, y up.
  int add_point(const Vec2& p) {
    const Vec2 from_origin = kCm * (p - origin_);
    double angle = std::atan2(-from_origin.y(), from_origin.x()) * 180.0 / std::numbers::pi;
    angle = angle < 0.0 ? angle + 360.0 : std::abs(angle);  // no minus zero
    calculation_ += "      <point id=\"" + std::to_string(next_id_) + "\" name=\"" + next_name() +
                    "\" type=\"endLine\" basePoint=\"" + std::to_string(first_) + "\" length=\"" +
                    number(from_origin.norm(), 6) + "\" angle=\"" + number(angle, 8) +
                    "\" typeLine=\"none\" lineColor=\"black\" mx=\"0.15\" my=\"0.3\"/>\n";
    return next_id_++;
  }

  bool has_notch_at(const Vec2& p) const {
    return std::any_of(piece_.notches.begin(), piece_.notches.end(),
                       [&](const Notch& n) { return (n.at - p).norm() < kSamePlace; });
  }

  /// The notches strictly inside a straight edge, in its order.
  std::vector<Vec2> notches_inside(const CutEdge& edge) const {
    const Vec2 a = edge.points.front(), along = edge.points.back() - a;
    std::vector<Vec2> inside;
    for (const Notch& notch : piece_.notches) {
      const double share = (notch.at - a).dot(along) / along.squaredNorm();
      const double apart = (a + share * along - notch.at).norm();
      if (apart < kSamePlace && share > 1e-6 && share < 1.0 - 1e-6) inside.push_back(notch.at);
    }
    std::sort(inside.begin(), inside.end(), [&](const Vec2& p, const Vec2& q) {
      return (p - a).dot(along) < (q - a).dot(along);
    });
    return inside;
  }

  /// From the object `at` along edge `e`; returns the object at its end.
  int add_edge(std::size_t e, int at) {
    const CutEdge& edge = piece_.edges[e];
    const Vec2 &a = edge.points.front(), &b = edge.points.back();
    nodes_.push_back({at, false, has_notch_at(a)});
    if (edge.controls.empty())
      for (const Vec2& p : notches_inside(edge)) nodes_.push_back({add_point(p), false, true});
    const int end = e + 1 < piece_.edges.size() ? add_point(b) : first_;
    if (!edge.controls.empty()) nodes_.push_back({add_spline(edge, at, end), true, false});
    return end;
  }

  int add_spline(const CutEdge& edge, int at, int end) {
    const Vec2 &a = edge.points.front(), &b = edge.points.back();
    std::array<Vec2, 2> controls;
    if (edge.controls.size() == 1) {
      // The same curve as a cubic.
      controls = {a + 2.0 / 3.0 * (edge.controls[0] - a), b + 2.0 / 3.0 * (edge.controls[0] - b)};
    } else {
      controls = {edge.controls[0], edge.controls[1]};
    }
    const int one = add_point(controls[0]), two = add_point(controls[1]);
    calculation_ += "      <spline id=\"" + std::to_string(next_id_) +
                    "\" type=\"cubicBezier\" point1=\"" + std::to_string(at) + "\" point2=\"" +
                    std::to_string(one) + "\" point3=\"" + std::to_string(two) + "\" point4=\"" +
                    std::to_string(end) + "\" color=\"black\" penStyle=\"hair\"/>\n";
    return next_id_++;
  }

  void add_node(const Node& node, std::string& modeling, std::string& nodes) {
    const std::string id = std::to_string(next_id_++), object = std::to_string(node.object);
    if (node.is_spline) {
      modeling += "      <spline id=\"" + id + "\" idObject=\"" + object +
                  "\" inUse=\"true\" type=\"modelingSpline\"/>\n";
      nodes += "          <node idObject=\"" + id + "\" reverse=\"0\" type=\"NodeSpline\"/>\n";
      return;
    }
    modeling += "      <point id=\"" + id + "\" idObject=\"" + object +
                "\" inUse=\"true\" mx=\"0.15\" my=\"0.3\" type=\"modeling\"/>\n";
    nodes += "          <node idObject=\"" + id + "\" type=\"NodePoint\"" +
             (node.has_notch ? " passmark=\"true\" manualPassmarkLength=\"true\""
                               " passmarkLength=\"0.5\" passmarkLine=\"one\""
                               " passmarkAngle=\"straightforward\""
                             : "") +
             "/>\n";
  }

  /// The grain line by its lower end, its length and its angle.
  std::string grain() const {
    Vec2 from = piece_.grain[0], to = piece_.grain[1];
    if (from.y() < to.y()) std::swap(from, to);
    const Vec2 along = to - from, at = kPixels * in_cm(from);
    const double angle = std::atan2(-along.y(), along.x()) * 180.0 / std::numbers::pi;
    return "        <grainline visible=\"true\" arrows=\"0\" length=\"" +
           number(kCm * along.norm(), 6) + "\" rotation=\"" + number(angle, 6) + "\" mx=\"" +
           number(at.x(), 4) + "\" my=\"" + number(at.y(), 4) + "\"/>\n";
  }

  std::string detail(const std::string& nodes) {
    const std::string id = std::to_string(next_id_++);
    return "      <detail id=\"" + id + "\" name=\"" + xml_escaped(piece_.title) +
           "\" version=\"2\" closed=\"1\" seamAllowance=\"true\" width=\"0\" mx=\"0\" my=\"0\""
           " forbidFlipping=\"true\" forceFlipping=\"false\" hideMainPath=\"false\">\n"
           "        <data letter=\"\" visible=\"false\" quantity=\"1\" onFold=\"false\""
           " annotation=\"no seam allowance\" orientation=\"\" rotationWay=\"\" tilt=\"\""
           " foldPosition=\"\" fontSize=\"0\" width=\"1\" height=\"1\" mx=\"0\" my=\"0\""
           " rotation=\"0\"/>\n"
           "        <patternInfo visible=\"false\" fontSize=\"0\" width=\"1\" height=\"1\""
           " mx=\"0\" my=\"0\" rotation=\"0\"/>\n" +
           grain() + "        <nodes>\n" + nodes + "        </nodes>\n      </detail>\n";
  }

  const CutPiece& piece_;
  std::string prefix_;
  int& next_id_;
  int first_ = 0, named_ = 0;
  Vec2 origin_, origin_in_cm_;
  std::string calculation_;
  std::vector<Node> nodes_;
};

}  // namespace

std::string val_drawing(const CutPiece& piece, const std::string& prefix, const Vec2& corner,
                        int& next_id) {
  return ValDrawing(piece, prefix, corner, next_id).xml();
}

}  // namespace regarment
