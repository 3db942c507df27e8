#pragma once

#include <memory>
#include <vector>

#include "geometry/closest_point.h"
#include "synthetic/sheet.h"

namespace regarment {

/// Cloth is kept this far from what it touches, m, beyond half the thicknesses: it sags a little
/// between its particles.
inline constexpr double kAirGap = 1e-3;

/// What an obstacle is to the cloth that touches it.
enum class ObstacleKind {
  Body,    // does not give way; closed
  Below,   // cloth that lies below and gives way as much
  Around,  // cloth worn over the trunk, which presses in what it encloses
};

/// A surface that cloth touches, which may itself move: a body, or another garment.
class Obstacle {
 public:
  /// Counter-clockwise seen from the wearer's outside. `thickness` m is that of the surface itself,
  /// half of which lies on each side of its triangles: 0 for skin.
  Obstacle(ObstacleKind kind, std::vector<Triangle> triangles, std::vector<Vec3> positions,
           double thickness);

  /// Where the surface is after a step; before it is where it was till now.
  void move_to(std::vector<Vec3> positions);
  /// Makes nearest points exact again; costs some milliseconds and is needed every centimetre or so
  /// of movement.
  void rebuild();

  const std::vector<Triangle>& triangles() const { return triangles_; }
  const std::vector<Vec3>& now() const { return now_; }
  const std::vector<Vec3>& before() const { return before_; }
  ObstacleKind kind() const { return kind_; }
  double thickness() const { return thickness_; }
  ClosestHit closest(const Vec3& p, double reach) const;
  /// Unit normal, towards where cloth may be, at weights of a triangle's corners; smooth over the
  /// surface.
  Vec3 normal(std::uint32_t triangle, const Vec3& weights) const;
  Vec3 normal(const ClosestHit& hit) const;

 private:
  ObstacleKind kind_;
  std::vector<Triangle> triangles_;
  std::vector<Vec3> now_, before_, normals_;
  double thickness_;
  std::unique_ptr<ClosestPoint> tree_;
};

/// What keeps a sheet outside of an obstacle, and from sliding on it. One per sheet and obstacle.
class SurfaceContact {
 public:
  /// `sheet` must outlive this object.
  explicit SurfaceContact(const Sheet& sheet);

  /// Finds nearest points again for particles that have moved far enough to need it, or for all.
  void find(const Obstacle& obstacle, const std::vector<Vec3>& x, bool all);
  /// Adds what pushes particles out, N, a spring of `pressure` N/m^3 times the particle's area, and
  /// friction: a spring of the same strength to where the particle stuck, up to Coulomb's limit.
  void add_forces(const Obstacle& obstacle, const std::vector<Vec3>& x, double pressure,
                  std::vector<Vec3>& forces) const;
  /// Moves particles that lie too deep outside at once, and takes their sliding on the obstacle
  /// since `before` by friction.
  void push_out(const Obstacle& obstacle, const std::vector<Vec3>& before,
                std::vector<Vec3>& x) const;
  /// Adds the stiffness of these forces to each particle's that touches or soon may, N/m.
  void add_stiffness(const Obstacle& obstacle, const std::vector<Vec3>& x, double pressure,
                     std::vector<double>& stiffness) const;
  /// Where particles stick from now on: slid along by friction's limit, and carried by the
  /// obstacle's own movement since the last call.
  void settle(const Obstacle& obstacle, const std::vector<Vec3>& x);

 private:
  struct Contact {
    std::uint32_t triangle = ClosestHit::kNone;
    Vec3 weights = Vec3::Zero();
    Vec3 normal = Vec3::Zero();
    Vec3 asked_at = Vec3::Zero();
    double good_for = -1.0;  // m the particle may move before it has to ask again
    Vec3 stuck_at = Vec3::Zero();
    bool sticks = false;
  };
  double depth(const Obstacle& obstacle, const Contact& contact, const Vec3& x) const;
  Contact ask(const Obstacle& obstacle, std::size_t particle, const Vec3& p) const;

  const Sheet& sheet_;
  std::vector<Contact> contacts_;
};

}  // namespace regarment
