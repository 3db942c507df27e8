#include "drape/conjugate_gradient.h"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>

#include "base/error.h"
#include "differences.h"
#include "support/dice.h"

namespace regarment {
namespace {

using namespace test;

struct Problem {
  BlockMatrix matrix;
  std::vector<Vec3> right;
};

Mat3 random_block(Dice& dice, double size) {
  Mat3 m;
  for (int i = 0; i < 9; ++i) m(i / 3, i % 3) = dice.uniform(-size, size);
  return m;
}

/// A ring of n blocks, each row larger on the diagonal than beside it, so positive definite.
Problem ring(int n, std::uint64_t seed) {
  Dice dice(seed);
  std::vector<std::pair<int, int>> pairs = {{0, n - 1}};
  for (int i = 0; i + 1 < n; ++i) pairs.emplace_back(i, i + 1);
  Problem p{BlockMatrix(static_cast<std::size_t>(n), pairs), {}};
  for (int i = 0; i < n; ++i) {
    p.matrix.add(i, Mat3(7 * Mat3::Identity()));
    p.matrix.add((i + 1) % n, i, random_block(dice, 1));
    p.right.emplace_back(dice.uniform(-1, 1), dice.uniform(-1, 1), dice.uniform(-1, 1));
  }
  return p;
}

Eigen::VectorXd flat(const std::vector<Vec3>& v) {
  Eigen::VectorXd out(static_cast<Eigen::Index>(3 * v.size()));
  for (std::size_t i = 0; i < v.size(); ++i)
    out.segment<3>(static_cast<Eigen::Index>(3 * i)) = v[i];
  return out;
}

TEST(BlockMatrix, MultipliesLikeItsDenseForm) {
  const Problem p = ring(9, 1);
  const Eigen::MatrixXd full = dense(p.matrix);
  EXPECT_EQ((full - full.transpose()).norm(), 0);
  std::vector<Vec3> y(9);
  p.matrix.multiply(p.right, y);
  EXPECT_LT((flat(y) - full * flat(p.right)).norm(), 1e-13);
}

TEST(BlockMatrix, CombinesAsWritten) {
  const Problem a = ring(5, 2), b = ring(5, 3);
  BlockMatrix sum = a.matrix;
  sum.combine({1, 2, 3, 4, 5}, 0.5, a.matrix, 0.25, b.matrix);
  Eigen::MatrixXd expected = -0.5 * dense(a.matrix) - 0.25 * dense(b.matrix);
  for (int i = 0; i < 15; ++i) expected(i, i) += i / 3 + 1;
  EXPECT_LT((dense(sum) - expected).norm(), 1e-13);
}

TEST(BlockMatrix, RefusesPairsOutOfRange) {
  for (const std::pair<int, int>& pair : {std::pair(0, 3), std::pair(-1, 1), std::pair(1, 1)})
    EXPECT_THROW(BlockMatrix(3, {pair}), InvalidInput);
}

TEST(ConjugateGradient, SolvesLikeADirectMethod) {
  const Problem p = ring(40, 4);
  ConjugateGradient solver;
  std::vector<Vec3> x;
  solver.solve(p.matrix, p.right, 1e-12, 1000, x);
  const Eigen::VectorXd expected = dense(p.matrix).llt().solve(flat(p.right));
  EXPECT_LT((flat(x) - expected).norm(), 1e-10 * expected.norm());
}

TEST(ConjugateGradient, ReachesTheAskedTolerance) {
  const Problem p = ring(40, 5);
  ConjugateGradient solver;
  std::vector<Vec3> x;
  const int loose = solver.solve(p.matrix, p.right, 1e-2, 1000, x);
  // The preconditioner is within 4 .. 10 of a multiple of the identity: norms differ by less.
  EXPECT_LT((dense(p.matrix) * flat(x) - flat(p.right)).norm(), 2e-2 * flat(p.right).norm());
  const int strict = solver.solve(p.matrix, p.right, 1e-10, 1000, x);
  EXPECT_GT(strict, loose);
}

TEST(ConjugateGradient, StopsAfterTheIterationsGiven) {
  const Problem p = ring(40, 6);
  ConjugateGradient solver;
  std::vector<Vec3> x;
  EXPECT_EQ(solver.solve(p.matrix, p.right, 1e-12, 3, x), 3);
  EXPECT_LT((dense(p.matrix) * flat(x) - flat(p.right)).norm(), flat(p.right).norm());
}

TEST(ConjugateGradient, AnswersZeroWithZero) {
  const Problem p = ring(5, 7);
  ConjugateGradient solver;
  std::vector<Vec3> x;
  EXPECT_EQ(solver.solve(p.matrix, std::vector<Vec3>(5, Vec3::Zero()), 1e-2, 10, x), 0);
  EXPECT_EQ(flat(x).norm(), 0);
}

}  // namespace
}  // namespace regarment
