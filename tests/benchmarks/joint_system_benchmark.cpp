// Prints how long one step's system of the joint fit takes to solve in four ways, for garments as
// fine as the fit's levels: the system has springs, the scan's pull across the cloth and a weak
// pull to where each particle is, and one right-hand side per dimension and one more.
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "base/stopwatch.h"
#include "bench/step_system.h"
#include "garment/find_template.h"

namespace {

using namespace regarment;
using Sparse = Eigen::SparseMatrix<double>;

constexpr double kExact = 1e-6;    // of the right-hand side, where iterations end
constexpr int kMostRounds = 1000;  // of iterations

/// n x n: the system with the full pull in all directions, whatever they are.
Sparse constant_matrix(const JointModel& model) {
  const int n = model.pattern().particle_count;
  std::vector<Eigen::Triplet<double>> all;
  for (std::size_t s = 0; s < model.springs().size(); ++s) {
    const auto [a, b] = std::pair(model.springs()[s].particle_a, model.springs()[s].particle_b);
    const double w = model.spring_weight(s);
    all.emplace_back(a, a, w), all.emplace_back(b, b, w);
    all.emplace_back(a, b, -w), all.emplace_back(b, a, -w);
  }
  for (int i = 0; i < n; ++i)
    all.emplace_back(i, i,
                     model.particle_areas()[i] / model.scales().patch * (kStepAcross + kStepPull));
  Sparse out(n, n);
  out.setFromTriplets(all.begin(), all.end());
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
int moved_targets(const StepSystem& p, const Even& even, const Eigen::VectorXd& b,
                  Eigen::VectorXd& x) {
  x.setZero(b.size());
  for (int round = 0; round < kMostRounds; ++round) {
    const Eigen::VectorXd rest = b - p.matrix * x;
    if (rest.norm() < kExact * b.norm()) return round;
    x += even.solve(rest);
  }
  return kMostRounds;
}

int conjugate_gradients(const StepSystem& p, const Even& even, const Eigen::VectorXd& b,
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

using Iterate = int (*)(const StepSystem&, const Even&, const Eigen::VectorXd&, Eigen::VectorXd&);

void iterate(const char* what, Iterate how, const StepSystem& p, const Even& even,
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
  const StepSystem p = step_system(model);
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
  const Even even(constant_matrix(model));
  iterate("constant, conjugate gradients", conjugate_gradients, p, even, same);
  iterate("constant, moved targets", moved_targets, p, even, same);
}

}  // namespace

int main() {
  for (const char* name : {"skirt", "tshirt"})
    for (const double edge_length : {0.05, 0.02}) compare(find_template(name), edge_length);
}
