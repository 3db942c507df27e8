#include "synthetic/sheet_forces.h"

#include <algorithm>
#include <cmath>

namespace regarment {
namespace {

constexpr double kCollapsed = 1e-6;  // image of a unit vector shorter than this has no direction

/// The images of an element's unit vectors across and along.
struct Images {
  Vec3 s, t;

  Images(const SheetElement& e, const std::vector<Vec3>& x) {
    const Vec3 p = x[e.corner[1]] - x[e.corner[0]], q = x[e.corner[2]] - x[e.corner[0]];
    s = e.across.x() * p + e.across.y() * q;
    t = e.along.x() * p + e.along.y() * q;
  }
};

/// Derivative of 1/2 (|image| - 1)^2.
Vec3 excess(const Vec3& image) {
  const double length = image.norm();
  if (length < kCollapsed) return Vec3::Zero();
  return (1 - 1 / length) * image;
}

/// How an image moves with each corner: by this times the corner's displacement.
std::array<double, 3> shares(const Vec2& d) { return {-d.x() - d.y(), d.x(), d.y()}; }

double square(double v) { return v * v; }

}  // namespace

void add_strain_forces(const Sheet& sheet, const std::vector<Vec3>& x, std::vector<Vec3>& forces) {
  const SheetFabric& fabric = sheet.fabric;
  for (const SheetElement& e : sheet.elements) {
    const Images image(e, x);
    const double area = e.area * e.layers;
    const double longer = 0.5 * (image.s.squaredNorm() + image.t.squaredNorm());
    const double shear =
        area * fabric.stiffness_shear / std::max(1.0, longer) * image.s.dot(image.t);
    const Vec3 on_s = area * fabric.stiffness_across * excess(image.s) + shear * image.t;
    const Vec3 on_t = area * fabric.stiffness_along * excess(image.t) + shear * image.s;
    const Vec3 f1 = e.across.x() * on_s + e.along.x() * on_t;
    const Vec3 f2 = e.across.y() * on_s + e.along.y() * on_t;
    forces[e.corner[1]] -= f1;
    forces[e.corner[2]] -= f2;
    forces[e.corner[0]] += f1 + f2;
  }
}

void add_bending_forces(const Sheet& sheet, const std::vector<Vec3>& x, std::vector<Vec3>& forces) {
  const BendingMatrix& q = sheet.bending;
  for (std::size_t p = 0; p < x.size(); ++p)
    for (std::uint32_t k = q.begin[p]; k < q.begin[p + 1]; ++k)
      forces[p] -= q.value[k] * x[q.column[k]];
}

double strain_energy(const Sheet& sheet, const std::vector<Vec3>& x) {
  const SheetFabric& fabric = sheet.fabric;
  double sum = 0;
  for (const SheetElement& e : sheet.elements) {
    const Images image(e, x);
    sum += 0.5 * e.area * e.layers *
           (fabric.stiffness_across * square(image.s.norm() - 1) +
            fabric.stiffness_along * square(image.t.norm() - 1) +
            fabric.stiffness_shear * square(image.s.dot(image.t)));
  }
  return sum;
}

double bending_energy(const Sheet& sheet, const std::vector<Vec3>& x) {
  std::vector<Vec3> forces(x.size(), Vec3::Zero());
  add_bending_forces(sheet, x, forces);
  double sum = 0;
  for (std::size_t p = 0; p < x.size(); ++p) sum -= 0.5 * x[p].dot(forces[p]);
  return sum;
}

Eigen::SparseMatrix<double> stiffness_bound(const Sheet& sheet) {
  const SheetFabric& fabric = sheet.fabric;
  std::vector<Eigen::Triplet<double>> entries;
  const auto add = [&](std::uint32_t row, std::uint32_t column, double value) {
    if (row >= column) entries.emplace_back(static_cast<int>(row), static_cast<int>(column), value);
  };
  for (const SheetElement& e : sheet.elements) {
    const auto a = shares(e.across), b = shares(e.along);
    const double area = e.area * e.layers;
    // (t.u + s.v)^2 <= 2 (|u|^2 + |v|^2) for s and t no longer than at rest.
    const double ks = area * (fabric.stiffness_across + 2 * fabric.stiffness_shear);
    const double kt = area * (fabric.stiffness_along + 2 * fabric.stiffness_shear);
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j)
        add(e.corner[i], e.corner[j], ks * a[i] * a[j] + kt * b[i] * b[j]);
  }
  const BendingMatrix& q = sheet.bending;
  for (std::uint32_t p = 0; p + 1 < q.begin.size(); ++p)
    for (std::uint32_t k = q.begin[p]; k < q.begin[p + 1]; ++k) add(p, q.column[k], q.value[k]);
  const auto n = static_cast<Eigen::Index>(sheet.particle_count());
  Eigen::SparseMatrix<double> out(n, n);
  out.setFromTriplets(entries.begin(), entries.end());
  return out;
}

}  // namespace regarment
