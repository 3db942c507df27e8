#include "joint/block_factor.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include "base/random.h"

namespace regarment {
namespace {

/// Springs between neighbours of a grid with random directions, and a weak pull to where each is.
struct Problem {
  BlockTriangle blocks;
  Eigen::MatrixXd dense;

  Problem(int width, int height, double pull)
      : blocks(width * height, pairs(width, height)),
        dense(Eigen::MatrixXd::Zero(Eigen::Index{3} * width * height,
                                    Eigen::Index{3} * width * height)) {
    Random random(7);
    const auto add = [&](int i, int j, const Eigen::Matrix3d& block) {
      blocks.add(i, j, block);
      dense.block<3, 3>(Eigen::Index{3} * i, Eigen::Index{3} * j) += block;
    };
    for (const auto& [a, b] : pairs(width, height)) {
      Eigen::Matrix3d root;
      for (int r = 0; r < 3; ++r)
        for (int c = 0; c < 3; ++c) root(r, c) = random.uniform() - 0.5;
      const Eigen::Matrix3d block = root * root.transpose();
      add(a, a, block), add(b, b, block);
      // Neither symmetric nor the same both ways round, as blocks between particles may be.
      add(b, a, 0.5 * root), add(a, b, 0.5 * root.transpose());
    }
    for (int i = 0; i < width * height; ++i) add(i, i, pull * Eigen::Matrix3d::Identity());
  }

  static std::vector<std::array<int, 2>> pairs(int width, int height) {
    std::vector<std::array<int, 2>> out;
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) {
        const int i = y * width + x;
        if (x > 0) out.push_back({i, i - 1});
        if (y > 0) out.push_back({i - width, i});
      }
    return out;
  }
};

TEST(BlockFactor, SolvesAsADenseMatrixDoes) {
  const Problem problem(9, 7, 4.0);
  BlockFactor factor(problem.blocks);
  ASSERT_TRUE(factor.factorize(problem.blocks));
  // Columns are solved four to a register, and sixteen at once.
  for (const int columns : {1, 3, 4, 5, 12, 13, 16, 17, 40}) {
    const Eigen::MatrixXd b = Eigen::MatrixXd::Random(problem.dense.rows(), columns);
    const Eigen::MatrixXd x = factor.solve(b);
    ASSERT_EQ(x.cols(), columns);
    EXPECT_LT((problem.dense * x - b).cwiseAbs().maxCoeff(), 1e-11) << columns << " columns";
  }
  EXPECT_EQ(factor.solve(Eigen::MatrixXd(problem.dense.rows(), 0)).cols(), 0);
}

TEST(BlockFactor, SolvesAColumnTheSameAmongOthersAsAlone) {
  const Problem problem(9, 7, 4.0);
  BlockFactor factor(problem.blocks);
  ASSERT_TRUE(factor.factorize(problem.blocks));
  const Eigen::MatrixXd b = Eigen::MatrixXd::Random(problem.dense.rows(), 11);
  const Eigen::MatrixXd together = factor.solve(b);
  for (Eigen::Index c = 0; c < b.cols(); ++c) EXPECT_EQ(factor.solve(b.col(c)), together.col(c));
}

TEST(BlockFactor, TakesOtherFiguresOfTheSameStructure) {
  const Problem first(6, 5, 4.0), second(6, 5, 9.0);
  BlockFactor factor(first.blocks);
  ASSERT_TRUE(factor.factorize(first.blocks));
  ASSERT_TRUE(factor.factorize(second.blocks));
  const Eigen::MatrixXd b = Eigen::MatrixXd::Ones(second.dense.rows(), 1);
  EXPECT_LT((second.dense * factor.solve(b) - b).cwiseAbs().maxCoeff(), 1e-11);
}

TEST(BlockFactor, SaysWhenAMatrixIsNotPositiveDefinite) {
  const Problem good(6, 5, 4.0), bad(6, 5, -4.0);
  BlockFactor factor(good.blocks);
  EXPECT_FALSE(factor.factorize(bad.blocks));
  // And is as good as new afterwards.
  ASSERT_TRUE(factor.factorize(good.blocks));
  const Eigen::MatrixXd b = Eigen::MatrixXd::Ones(good.dense.rows(), 1);
  EXPECT_LT((good.dense * factor.solve(b) - b).cwiseAbs().maxCoeff(), 1e-11);
}

TEST(BlockTriangle, LeavesOutMirrorImages) {
  BlockTriangle matrix(2, {{1, 0}, {0, 1}});
  ASSERT_EQ(matrix.row.size(), 1U);
  matrix.add(0, 1, Eigen::Matrix3d::Ones());
  EXPECT_TRUE(matrix.below[0].isZero());
  matrix.add(1, 0, Eigen::Matrix3d::Ones());
  EXPECT_EQ(matrix.below[0].sum(), 9);
  matrix.set_zero();
  EXPECT_TRUE(matrix.below[0].isZero());
}

}  // namespace
}  // namespace regarment
