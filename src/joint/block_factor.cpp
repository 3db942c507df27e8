#include "joint/block_factor.h"

#include <Eigen/Cholesky>
#include <Eigen/OrderingMethods>
#include <Eigen/SparseCore>
#include <algorithm>

namespace regarment {
namespace {

using Eigen::Index;
using Eigen::Matrix3d;

PaddedBlock padded(const Matrix3d& block) {
  PaddedBlock out;
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 3; ++c) out.row[r].lane[c] = block(r, c);
  return out;
}

Matrix3d plain(const PaddedBlock& block) {
  Matrix3d out;
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 3; ++c) out(r, c) = block.row[r].lane[c];
  return out;
}

std::vector<int> places_of(const BlockTriangle& matrix) {
  const int n = matrix.size();
  std::vector<Eigen::Triplet<double>> entries;
  for (int j = 0; j < n; ++j) {
    entries.emplace_back(j, j, 1.0);
    for (int p = matrix.start[j]; p < matrix.start[j + 1]; ++p)
      entries.emplace_back(matrix.row[p], j, 1.0);
  }
  Eigen::SparseMatrix<double> graph(n, n);
  graph.setFromTriplets(entries.begin(), entries.end());
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> order;
  Eigen::AMDOrdering<int>()(graph.selfadjointView<Eigen::Lower>(), order);
  std::vector<int> places(static_cast<std::size_t>(n));
  for (int k = 0; k < n; ++k) places[order.indices()[k]] = k;
  return places;
}

}  // namespace

BlockTriangle::BlockTriangle(int size, const std::vector<std::array<int, 2>>& pairs)
    : diagonal(static_cast<std::size_t>(size), Matrix3d::Zero()) {
  std::vector<std::array<int, 2>> sorted;  // column, row
  for (const auto& [a, b] : pairs)
    if (a != b) sorted.push_back({std::min(a, b), std::max(a, b)});
  std::sort(sorted.begin(), sorted.end());
  sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
  start.assign(diagonal.size() + 1, 0);
  for (const auto& [column, r] : sorted) {
    ++start[column + 1];
    row.push_back(r);
  }
  for (std::size_t j = 1; j < start.size(); ++j) start[j] += start[j - 1];
  below.assign(row.size(), Matrix3d::Zero());
}

void BlockTriangle::set_zero() {
  std::fill(diagonal.begin(), diagonal.end(), Matrix3d::Zero());
  std::fill(below.begin(), below.end(), Matrix3d::Zero());
}

void BlockTriangle::add(int i, int j, const Matrix3d& block) {
  if (i < j) return;
  if (i == j) {
    diagonal[i] += block;
    return;
  }
  const auto at = std::lower_bound(row.begin() + start[j], row.begin() + start[j + 1], i);
  below[static_cast<std::size_t>(at - row.begin())] += block;
}

BlockFactor::BlockFactor(const BlockTriangle& structure) : place_(places_of(structure)) {
  const auto n = static_cast<std::size_t>(structure.size());
  parent_.assign(n, -1), mark_.assign(n, -1), filled_.assign(n, 0);
  pattern_.resize(n), path_.resize(n);
  work_.resize(n), inverse_.resize(n);
  upper_.resize(n);
  for (int j = 0; j < structure.size(); ++j)
    for (int p = structure.start[j]; p < structure.start[j + 1]; ++p) {
      const int a = place_[structure.row[p]], b = place_[j];
      upper_[std::max(a, b)].push_back({std::min(a, b), p, a > b});
    }
  start_.assign(n + 1, 0);
  for (int k = 0; k < structure.size(); ++k) {
    mark_[k] = k;
    for (const Upper& entry : upper_[k])
      for (int i = entry.row; mark_[i] != k; i = parent_[i]) {
        if (parent_[i] < 0) parent_[i] = k;
        ++start_[i + 1];
        mark_[i] = k;
      }
  }
  for (std::size_t k = 1; k <= n; ++k) start_[k] += start_[k - 1];
  row_.resize(static_cast<std::size_t>(start_.back()));
  lower_.resize(row_.size());
}

int BlockFactor::gather(const BlockTriangle& matrix, int column) {
  int top = static_cast<int>(pattern_.size());
  mark_[column] = column;
  for (const Upper& entry : upper_[column]) {
    const Matrix3d& block = matrix.below[entry.entry];
    for (int r = 0; r < 3; ++r)
      for (int c = 0; c < 3; ++c)
        work_[entry.row].row[r].lane[c] += entry.transposed ? block(c, r) : block(r, c);
    int length = 0;
    for (int i = entry.row; mark_[i] != column; i = parent_[i]) {
      path_[length++] = i;
      mark_[i] = column;
    }
    while (length > 0) pattern_[--top] = path_[--length];
  }
  return top;
}

bool BlockFactor::factorize(const BlockTriangle& matrix) {
  const int n = matrix.size();
  std::fill(mark_.begin(), mark_.end(), -1);
  std::fill(filled_.begin(), filled_.end(), 0);
  std::vector<int> block_at(place_.size());
  for (int b = 0; b < n; ++b) block_at[place_[b]] = b;
  for (int k = 0; k < n; ++k) {
    PaddedBlock pivot = padded(matrix.diagonal[block_at[k]]);
    for (int s = gather(matrix, k); s < n; ++s) {
      const int i = pattern_[s];
      const int end = start_[i] + filled_[i];
      eliminate_block({&lower_[start_[i]], &row_[start_[i]], filled_[i]}, i, inverse_[i],
                      work_.data(), lower_[end], pivot);
      row_[end] = k;
      ++filled_[i];
    }
    const Eigen::LLT<Matrix3d> root(plain(pivot));
    if (root.info() != Eigen::Success) {
      std::fill(work_.begin(), work_.end(), PaddedBlock());
      return false;
    }
    inverse_[k] = root.solve(Matrix3d::Identity());
  }
  return true;
}

Eigen::MatrixXd BlockFactor::solve(const Eigen::MatrixXd& b) const {
  const auto n = static_cast<int>(place_.size());
  const FactorView view{n, start_.data(), row_.data(), lower_.data(), inverse_.data()};
  Eigen::MatrixXd out(b.rows(), b.cols());
  for (Index first = 0; first < b.cols(); first += 4 * kMostWidth) {
    const Index columns = std::min<Index>(b.cols() - first, 4 * kMostWidth);
    const auto width = static_cast<int>((columns + 3) / 4);
    std::vector<FourNumbers> x(static_cast<std::size_t>(n) * 3 * width);
    const auto of = [&](Index row, Index c) -> double& {
      const Index block = place_[row / 3];
      return x[(3 * block + row % 3) * width + c / 4].lane[c % 4];
    };
    for (Index c = 0; c < columns; ++c)
      for (Index row = 0; row < b.rows(); ++row) of(row, c) = b(row, first + c);
    solve_blocks(view, width, x.data());
    for (Index c = 0; c < columns; ++c)
      for (Index row = 0; row < b.rows(); ++row) out(row, first + c) = of(row, c);
  }
  return out;
}

}  // namespace regarment
