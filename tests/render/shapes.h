#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>
#include <vector>

#include "geometry/mesh.h"

namespace regarment::test {

/// Box from `low` to `high`, 12 triangles, outward.
inline Mesh box_mesh(const Vec3& low, const Vec3& high) {
  Mesh mesh;
  for (int corner = 0; corner < 8; ++corner) {
    mesh.positions.emplace_back((corner & 1) != 0 ? high.x() : low.x(),
                                (corner & 2) != 0 ? high.y() : low.y(),
                                (corner & 4) != 0 ? high.z() : low.z());
  }
  mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                    {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return mesh;
}

/// Ellipsoid of `rings` x 2 `rings` quads, outward; `radii` along the axes.
inline Mesh ellipsoid_mesh(const Vec3& centre, const Vec3& radii, int rings) {
  Mesh mesh;
  const int around = 2 * rings;
  for (int i = 0; i <= rings; ++i) {
    const double polar = std::numbers::pi * i / rings;
    for (int j = 0; j < around; ++j) {
      const double turn = std::numbers::pi * j / rings;
      const Vec3 unit(std::sin(polar) * std::sin(turn), std::cos(polar),
                      std::sin(polar) * std::cos(turn));
      mesh.positions.push_back(centre + radii.cwiseProduct(unit));
      mesh.normals.push_back(radii.cwiseInverse().cwiseProduct(unit).normalized());
    }
  }
  const auto vertex = [&](int i, int j) { return std::uint32_t(i * around + j % around); };
  for (int i = 0; i < rings; ++i) {
    for (int j = 0; j < around; ++j) {
      if (i > 0) mesh.triangles.push_back({vertex(i, j), vertex(i + 1, j), vertex(i, j + 1)});
      if (i + 1 < rings) {
        mesh.triangles.push_back({vertex(i, j + 1), vertex(i + 1, j), vertex(i + 1, j + 1)});
      }
    }
  }
  return mesh;
}

inline Mesh sphere_mesh(double radius, int rings) {
  return ellipsoid_mesh(Vec3::Zero(), Vec3::Constant(radius), rings);
}

/// Points spread at random over a sphere, with outward normals.
inline Mesh sphere_cloud(double radius, int count, unsigned seed) {
  std::mt19937 random(seed);
  const auto uniform = [&] { return (double(random()) + 0.5) / 4294967296.0; };
  Mesh cloud;
  for (int i = 0; i < count; ++i) {
    const double y = 2.0 * uniform() - 1.0, turn = 2.0 * std::numbers::pi * uniform();
    const double ring = std::sqrt(1.0 - y * y);
    cloud.normals.emplace_back(ring * std::sin(turn), y, ring * std::cos(turn));
    cloud.positions.push_back(radius * cloud.normals.back());
  }
  return cloud;
}

/// Triangles with corners anywhere in a cube of side 2 about the origin.
inline Mesh random_triangles(int count, unsigned seed) {
  std::mt19937 random(seed);
  const auto uniform = [&] { return 2.0 * (double(random()) + 0.5) / 4294967296.0 - 1.0; };
  Mesh mesh;
  for (int i = 0; i < 3 * count; ++i) {
    const double x = uniform(), y = uniform(), z = uniform();
    mesh.positions.emplace_back(x, y, z);
  }
  for (std::uint32_t t = 0; t < std::uint32_t(count); ++t) {
    mesh.triangles.push_back({3 * t, 3 * t + 1, 3 * t + 2});
  }
  return mesh;
}

inline void append(Mesh& mesh, const Mesh& other) {
  const auto shift = std::uint32_t(mesh.positions.size());
  mesh.positions.insert(mesh.positions.end(), other.positions.begin(), other.positions.end());
  mesh.normals.insert(mesh.normals.end(), other.normals.begin(), other.normals.end());
  for (const Triangle& t : other.triangles) {
    mesh.triangles.push_back({t[0] + shift, t[1] + shift, t[2] + shift});
  }
}

/// A figure of ellipsoids, 1.7 m high, floor at 0: legs, body, head, arms.
inline Mesh mannequin() {
  Mesh mesh = ellipsoid_mesh({0, 1.12, 0}, {0.19, 0.36, 0.13}, 24);
  append(mesh, ellipsoid_mesh({0, 1.57, 0.02}, {0.085, 0.13, 0.1}, 16));
  for (const double side : {-1.0, 1.0}) {
    append(mesh, ellipsoid_mesh({0.1 * side, 0.44, 0}, {0.075, 0.44, 0.08}, 20));
    append(mesh, ellipsoid_mesh({0.31 * side, 1.1, 0.03}, {0.05, 0.3, 0.05}, 16));
  }
  return mesh;
}

/// An open cone about the y axis from height `top` to `bottom`, outward.
inline Mesh skirt_mesh(double top, double bottom, double top_radius, double bottom_radius) {
  constexpr int kAround = 36, kDown = 10;
  Mesh mesh;
  for (int i = 0; i <= kDown; ++i) {
    const double f = double(i) / kDown;
    const double radius = top_radius + f * (bottom_radius - top_radius);
    for (int j = 0; j < kAround; ++j) {
      const double turn = 2.0 * std::numbers::pi * j / kAround;
      mesh.positions.emplace_back(radius * std::sin(turn), top + f * (bottom - top),
                                  radius * std::cos(turn));
    }
  }
  const auto vertex = [&](int i, int j) { return std::uint32_t(i * kAround + j % kAround); };
  for (int i = 0; i < kDown; ++i) {
    for (int j = 0; j < kAround; ++j) {
      mesh.triangles.push_back({vertex(i, j), vertex(i + 1, j), vertex(i, j + 1)});
      mesh.triangles.push_back({vertex(i, j + 1), vertex(i + 1, j), vertex(i + 1, j + 1)});
    }
  }
  return mesh;
}

}  // namespace regarment::test
