#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "geometry/mesh.h"
#include "render/camera.h"

namespace regarment::test {

/// Triangles of a mesh in the pixels of a camera: what a picture must show, found triangle by
/// triangle in double precision.
class FlatTriangles {
 public:
  FlatTriangles(const Mesh& mesh, const Camera& camera) : triangles_(mesh.triangles) {
    for (const Vec3& p : mesh.positions) pixels_.push_back(camera.pixel_from_body(p));
  }

  struct Hit {
    int triangle = -1;  // the nearest, -1 none
    double depth = std::numeric_limits<double>::infinity();
    double next_depth = std::numeric_limits<double>::infinity();  // of the second nearest
    double to_edge = std::numeric_limits<double>::infinity();     // pixels, to any triangle's edge
  };

  Hit at(const Vec2& point) const {
    Hit hit;
    for (std::size_t t = 0; t < triangles_.size(); ++t) {
      const Vec3 &a = pixels_[triangles_[t][0]], &b = pixels_[triangles_[t][1]],
                 &c = pixels_[triangles_[t][2]];
      hit.to_edge = std::min(
          {hit.to_edge, distance(point, a, b), distance(point, b, c), distance(point, c, a)});
      const double wa = area(point, b, c), wb = area(a, point, c), wc = area(a, b, point);
      const bool inside = (wa > 0 && wb > 0 && wc > 0) || (wa < 0 && wb < 0 && wc < 0);
      if (!inside) continue;
      const double depth = (wa * a.z() + wb * b.z() + wc * c.z()) / (wa + wb + wc);
      if (depth < hit.depth) {
        hit.next_depth = hit.depth;
        hit.depth = depth;
        hit.triangle = int(t);
      } else {
        hit.next_depth = std::min(hit.next_depth, depth);
      }
    }
    return hit;
  }

 private:
  template <typename A, typename B, typename C>
  static double area(const A& a, const B& b, const C& c) {
    return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
  }
  static double distance(const Vec2& p, const Vec3& a, const Vec3& b) {
    const Vec2 from = a.head<2>(), along = b.head<2>() - from;
    const double share =
        std::clamp((p - from).dot(along) / std::max(along.squaredNorm(), 1e-300), 0.0, 1.0);
    return (p - from - share * along).norm();
  }

  const std::vector<Triangle>& triangles_;
  std::vector<Vec3> pixels_;
};

}  // namespace regarment::test
