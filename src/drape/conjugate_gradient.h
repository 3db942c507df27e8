#pragma once

#include <vector>

#include "drape/force_jacobian.h"

namespace regarment {

/// Solves A x = b for a positive definite A by conjugate gradients, preconditioned by the inverses
/// of the diagonal blocks. A sparse LDLT of the same matrices takes 40 times as long (1,000 and
/// 3,000 particles), since a drape's steps need two digits only. Keeps its vectors from call to
/// call. One thread at a time.
class ConjugateGradient {
 public:
  /// Starts at x = 0 and stops when the preconditioned residual has fallen to `tolerance` of what
  /// it was, or after `most_iterations`; what is reached by then is a step downhill in any case.
  /// Returns the iterations made. `x` and `b`: n.
  int solve(const BlockMatrix& a, const std::vector<Vec3>& b, double tolerance, int most_iterations,
            std::vector<Vec3>& x);

 private:
  std::vector<Mat3> inverse_;
  std::vector<Vec3> residual_, preconditioned_, direction_, image_;
};

}  // namespace regarment
