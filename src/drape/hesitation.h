#pragma once

#include <vector>

#include "drape/attraction.h"

namespace regarment {

/// Finds particles that keep changing their mind. Where two parts of the scan face each other, or
/// at the border of a hole, the closest allowed point may jump to and fro as the particle moves,
/// and the cloth would never rest. Each jump, and each turning back by more than a trembling,
/// halves how strongly such a particle is pulled for the rest of the drape: its neighbours decide
/// where it goes. About one particle in a hundred is concerned.
class Hesitation {
 public:
  /// Both as they are at the start, one entry per particle.
  Hesitation(std::vector<Vec3> positions, std::vector<Attraction> targets);

  /// Sets the weights of the targets found after a step.
  void weigh(const std::vector<Vec3>& positions, std::vector<Attraction>& targets);

 private:
  std::vector<Vec3> positions_, moves_;  // after and in the step before
  std::vector<Attraction> targets_;
  int steps_ = 0;
};

}  // namespace regarment
