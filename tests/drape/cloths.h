#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>
#include <vector>

#include "drape/cloth.h"
#include "support/dice.h"

namespace regarment::test {

/// Cloth of these triangles, its rest shape being `flat` (one point per particle, any surface).
inline Cloth make_test_cloth(const std::vector<Vec3>& flat, const std::vector<Triangle>& triangles,
                             double mass = 1e-4) {
  Cloth cloth;
  cloth.positions = flat;
  cloth.velocities.assign(flat.size(), Vec3::Zero());
  cloth.masses.assign(flat.size(), mass);
  cloth.triangles = triangles;
  // Each directed side with the corner on its left and its triangle.
  std::map<std::pair<int, int>, std::pair<int, int>> sides;
  for (std::size_t f = 0; f < triangles.size(); ++f)
    for (std::size_t k = 0; k < 3; ++k) {
      const auto corner = [&](std::size_t c) { return static_cast<int>(triangles[f][c % 3]); };
      sides[{corner(k), corner(k + 1)}] = {corner(k + 2), static_cast<int>(f)};
    }
  std::map<std::pair<int, int>, int> spring_of;
  for (const auto& [side, left] : sides) spring_of[std::minmax(side.first, side.second)] = 0;
  for (auto& [ends, index] : spring_of) {
    index = static_cast<int>(cloth.springs.size());
    const double length = (flat[ends.first] - flat[ends.second]).norm();
    cloth.springs.push_back({ends.first, ends.second, ends.first, ends.second, length});
  }
  for (const auto& [side, left] : sides) {
    const auto other = sides.find({side.second, side.first});
    if (side.first > side.second || other == sides.end()) continue;
    BendingElement e;
    e.particles = {left.first, other->second.first, side.first, side.second};
    e.triangles = {left.second, other->second.second};
    e.spring = spring_of.at(side);
    const Vec3 &a = flat[side.first], &b = flat[side.second];
    e.rest_side = (b - a).norm();
    e.rest_normals = {(a - flat[left.first]).cross(b - flat[left.first]).norm(),
                      (a - flat[other->second.first]).cross(b - flat[other->second.first]).norm()};
    cloth.bending.push_back(e);
  }
  return cloth;
}

/// Two particles on the x axis, joined by one spring.
inline Cloth two_particles(double distance, double rest_length) {
  Cloth cloth;
  cloth.positions = {Vec3(0, 0, 0), Vec3(distance, 0, 0)};
  cloth.velocities.assign(2, Vec3::Zero());
  cloth.masses = {1e-4, 1e-4};
  cloth.springs = {{0, 1, 0, 1, rest_length}};
  return cloth;
}

inline Cloth one_particle(const Vec3& position) {
  Cloth cloth;
  cloth.positions = {position};
  cloth.velocities = {Vec3::Zero()};
  cloth.masses = {1e-4};
  return cloth;
}

/// A square of cells x cells, `side` metres long, about the origin in the plane y = 0; its outer
/// side is up.
inline Cloth flat_patch(int cells, double side) {
  std::vector<Vec3> flat;
  std::vector<Triangle> triangles;
  const auto at = [&](int i, int j) { return static_cast<std::uint32_t>(i * (cells + 1) + j); };
  for (int i = 0; i <= cells; ++i)
    for (int j = 0; j <= cells; ++j)
      flat.emplace_back(side * (1.0 * i / cells - 0.5), 0, side * (1.0 * j / cells - 0.5));
  for (int i = 0; i < cells; ++i)
    for (int j = 0; j < cells; ++j) {
      // Diagonals alternate, so that the patch is its own mirror image when `cells` is even.
      if ((i + j) % 2 == 0) {
        triangles.push_back({at(i, j), at(i, j + 1), at(i + 1, j + 1)});
        triangles.push_back({at(i, j), at(i + 1, j + 1), at(i + 1, j)});
      } else {
        triangles.push_back({at(i, j), at(i, j + 1), at(i + 1, j)});
        triangles.push_back({at(i + 1, j), at(i, j + 1), at(i + 1, j + 1)});
      }
    }
  return make_test_cloth(flat, triangles);
}

/// Two triangles of 2 cm that share a side along z, bent by `angle` about it: positive bulges
/// outwards (up).
inline Cloth hinge(double angle) {
  const double h = 0.02;
  const std::vector<Triangle> triangles = {{0, 2, 3}, {1, 3, 2}};
  Cloth cloth = make_test_cloth(
      {Vec3(-h, 0, 0), Vec3(h, 0, 0), Vec3(0, 0, -h / 2), Vec3(0, 0, h / 2)}, triangles);
  cloth.positions[0] = h * Vec3(-std::cos(angle / 2), -std::sin(angle / 2), 0);
  cloth.positions[1] = h * Vec3(std::cos(angle / 2), -std::sin(angle / 2), 0);
  return cloth;
}

/// Moves all particles by up to `offset` metres and gives them speeds up to `speed` m/s.
inline void shake(Cloth& cloth, double offset, double speed, std::uint64_t seed) {
  Dice dice(seed);
  const auto vector = [&](double size) {
    return Vec3(dice.uniform(-size, size), dice.uniform(-size, size), dice.uniform(-size, size));
  };
  for (std::size_t i = 0; i < cloth.size(); ++i) {
    cloth.positions[i] += vector(offset);
    cloth.velocities[i] = vector(speed);
  }
}

}  // namespace regarment::test
