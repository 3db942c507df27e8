#include "drape/force_jacobian.h"

#include <algorithm>

#include "base/error.h"
#include "drape/cloth.h"

namespace regarment {

BlockMatrix::BlockMatrix(std::size_t n, std::vector<std::pair<int, int>> pairs)
    : diagonal_(n, Mat3::Zero()), row_(n + 1, 0) {
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  column_.reserve(pairs.size());
  for (const auto& [i, j] : pairs) {
    if (i < 0 || i >= j || static_cast<std::size_t>(j) >= n)
      throw InvalidInput("BlockMatrix: a pair is not in order or out of range");
    ++row_[static_cast<std::size_t>(i) + 1];
    column_.push_back(j);
  }
  for (std::size_t i = 0; i < n; ++i) row_[i + 1] += row_[i];
  upper_.assign(pairs.size(), Mat3::Zero());
}

void BlockMatrix::set_zero() {
  std::fill(diagonal_.begin(), diagonal_.end(), Mat3::Zero());
  std::fill(upper_.begin(), upper_.end(), Mat3::Zero());
}

std::size_t BlockMatrix::slot(int i, int j) const {
  // Rows have about seven blocks: a walk is quicker than a bisection.
  std::size_t k = row_[static_cast<std::size_t>(i)];
  while (column_[k] != j) ++k;
  return k;
}

void BlockMatrix::multiply(const std::vector<Vec3>& x, std::vector<Vec3>& y) const {
  for (std::size_t i = 0; i < size(); ++i) y[i].noalias() = diagonal_[i] * x[i];
  for (std::size_t i = 0; i < size(); ++i) {
    Vec3 sum = Vec3::Zero();
    for (std::size_t k = row_[i]; k < row_[i + 1]; ++k) {
      const auto j = static_cast<std::size_t>(column_[k]);
      sum.noalias() += upper_[k] * x[j];
      y[j].noalias() += upper_[k].transpose() * x[i];
    }
    y[i] += sum;
  }
}

void BlockMatrix::combine(const std::vector<double>& diagonal, double a, const BlockMatrix& first,
                          double b, const BlockMatrix& second) {
  for (std::size_t i = 0; i < size(); ++i)
    diagonal_[i] =
        diagonal[i] * Mat3::Identity() - a * first.diagonal_[i] - b * second.diagonal_[i];
  for (std::size_t k = 0; k < upper_.size(); ++k)
    upper_[k] = -a * first.upper_[k] - b * second.upper_[k];
}

Mat3 BlockMatrix::block(int i, int j) const {
  if (i == j) return diagonal_[static_cast<std::size_t>(i)];
  const auto low = static_cast<std::size_t>(std::min(i, j));
  for (std::size_t k = row_[low]; k < row_[low + 1]; ++k)
    if (column_[k] == std::max(i, j)) return i < j ? upper_[k] : Mat3(upper_[k].transpose());
  return Mat3::Zero();
}

ForceJacobian make_jacobian(const Cloth& cloth) {
  std::vector<std::pair<int, int>> pairs;
  for (const Spring& s : cloth.springs) pairs.emplace_back(s.particle_a, s.particle_b);
  for (const BendingElement& e : cloth.bending)
    for (std::size_t a = 0; a < 4; ++a)
      for (std::size_t b = 0; b < a; ++b)
        pairs.push_back(std::minmax(e.particles[a], e.particles[b]));
  const BlockMatrix empty(cloth.size(), std::move(pairs));
  return {empty, empty};
}

}  // namespace regarment
