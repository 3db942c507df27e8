#include "scan/footprint.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>

namespace regarment {
namespace {

using Cell = std::array<std::int64_t, 2>;

double cross(const Vec2& a, const Vec2& b, const Vec2& c) {
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

Cell cell_of(const Vec2& p, double size) {
  return {static_cast<std::int64_t>(std::floor(p.x() / size)),
          static_cast<std::int64_t>(std::floor(p.y() / size))};
}

bool inside(const std::vector<Vec2>& hull, const Vec2& p) {
  if (hull.size() < 3) return false;
  for (std::size_t i = 0; i < hull.size(); ++i) {
    if (cross(hull[i], hull[(i + 1) % hull.size()], p) < 0) return false;
  }
  return true;
}

/// Points by cell of a grid, and which group a cell belongs to.
struct Groups {
  std::map<Cell, std::vector<Vec2>> cells;
  std::map<Cell, std::size_t> group;
  std::vector<std::vector<Vec2>> members;
};

template <typename Visit>
void for_cells_round(const Cell& cell, Visit visit) {
  for (std::int64_t x = -1; x <= 1; ++x) {
    for (std::int64_t y = -1; y <= 1; ++y) visit(Cell{cell[0] + x, cell[1] + y});
  }
}

Groups group_points(std::span<const Vec2> points, double reach) {
  Groups groups;
  for (const Vec2& p : points) groups.cells[cell_of(p, reach)].push_back(p);
  std::vector<Cell> open;
  for (const auto& [start, unused] : groups.cells) {
    if (groups.group.contains(start)) continue;
    const std::size_t number = groups.members.size();
    groups.members.emplace_back();
    groups.group[start] = number;
    open.assign(1, start);
    while (!open.empty()) {
      const Cell at = open.back();
      open.pop_back();
      const std::vector<Vec2>& here = groups.cells[at];
      groups.members[number].insert(groups.members[number].end(), here.begin(), here.end());
      for_cells_round(at, [&](const Cell& next) {
        if (!groups.cells.contains(next) || groups.group.contains(next)) return;
        groups.group[next] = number;
        open.push_back(next);
      });
    }
  }
  return groups;
}

}  // namespace

std::vector<Vec2> convex_hull(std::vector<Vec2> points) {
  const auto before = [](const Vec2& a, const Vec2& b) {
    return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y();
  };
  std::sort(points.begin(), points.end(), before);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 3) return points;
  std::vector<Vec2> hull;
  // The lower chain from left to right, then the upper one back.
  for (int chain = 0; chain < 2; ++chain) {
    const std::size_t start = hull.size();
    for (const Vec2& p : points) {
      while (hull.size() >= start + 2 && cross(hull[hull.size() - 2], hull.back(), p) <= 0) {
        hull.pop_back();
      }
      hull.push_back(p);
    }
    hull.pop_back();
    std::reverse(points.begin(), points.end());
  }
  return hull;
}

std::size_t outside_of_hulls(std::span<const Vec2> points, std::span<const Vec2> standing,
                             double reach) {
  Groups groups = group_points(standing, reach);
  std::vector<std::vector<Vec2>> hulls;
  for (std::vector<Vec2>& members : groups.members) hulls.push_back(convex_hull(members));
  std::size_t outside = 0;
  for (const Vec2& p : points) {
    bool near = false;
    for_cells_round(cell_of(p, reach),
                    [&](const Cell& cell) { near = near || groups.cells.contains(cell); });
    const bool covered = near || std::any_of(hulls.begin(), hulls.end(),
                                             [&](const auto& hull) { return inside(hull, p); });
    outside += covered ? 0 : 1;
  }
  return outside;
}

}  // namespace regarment
