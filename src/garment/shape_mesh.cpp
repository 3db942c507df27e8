#include "garment/shape_mesh.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "base/error.h"
#include "garment/plane.h"
#include "garment/triangulate.h"

namespace regarment {

namespace {

const Vec2& at(const std::vector<Vec2>& points, int i) {
  return points[static_cast<std::size_t>(i)];
}

/// Number of parts of a piece of this length.
int parts(double length, double edge_length, int fewest) {
  return std::max(fewest, static_cast<int>(std::lround(length / edge_length)));
}

/// Weights of a point inside a coarse triangle; they sum to 1.
Vec3 weights_in(const std::vector<Vec2>& points, const std::array<int, 3>& triangle,
                const Vec2& p) {
  const Vec2 &a = at(points, triangle[0]), &b = at(points, triangle[1]),
             &c = at(points, triangle[2]);
  const double whole = twice_area(a, b, c);
  const double u = twice_area(p, b, c) / whole;
  const double v = twice_area(a, p, c) / whole;
  return {u, v, 1.0 - u - v};
}

class Builder {
 public:
  explicit Builder(const ShapeFrame& frame) : frame_(frame), points_(frame.points) {
    for (int i = 0; i < frame.outline.points; ++i) add_coarse(i);
    mesh_.on_fold.assign(points_.size(), false);
    for (const int i : frame.outline.fold) mesh_.on_fold[static_cast<std::size_t>(i)] = true;
  }

  /// Divides the segment between two coarse points; returns its vertices, both ends included.
  std::vector<int> divide(int a, int b, int n, bool on_fold) {
    std::vector<int> chain = {a};
    const std::array<int, 3> triangle = triangle_at(a, b);
    for (int k = 1; k < n; ++k) {
      const double share = static_cast<double>(k) / n;
      Vec3 weights = Vec3::Zero();
      for (int corner = 0; corner < 3; ++corner) {
        const int point = triangle[static_cast<std::size_t>(corner)];
        if (point == a) weights[corner] = 1.0 - share;
        if (point == b) weights[corner] = share;
      }
      chain.push_back(static_cast<int>(points_.size()));
      add((1.0 - share) * at(frame_.points, a) + share * at(frame_.points, b), triangle, weights,
          on_fold);
    }
    chain.push_back(b);
    for (std::size_t i = 0; i + 1 < chain.size(); ++i)
      segments_.push_back({chain[i], chain[i + 1]});
    return chain;
  }

  void add_inside(const Vec2& p) {
    double best = -1e300;
    std::array<int, 3> triangle{};
    Vec3 weights = Vec3::Zero();
    for (const auto& candidate : frame_.triangles) {
      const Vec3 w = weights_in(frame_.points, candidate, p);
      if (w.minCoeff() <= best) continue;
      best = w.minCoeff();
      triangle = candidate;
      weights = w;
    }
    add(p, triangle, weights, false);
  }

  ShapeMesh finish(std::vector<std::array<int, 3>> triangles) {
    mesh_.triangles = std::move(triangles);
    return std::move(mesh_);
  }

  /// Sides inside the shape that join two vertices of its outline, each once.
  std::vector<std::array<int, 2>> bridges(const std::vector<std::array<int, 3>>& triangles) const {
    std::set<std::array<int, 2>> outline;
    std::vector<bool> on_outline(points_.size(), false);
    for (const std::vector<int>& edge : mesh_.edges) {
      for (const int v : edge) on_outline[static_cast<std::size_t>(v)] = true;
      for (std::size_t i = 0; i + 1 < edge.size(); ++i)
        outline.insert({std::min(edge[i], edge[i + 1]), std::max(edge[i], edge[i + 1])});
    }
    std::set<std::array<int, 2>> found;
    for (const auto& t : triangles)
      for (std::size_t k = 0; k < 3; ++k) {
        const int a = std::min(t[k], t[(k + 1) % 3]), b = std::max(t[k], t[(k + 1) % 3]);
        if (on_outline[static_cast<std::size_t>(a)] && on_outline[static_cast<std::size_t>(b)] &&
            !outline.contains({a, b}))
          found.insert({a, b});
      }
    return {found.begin(), found.end()};
  }

  const std::vector<Vec2>& points() const { return points_; }
  const std::vector<std::array<int, 2>>& segments() const { return segments_; }
  std::vector<std::vector<int>>& edges() { return mesh_.edges; }

 private:
  std::array<int, 3> triangle_at(int a, int b) const {
    for (const auto& triangle : frame_.triangles) {
      const auto has = [&](int i) {
        return std::find(triangle.begin(), triangle.end(), i) != triangle.end();
      };
      if (has(a) && has(b)) return triangle;
    }
    throw InvalidInput("a segment of a panel is no edge of its coarse triangulation");
  }

  void add_coarse(int i) {
    for (const auto& triangle : frame_.triangles) {
      const auto corner = std::find(triangle.begin(), triangle.end(), i);
      if (corner == triangle.end()) continue;
      mesh_.coarse.push_back(triangle);
      mesh_.weights.push_back(Vec3::Unit(corner - triangle.begin()));
      return;
    }
    throw InvalidInput("a coarse point of a panel is in no coarse triangle");
  }

  void add(const Vec2& p, const std::array<int, 3>& triangle, const Vec3& weights, bool on_fold) {
    points_.push_back(p);
    mesh_.coarse.push_back(triangle);
    mesh_.weights.push_back(weights);
    mesh_.on_fold.push_back(on_fold);
  }

  const ShapeFrame& frame_;
  std::vector<Vec2> points_;  // of the mesh's vertices, at typical dimensions
  std::vector<std::array<int, 2>> segments_;
  ShapeMesh mesh_;
};

void divide_inner(Builder& builder, const ShapeFrame& frame, double edge_length) {
  const auto divide = [&](int a, int b, bool on_fold) {
    const double length = (at(frame.points, a) - at(frame.points, b)).norm();
    builder.divide(a, b, parts(length, edge_length, 2), on_fold);
  };
  for (std::size_t i = 0; i + 1 < frame.outline.fold.size(); ++i)
    divide(frame.outline.fold[i], frame.outline.fold[i + 1], true);
  for (const auto& line : frame.outline.lines) divide(line[0], line[1], false);
}

void divide_edges(Builder& builder, const ShapeFrame& frame, const Divisions& divisions) {
  for (std::size_t e = 0; e < frame.outline.edges.size(); ++e) {
    const std::vector<int>& pieces = frame.outline.edges[e];
    std::vector<int> chain = {pieces.front()};
    for (std::size_t k = 0; k + 1 < pieces.size(); ++k) {
      const auto part = builder.divide(pieces[k], pieces[k + 1], divisions[e][k], false);
      chain.insert(chain.end(), part.begin() + 1, part.end());
    }
    builder.edges().push_back(std::move(chain));
  }
}

}  // namespace

Divisions divisions_for(const ShapeFrame& frame, double edge_length) {
  Divisions divisions;
  for (const std::vector<int>& edge : frame.outline.edges) {
    std::vector<int> pieces;
    for (std::size_t k = 0; k + 1 < edge.size(); ++k) {
      const double length = (at(frame.points, edge[k]) - at(frame.points, edge[k + 1])).norm();
      pieces.push_back(parts(length, edge_length, edge.size() == 2 ? 2 : 1));
    }
    divisions.push_back(std::move(pieces));
  }
  return divisions;
}

ShapeMesh fine_mesh(const ShapeFrame& frame, const Divisions& divisions, double edge_length) {
  Builder builder(frame);
  divide_edges(builder, frame, divisions);
  divide_inner(builder, frame, edge_length);
  const auto inside = refinement_points(builder.points(), builder.segments(), edge_length);
  for (const Vec2& p : inside) builder.add_inside(p);
  // Every round cuts the sides that run from outline to outline; new ones are rare and shorter.
  std::vector<std::array<int, 3>> triangles = triangulate(builder.points(), builder.segments());
  for (auto bridges = builder.bridges(triangles); !bridges.empty();
       bridges = builder.bridges(triangles)) {
    for (const auto& bridge : bridges) {
      builder.add_inside((at(builder.points(), bridge[0]) + at(builder.points(), bridge[1])) / 2.0);
    }
    triangles = triangulate(builder.points(), builder.segments());
  }
  return builder.finish(std::move(triangles));
}

}  // namespace regarment
