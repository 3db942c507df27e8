#pragma once

#include <cmath>
#include <limits>
#include <optional>

#include "scan/scan.h"
#include "support/dice.h"
#include "support/tubes.h"

namespace regarment::test {

/// A skirt as a straight frustum about the upright line over the origin. Body frame, m.
struct MadeSkirt {
  double waist_y = 1.03, waist_radius = 0.129;
  double hem_y = 0.50, hem_radius = 0.25;
  bool capped = false;  // a flat disc closes the hem, as surface reconstructions do

  double slant() const { return std::hypot(waist_y - hem_y, hem_radius - waist_radius); }
  double radius(double y) const {
    return waist_radius + (hem_radius - waist_radius) * (waist_y - y) / (waist_y - hem_y);
  }
};

/// What a person is made of. Angles in radians from straight down.
struct PersonPlan {
  double left_arm = 0.8, right_arm = 0.8;
  std::optional<MadeSkirt> skirt;
  double edge = 0.008;  // m, of the triangles
};

enum class MadePart : std::uint8_t { Skin, Skirt, Cap };

/// A person of simple parts, 1.75 m tall, every size known. Body frame: y up, z in front, x to the
/// person's left, floor at 0.
struct MadePerson {
  static constexpr double kHeight = 1.75;
  static constexpr double kFork = 0.80;  // lowest point of the trunk
  static constexpr double kNeck = 1.50;  // its narrowest level above the chest
  static constexpr double kArmX = 0.135, kArmY = 1.36, kArmLength = 0.56;
  static constexpr double kArmRoot = 0.05, kArmEnd = 0.032;  // radii of an arm, m

  Mesh mesh;
  std::vector<MadePart> part;  // per vertex
  std::vector<Tube> tubes;     // trunk, legs, arms

  bool holds(const Vec3& p, double margin = 0) const {
    return std::any_of(tubes.begin(), tubes.end(),
                       [&](const Tube& t) { return t.holds(p, margin); });
  }

  /// Where arm and trunk part: the lowest level at which the arm's inner outline and the trunk's
  /// side meet, both seen from in front. `side` 0 left, 1 right.
  double armpit(int side) const {
    const Tube& arm = tubes[static_cast<std::size_t>(3 + side)];
    const Tube& trunk = tubes[0];
    double lowest = std::numeric_limits<double>::infinity();
    for (double t = 0; t <= kArmLength; t += 0.0005) {
      // The arm's inner side lies across its axis towards the body, in the plane z = 0.
      for (const double phi : {0.0, std::numbers::pi}) {
        const Vec3 p = arm.point(t, phi);
        if (p.y() > trunk.low() && p.y() < trunk.high() && std::abs(p.x()) <= trunk.at(p.y()).b)
          lowest = std::min(lowest, p.y());
      }
    }
    return lowest;
  }
};

/// The parts of a person, the trunk first, then left leg, right leg, left arm, right arm.
inline std::vector<Tube> person_tubes(const PersonPlan& plan) {
  // u points to the front, v to the person's left: a is half the depth, b half the width.
  Tube trunk;
  trunk.stations = {{0.80, 0.06, 0.06}, {0.88, 0.13, 0.15},   {1.03, 0.125, 0.125},
                    {1.24, 0.12, 0.16}, {1.36, 0.10, 0.165},  {1.43, 0.075, 0.135},
                    {1.50, 0.05, 0.05}, {1.62, 0.095, 0.078}, {1.75, 0.02, 0.02}};
  std::vector<Tube> tubes{trunk};
  for (const double side : {1.0, -1.0}) {
    Tube leg;
    leg.stations = {{0.0, 0.05, 0.042, 0.0, side * 0.095},
                    {0.45, 0.06, 0.052, 0.0, side * 0.09},
                    {0.80, 0.10, 0.065, 0.0, side * 0.085},
                    {0.94, 0.10, 0.06, 0.0, side * 0.07}};
    tubes.push_back(leg);
  }
  for (const double side : {1.0, -1.0}) {
    const double angle = side > 0 ? plan.left_arm : plan.right_arm;
    Tube arm;
    arm.origin = Vec3(side * MadePerson::kArmX, MadePerson::kArmY, 0);
    arm.axis = Vec3(side * std::sin(angle), -std::cos(angle), 0);
    arm.v = Vec3::UnitZ();
    arm.u = arm.v.cross(arm.axis);
    arm.stations = {{0.0, MadePerson::kArmRoot, MadePerson::kArmRoot},
                    {MadePerson::kArmLength, MadePerson::kArmEnd, MadePerson::kArmEnd}};
    arm.straight = true;
    tubes.push_back(arm);
  }
  return tubes;
}

inline Tube skirt_tube(const MadeSkirt& skirt) {
  Tube tube;
  tube.stations = {{skirt.hem_y, skirt.hem_radius, skirt.hem_radius},
                   {skirt.waist_y, skirt.waist_radius, skirt.waist_radius}};
  tube.straight = true;
  tube.closed = false;
  return tube;
}

inline MadePerson make_person(const PersonPlan& plan) {
  MadePerson person;
  person.tubes = person_tubes(plan);
  for (std::size_t i = 0; i < person.tubes.size(); ++i) {
    std::vector<Tube> others = person.tubes;
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(i));
    // A scanner does not see what a skirt hides, but for a little above the hem.
    if (plan.skirt) {
      Tube hidden = skirt_tube(*plan.skirt);
      hidden.stations.front().t += 0.03;
      others.push_back(hidden);
    }
    add_tube(person.tubes[i], plan.edge, others, person.mesh);
  }
  person.part.assign(person.mesh.positions.size(), MadePart::Skin);
  if (plan.skirt) {
    add_tube(skirt_tube(*plan.skirt), plan.edge, {}, person.mesh);
    person.part.resize(person.mesh.positions.size(), MadePart::Skirt);
    if (plan.skirt->capped) {
      Tube cap = skirt_tube(*plan.skirt);
      cap.stations.back() = cap.stations.front();
      cap.stations.back().t += 1e-4;
      cap.closed = true;
      Mesh whole;
      add_tube(cap, plan.edge, {}, whole);
      const auto first = static_cast<std::uint32_t>(person.mesh.positions.size());
      for (Triangle t : whole.triangles) {
        const Vec3 n = (whole.positions[t[1]] - whole.positions[t[0]])
                           .cross(whole.positions[t[2]] - whole.positions[t[0]]);
        if (n.y() > -0.9 * n.norm()) continue;
        for (std::uint32_t& v : t) v += first;
        person.mesh.triangles.push_back(t);
      }
      person.mesh.positions.insert(person.mesh.positions.end(), whole.positions.begin(),
                                   whole.positions.end());
      person.part.resize(person.mesh.positions.size(), MadePart::Cap);
    }
  }
  drop_unused(person.mesh, person.part);
  fill_normals(person.mesh);
  return person;
}

/// Points scattered at random have their nearest neighbour, in the median, this many times as far
/// away as the side of the square each stands for: sqrt(ln 2 / pi).
constexpr double kNearestShare = 0.4697;

/// A mesh or cloud in the body frame as a scan. `nearest`: median distance between neighbours, m.
inline Scan scan_of(const Mesh& mesh, double nearest = 0.008) {
  Scan scan;
  scan.mesh = mesh;
  scan.facts.height = MadePerson::kHeight;
  scan.facts.spacing = nearest;
  scan.facts.units = "m";
  scan.facts.up = "+y";
  scan.facts.front = "+z";
  scan.outlier.assign(mesh.positions.size(), 0);
  scan.file_from_body.setIdentity();
  return scan;
}

/// Points spread evenly and at random over a mesh, as a scanner sees them; about `spacing` apart.
/// `from` receives a vertex of the triangle each point lies on.
inline Mesh cloud_of(const Mesh& mesh, double spacing, std::uint64_t seed,
                     std::vector<std::uint32_t>* from = nullptr) {
  Dice dice(seed);
  Mesh cloud;
  for (const Triangle& t : mesh.triangles) {
    const Vec3 &a = mesh.positions[t[0]], &b = mesh.positions[t[1]], &c = mesh.positions[t[2]];
    const Vec3 n = (b - a).cross(c - a);
    const double wanted = 0.5 * n.norm() / (spacing * spacing);
    const int count = static_cast<int>(wanted + dice.uniform(0, 1));
    for (int k = 0; k < count; ++k) {
      double x = dice.uniform(0, 1), y = dice.uniform(0, 1);
      if (x + y > 1) x = 1 - x, y = 1 - y;
      cloud.positions.push_back(a + x * (b - a) + y * (c - a));
      cloud.normals.push_back(n.normalized());
      if (from) from->push_back(t[0]);
    }
  }
  return cloud;
}

inline Mesh mirrored(Mesh mesh) {
  for (Vec3& p : mesh.positions) p.x() = -p.x();
  for (Vec3& n : mesh.normals) n.x() = -n.x();
  for (Triangle& t : mesh.triangles) std::swap(t[1], t[2]);
  return mesh;
}

}  // namespace regarment::test
