#include "synthetic/slice_loops.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace regarment {
namespace {

using Edge = std::pair<std::uint32_t, std::uint32_t>;  // lower index first

struct Cut {
  Edge from, to;  // edges of the triangle that the plane enters and leaves through
};

Edge edge_of(std::uint32_t a, std::uint32_t b) { return {std::min(a, b), std::max(a, b)}; }

// Seen along the triangle's winding, the piece runs from where an edge goes down to where one goes
// up, so that pieces of neighbours follow each other.
bool cut_triangle(const Mesh& mesh, const Triangle& t, double height, Cut& cut) {
  bool down = false, up = false;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::uint32_t a = t[k], b = t[(k + 1) % 3];
    const bool above_a = mesh.positions[a].y() >= height, above_b = mesh.positions[b].y() >= height;
    if (above_a && !above_b) cut.from = edge_of(a, b), down = true;
    if (!above_a && above_b) cut.to = edge_of(a, b), up = true;
  }
  return down && up;
}

Vec2 crossing(const Mesh& mesh, const Edge& edge, double height) {
  const Vec3& a = mesh.positions[edge.first];
  const Vec3& b = mesh.positions[edge.second];
  const Vec3 p = a + (b - a) * ((height - a.y()) / (b.y() - a.y()));
  return {p.x(), p.z()};
}

double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

// Fills what follows from the points. False when they enclose nothing.
bool finish(Loop& loop) {
  if (loop.points.size() < 3) return false;
  const Vec2 origin = loop.points.front();
  loop.low = loop.high = origin;
  Vec2 moment = Vec2::Zero();
  double twice = 0;
  for (std::size_t i = 0; i < loop.points.size(); ++i) {
    const Vec2 a = loop.points[i] - origin;
    const Vec2 b = loop.points[(i + 1) % loop.points.size()] - origin;
    twice += cross(a, b);
    moment += cross(a, b) * (a + b);
    loop.low = loop.low.cwiseMin(loop.points[i]);
    loop.high = loop.high.cwiseMax(loop.points[i]);
  }
  if (twice == 0) return false;
  loop.centre = origin + moment / (3 * twice);
  loop.area = std::abs(twice) / 2;
  return true;
}

}  // namespace

std::vector<Loop> slice_loops(const Mesh& mesh, double height) {
  std::map<Edge, Edge> next;
  for (const Triangle& t : mesh.triangles) {
    Cut cut;
    if (cut_triangle(mesh, t, height, cut)) next[cut.from] = cut.to;
  }
  std::vector<Loop> out;
  while (!next.empty()) {
    const Edge first = next.begin()->first;
    Loop loop;
    Edge at = first;
    for (auto step = next.find(at); step != next.end(); step = next.find(at)) {
      loop.points.push_back(crossing(mesh, at, height));
      at = step->second;
      next.erase(step);
    }
    if (at == first && finish(loop)) out.push_back(std::move(loop));
  }
  return out;
}

double hull_perimeter(std::vector<Vec2> points) {
  if (points.empty()) return 0;
  std::sort(points.begin(), points.end(), [](const Vec2& a, const Vec2& b) {
    return std::pair(a.x(), a.y()) < std::pair(b.x(), b.y());
  });
  // Andrew's monotone chain: the lower side, then the upper one.
  std::vector<Vec2> hull;
  const auto add = [&](const Vec2& p, std::size_t least) {
    while (hull.size() > least &&
           cross(hull.back() - hull[hull.size() - 2], p - hull.back()) <= 0) {
      hull.pop_back();
    }
    hull.push_back(p);
  };
  for (const Vec2& p : points) add(p, 1);
  const std::size_t turn = hull.size();
  for (auto p = points.rbegin() + 1; p != points.rend(); ++p) add(*p, turn);
  double sum = 0;
  for (std::size_t i = 0; i + 1 < hull.size(); ++i) sum += (hull[i + 1] - hull[i]).norm();
  return sum;
}

}  // namespace regarment
