// Prints how long one step's system of the joint fit takes to solve in four ways, for garments as
// fine as the fit's levels: the system has springs, the scan's pull across the cloth and a weak
// pull to where each particle is, and one right-hand side per dimension and one more.
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "base/stopwatch.h"
#include "garment/find_template.h"
#include "joint/block_factor.h"
#include "joint/joint_model.h"

namespace {

using namespace regarment;
using Sparse = Eigen::SparseMatrix<double>;

constexpr double kPull = 400;      // 1/m^2, of a step that may go 5 cm
constexpr double kAcross = 1e6;    // 1/m^2, of a scan known to a millimetre
constexpr double kExact = 1e-6;    // of the right-hand side, where iterations end
constexpr int kMostRounds = 1000;  // of iterations

struct Problem {
  BlockTriangle blocks;
  Sparse matrix;    // 3 n x 3 n, both triangles
  Sparse constant;  // n x n: with the full pull in all directions, whatever they are
  Eigen::MatrixXd right;
};

std::vector<std::array<int, 2>> pairs_of(const JointModel& model) {
  std::vector<std::array<int, 2>> out;
  for (const Spring& s : model.springs()) out.push_back({s.particle_a, s.particle_b});
  return out;
}

/// The garment rolled round a trunk, so that springs and normals point in all directions.
std::vector<Vec3> rolled(const Pattern& pattern) {
  std::vector<Vec3> x(pattern.particle_count);
  for (std::size_t v = 0; v < pattern.flat.size(); ++v) {
    const double phi = pattern.flat[v].x() / 0.16;
    const double side = pattern.panel_is_front[pattern.panel[v]] ? 1 : -1;
    x[pattern.particle[v]] = {0.16 * std::sin(phi), -pattern.flat[v].y(),
                              side * 0.16 * std::cos(phi)};
  }
  return x;
}

Problem problem_of(const JointModel& model) {
  const int n = model.pattern().particle_count;
  Problem out{BlockTriangle(n, pairs_of(model)), Sparse(3 * n, 3 * n), Sparse(n, n), {}};
  const std::vector<Vec3> x = rolled(model.pattern());
  std::vector<Eigen::Triplet<double>> all, even;
  const auto add = [&](int i, int j, const Eigen::Matrix3d& block) {
    out.blocks.add(i, j, block);
    for (int r = 0; r < 3; ++r)
      for (int c = 0; c < 3; ++c) all.emplace_back(3 * i + r, 3 * j + c, block(r, c));
  };
  for (std::size_t s = 0; s < model.springs().size(); ++s) {
    const auto [a, b] = std::pair(model.springs()[s].particle_a, model.springs()[s].particle_b);
    const Vec3 along = (x[b] - x[a]).normalized();
    const double w = model.spring_weight(s);
    const Eigen::Matrix3d block = w * along * along.transpose();
    add(a, a, block), add(b, b, block), add(a, b, -block), add(b, a, -block);
    even.emplace_back(a, a, w), even.emplace_back(b, b, w);
    even.emplace_back(a, b, -w), even.emplace_back(b, a, -w);
  }
  for (int i = 0; i < n; ++i) {
    const Vec3 normal = Vec3(x[i].x(), 0, x[i].z()).normalized();
    const double share = model.particle_areas()[i] / model.scales().patch;
    add(i, i,
        share * (kAcross * normal * normal.transpose() + kPull * Eigen::Matrix3d::Identity()));
    even.emplace_back(i, i, share * (kAcross + kPull));
  }
  out.matrix.setFromTriplets(all.begin(), all.end());
  out.constant.setFromTriplets(even.begin(), even.end());
  const auto columns = static_cast<Eigen::Index>(model.dimension_count()) + 1;
  out.right.resize(3 * n, columns);
  for (Eigen::Index c = 0; c < columns; ++c)
    for (Eigen::Index i = 0; i < 3 * n; ++i)
      out.right(i, c) = std::sin(0.37 * static_cast<double>(i) * static_cast<double>(c + 1));
  return out;
}

/// The constant matrix's solution, each of x, y, z by itself.
class Even {
 public:
  explicit Even(const Sparse& constant) : factor_(constant) {}
  Eigen::VectorXd solve(const Eigen::VectorXd& b) const {
    const Eigen::Map<const Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>> by_particle(
        b.data(), b.size() / 3, 3);
    Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor> x =
        factor_.solve(Eigen::MatrixX3d(by_particle));
    return Eigen::Map<Eigen::VectorXd>(x.data(), b.size());
  }

 private:
  Eigen::SimplicialLDLT<Sparse> factor_;
};

/// Targets moved, the matrix constant [Bouaziz et al. 2014]: x += constant^-1 (b - A x).
int moved_targets(const Problem& p, const Even& even, const Eigen::VectorXd& b,
                  Eigen::VectorXd& x) {
  x.setZero(b.size());
  for (int round = 0; round < kMostRounds; ++round) {
    const Eigen::VectorXd rest = b - p.matrix * x;
    if (rest.norm() < kExact * b.norm()) return round;
    x += even.solve(rest);
  }
  return kMostRounds;
}

int conjugate_gradients(const Problem& p, const Even& even, const Eigen::VectorXd& b,
                        Eigen::VectorXd& x) {
  x.setZero(b.size());
  Eigen::VectorXd rest = b, z = even.solve(rest), way = z;
  double square = rest.dot(z);
  for (int round = 0; round < kMostRounds; ++round) {
    if (rest.norm() < kExact * b.norm()) return round;
    const Eigen::VectorXd along = p.matrix * way;
    const double step = square / way.dot(along);
    x += step * way, rest -= step * along;
    z = even.solve(rest);
    const double next = rest.dot(z);
    way = z + next / square * way, square = next;
  }
  return kMostRounds;
}

void print(const char* what, double seconds, const Eigen::MatrixXd& x, const Eigen::MatrixXd& same,
           int rounds) {
  std::printf("  %-28s %9.2f ms   off by %.1e", what, 1e3 * seconds,
              (x - same).cwiseAbs().maxCoeff() / same.cwiseAbs().maxCoeff());
  if (rounds > 0) std::printf("   %d rounds in all", rounds);
  std::printf("\n");
}

using Iterate = int (*)(const Problem&, const Even&, const Eigen::VectorXd&, Eigen::VectorXd&);

void iterate(const char* what, Iterate how, const Problem& p, const Even& even,
             const Eigen::MatrixXd& same) {
  Stopwatch watch;
  Eigen::MatrixXd x(p.right.rows(), p.right.cols());
  int rounds = 0;
  for (Eigen::Index c = 0; c < x.cols(); ++c) {
    Eigen::VectorXd one;
    rounds += how(p, even, p.right.col(c), one);
    x.col(c) = one;
  }
  print(what, watch.lap(), x, same, rounds);
}

void compare(const GarmentTemplate& garment, double edge_length) {
  const JointModel model(garment, garment.typical(), edge_length, JointScales{});
  const Problem p = problem_of(model);
  std::printf("%s, %d particles, %d right-hand sides\n", garment.name().c_str(),
              model.pattern().particle_count, static_cast<int>(p.right.cols()));
  Eigen::SimplicialLDLT<Sparse> scalar;
  scalar.analyzePattern(p.matrix);
  Stopwatch watch;
  scalar.factorize(p.matrix);
  const Eigen::MatrixXd same = scalar.solve(p.right);
  print("factor, scalar (Eigen)", watch.lap(), same, same, 0);
  BlockFactor blocks(p.blocks);
  watch.lap();
  if (!blocks.factorize(p.blocks)) return;
  const Eigen::MatrixXd x = blocks.solve(p.right);
  print("factor, 3 x 3 blocks", watch.lap(), x, same, 0);
  const Even even(p.constant);
  iterate("constant, conjugate gradients", conjugate_gradients, p, even, same);
  iterate("constant, moved targets", moved_targets, p, even, same);
}

}  // namespace

int main() {
  for (const char* name : {"skirt", "tshirt"})
    for (const double edge_length : {0.05, 0.02}) compare(find_template(name), edge_length);
}
