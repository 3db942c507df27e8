#include "scan/cone_person.h"

#include <Eigen/Geometry>
#include <cmath>
#include <random>
#include <vector>

namespace regarment::test {
namespace {

constexpr double kPi = 3.14159265358979323846;

/// A cone with rounded ends from `a` to `b`, pressed by `flat` along z about its axis.
struct Part {
  Vec3 a, b;
  double radius_a, radius_b;
  double flat = 1.0;

  Vec3 squeezed(const Vec3& p) const {
    const double axis_z = (a.z() + b.z()) / 2;
    return {p.x(), p.y(), axis_z + (p.z() - axis_z) / flat};
  }
  /// Below 0 inside; a distance up to the slant of the cone and the squeeze.
  double depth(const Vec3& p) const {
    const Vec3 q = squeezed(p);
    const double length = (b - a).squaredNorm();
    const double t = length > 0 ? std::clamp((q - a).dot(b - a) / length, 0.0, 1.0) : 0.0;
    return (q - a - t * (b - a)).norm() - (radius_a + t * (radius_b - radius_a));
  }
};

void add_limb(std::vector<Part>& parts, double side, const PersonShape& s) {
  const double angle = s.arm_angle * kPi / 180;
  const Vec3 along(side * std::cos(angle), std::sin(angle), 0.0);
  const Vec3 shoulder(side * 0.18, 1.40, -0.01);
  const Vec3 elbow = shoulder + 0.28 * along + Vec3(0, 0, 0.01);
  const Vec3 wrist = elbow + 0.25 * along + Vec3(0, 0, 0.06);
  const Vec3 hand = wrist + 0.13 * along + Vec3(0, 0, 0.03);
  parts.push_back({shoulder, elbow, 0.050 * s.girth, 0.040 * s.girth});
  parts.push_back({elbow, wrist, 0.040 * s.girth, 0.028 * s.girth});
  parts.push_back({wrist, hand, 0.030, 0.025});
  const Vec3 step(0, 0, side * s.stride / 2);
  const Vec3 hip(side * 0.085, 0.86, 0), ankle = Vec3(side * 0.11, 0.09, -0.01) + step;
  const Vec3 knee = (hip + ankle) / 2 + Vec3(0, 0.02, 0.02);
  parts.push_back({hip, knee, 0.088 * s.girth, 0.058 * s.girth});
  parts.push_back({knee, ankle, 0.058 * s.girth, 0.040 * s.girth});
  if (s.has_feet) {
    parts.push_back(
        {ankle + Vec3(0, -0.055, -0.03), ankle + Vec3(side * 0.03, -0.060, 0.16), 0.035, 0.030});
  }
  parts.push_back({Vec3(side * 0.07, 0.93, -0.05), Vec3(side * 0.07, 0.93, -0.05), 0.085 * s.girth,
                   0.085 * s.girth});
}

std::vector<Part> parts_of(const PersonShape& s) {
  std::vector<Part> parts;
  parts.push_back({Vec3(0, 0.93, 0), Vec3(0, 1.10, 0), 0.160 * s.girth, 0.130 * s.girth, 0.72});
  parts.push_back({Vec3(0, 1.10, 0), Vec3(0, 1.36, 0), 0.130 * s.girth, 0.150 * s.girth, 0.70});
  parts.push_back(
      {Vec3(-0.16, 1.41, -0.01), Vec3(0.16, 1.41, -0.01), 0.050 * s.girth, 0.050 * s.girth});
  for (const double side : {1.0, -1.0}) add_limb(parts, side, s);
  if (s.has_head) {
    const Vec3 chin(0, 1.50 + 0.06 * s.head, 0.03);
    parts.push_back({Vec3(0, 1.40, -0.02), Vec3(0, 1.54, 0.0), 0.055, 0.050});
    parts.push_back(
        {chin, chin + s.head * Vec3(0, 0.10, -0.01), 0.070 * s.head, 0.080 * s.head, 1.2});
    parts.push_back({chin + s.head * Vec3(0, 0.05, 0.08), chin + s.head * Vec3(0, 0.06, 0.08),
                     0.018 * s.head, 0.012 * s.head});
  }
  if (s.skirt_hem >= 0) {
    parts.push_back({Vec3(0, 1.02, 0), Vec3(0, s.skirt_hem + s.skirt_radius, 0), 0.17 * s.girth,
                     s.skirt_radius, 0.8});
  }
  return parts;
}

/// Point of a part's surface: `t` from the pole at a (0) to the pole at b (1), `turn` round the
/// axis.
Vec3 on_part(const Part& part, double t, double turn) {
  const Vec3 axis =
      (part.b - part.a).norm() > 0 ? Vec3((part.b - part.a).normalized()) : Vec3(Vec3::UnitY());
  const Vec3 e = axis.unitOrthogonal(), f = axis.cross(e);
  const double arc_a = kPi / 2 * part.radius_a, arc_b = kPi / 2 * part.radius_b;
  const double straight = (part.b - part.a).norm();
  double s = t * (arc_a + straight + arc_b);
  Vec3 centre = part.b;
  double along = 0, radius = part.radius_b;
  if (s < arc_a) {
    centre = part.a;
    const double angle = s / part.radius_a;
    along = -std::cos(angle) * part.radius_a;
    radius = std::sin(angle) * part.radius_a;
  } else if (s < arc_a + straight) {
    const double share = (s - arc_a) / straight;
    centre = part.a + share * (part.b - part.a);
    radius = part.radius_a + share * (part.radius_b - part.radius_a);
  } else {
    const double angle = (s - arc_a - straight) / part.radius_b;
    along = std::sin(angle) * part.radius_b;
    radius = std::cos(angle) * part.radius_b;
  }
  Vec3 p = centre + along * axis + radius * (std::cos(turn) * e + std::sin(turn) * f);
  const double axis_z = (part.a.z() + part.b.z()) / 2;
  p.z() = axis_z + (p.z() - axis_z) * part.flat;
  return p;
}

void add_part(const Part& part, double edge, Mesh& mesh) {
  const double length = kPi / 2 * (part.radius_a + part.radius_b) + (part.b - part.a).norm();
  const int rows = std::max(6, static_cast<int>(length / edge));
  const int columns =
      std::max(8, static_cast<int>(2 * kPi * std::max(part.radius_a, part.radius_b) / edge));
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  const auto at = [&](int row, int column) {
    return first + 1 + static_cast<std::uint32_t>((row - 1) * columns + column % columns);
  };
  mesh.positions.push_back(on_part(part, 0, 0));
  for (int row = 1; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      mesh.positions.push_back(
          on_part(part, static_cast<double>(row) / rows, 2 * kPi * column / columns));
    }
  }
  const auto last = static_cast<std::uint32_t>(mesh.positions.size());
  mesh.positions.push_back(on_part(part, 1, 0));
  for (int column = 0; column < columns; ++column) {
    mesh.triangles.push_back({first, at(1, column + 1), at(1, column)});
    mesh.triangles.push_back({last, at(rows - 1, column), at(rows - 1, column + 1)});
    for (int row = 1; row + 1 < rows; ++row) {
      mesh.triangles.push_back({at(row, column), at(row, column + 1), at(row + 1, column)});
      mesh.triangles.push_back({at(row + 1, column), at(row, column + 1), at(row + 1, column + 1)});
    }
  }
}

struct Sampled {
  Mesh cloud;
  double area = 0;
};

/// Evenly spread points of the seen surface; `density` points per m^2.
Sampled sample(const PersonShape& shape, double density, double noise, std::uint32_t seed) {
  const std::vector<Part> parts = parts_of(shape);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform;
  std::normal_distribution<double> normal;
  Sampled sampled;
  for (std::size_t own = 0; own < parts.size(); ++own) {
    Mesh mesh;
    add_part(parts[own], 0.012, mesh);
    for (const auto& [i, j, k] : mesh.triangles) {
      const Vec3 u = mesh.positions[j] - mesh.positions[i],
                 v = mesh.positions[k] - mesh.positions[i];
      const Vec3 cross = u.cross(v);
      const double expected = cross.norm() / 2 * density;
      for (int n = std::poisson_distribution<int>(expected)(random); n > 0; --n) {
        double s = uniform(random), t = uniform(random);
        if (s + t > 1) {
          s = 1 - s;
          t = 1 - t;
        }
        const Vec3 p = mesh.positions[i] + s * u + t * v;
        bool hidden = false;
        for (std::size_t other = 0; other < parts.size() && !hidden; ++other) {
          hidden = other != own && parts[other].depth(p) < 0;
        }
        if (hidden) continue;
        const Vec3 n_out = cross.normalized();
        sampled.cloud.positions.push_back(p + noise * normal(random) * n_out);
        sampled.cloud.normals.push_back(n_out);
        sampled.area += 1 / density;
      }
    }
  }
  return sampled;
}

}  // namespace

Mesh made_person(const PersonShape& shape, double edge) {
  Mesh mesh;
  for (const Part& part : parts_of(shape)) add_part(part, edge, mesh);
  return mesh;
}

double seen_area(const PersonShape& shape) { return sample(shape, 20000, 0, 7).area; }

Mesh made_cloud(const PersonShape& shape, std::size_t count, double noise, std::uint32_t seed) {
  return sample(shape, static_cast<double>(count) / seen_area(shape), noise, seed).cloud;
}

Mesh made_box(const Vec3& size, double edge) {
  Mesh mesh;
  for (int axis = 0; axis < 3; ++axis) {
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    const int nu = std::max(1, static_cast<int>(size[u] / edge)),
              nv = std::max(1, static_cast<int>(size[v] / edge));
    for (const int end : {0, 1}) {
      const auto first = static_cast<std::uint32_t>(mesh.positions.size());
      for (int i = 0; i <= nu; ++i) {
        for (int j = 0; j <= nv; ++j) {
          Vec3 p;
          p[axis] = end * size[axis];
          p[u] = size[u] * i / nu;
          p[v] = size[v] * j / nv;
          mesh.positions.push_back(p);
        }
      }
      for (int i = 0; i < nu; ++i) {
        for (int j = 0; j < nv; ++j) {
          const auto at = [&](int a, int b) {
            return first + static_cast<std::uint32_t>(a * (nv + 1) + b);
          };
          Triangle one = {at(i, j), at(i + 1, j), at(i + 1, j + 1)},
                   two = {at(i, j), at(i + 1, j + 1), at(i, j + 1)};
          if (end == 0) {
            std::swap(one[1], one[2]);
            std::swap(two[1], two[2]);
          }
          mesh.triangles.push_back(one);
          mesh.triangles.push_back(two);
        }
      }
    }
  }
  return mesh;
}

Mesh made_sphere(double radius, const Vec3& centre) {
  Mesh mesh;
  add_part({centre, centre, radius, radius}, radius / 20, mesh);
  return mesh;
}

void append(Mesh& mesh, const Mesh& other) {
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  mesh.positions.insert(mesh.positions.end(), other.positions.begin(), other.positions.end());
  for (const auto& [i, j, k] : other.triangles)
    mesh.triangles.push_back({first + i, first + j, first + k});
}

Mesh moved(Mesh mesh, const Eigen::Matrix3d& turn, double scale, const Vec3& shift) {
  for (Vec3& p : mesh.positions) p = (scale * (turn * p) + shift).eval();
  for (Vec3& n : mesh.normals) n = (turn * n).eval();
  return mesh;
}

Mesh cloud_of(Mesh mesh) {
  mesh.triangles.clear();
  return mesh;
}

}  // namespace regarment::test
