#pragma once

#include <cmath>
#include <numbers>
#include <vector>

#include "garment/find_template.h"
#include "garment/pattern.h"
#include "joint/match_scan.h"

namespace regarment {

/// A skirt of one girth all the way down, which rolls into a cylinder without being stretched.
inline Dimensions tube_dimensions(double girth, double length) {
  return {{"length", length}, {"width", girth}, {"waist", girth}, {"hip", girth}};
}

/// The pattern's vertices on a cylinder of radius `radius` about the y axis, the waist at y = 1;
/// exact at radius = girth / (2 pi).
inline std::vector<Vec3> rolled(const Pattern& pattern, double girth, double radius) {
  std::vector<Vec3> out;
  for (std::size_t v = 0; v < pattern.flat.size(); ++v) {
    const double angle = 2 * std::numbers::pi * pattern.flat[v].x() / girth;
    const double phi = pattern.panel_is_front[pattern.panel[v]] ? angle : std::numbers::pi - angle;
    out.emplace_back(radius * std::sin(phi), 1 - pattern.flat[v].y(), radius * std::cos(phi));
  }
  return out;
}

/// One position per particle, from one per pattern vertex.
inline std::vector<Vec3> particles_of(const Pattern& pattern, const std::vector<Vec3>& vertices) {
  std::vector<Vec3> x(pattern.particle_count);
  for (std::size_t v = 0; v < vertices.size(); ++v) x[pattern.particle[v]] = vertices[v];
  return x;
}

/// A tube as a scan sees it: points every centimetre, and both edges.
inline JointTarget tube_target(double girth, double length) {
  JointTarget target;
  const double radius = girth / (2 * std::numbers::pi);
  const int around = static_cast<int>(std::lround(girth / 0.01));
  const int down = static_cast<int>(std::lround(length / 0.01));
  std::vector<Vec3> top, bottom;
  for (int i = 0; i < around; ++i) {
    const double phi = 2 * std::numbers::pi * i / around;
    const Vec3 out(std::sin(phi), 0, std::cos(phi));
    top.push_back(radius * out + Vec3(0, 1, 0));
    bottom.push_back(radius * out + Vec3(0, 1 - length, 0));
    for (int j = 0; j < down; ++j) {
      target.points.push_back(radius * out + Vec3(0, 1 - length * (j + 0.5) / down, 0));
      target.normals.push_back(out);
      target.areas.push_back(girth / around * length / down);
    }
  }
  target.edges["waist"] = {top, 0.002};
  target.edges["hem"] = {bottom, 0.002};
  return target;
}

}  // namespace regarment
