#pragma once

#include <cstdint>
#include <vector>

#include "drape/attraction.h"

namespace regarment {

/// Finds particles that keep changing their mind. Where two parts of the scan face each other,
/// where the cloth is crumpled, or at the border of a hole, the closest allowed point may jump to
/// and fro as the particle moves, and the cloth would never rest. After its first doubt, a jump or
/// a turning back by more than a trembling, a particle goes to the closest point whatever it faces;
/// each further one halves how strongly it is pulled for the rest of the drape, so that its
/// neighbours decide where it goes. A few particles in a hundred are concerned.
class Hesitation {
 public:
  /// Both as they are at the start, one entry per particle.
  Hesitation(std::vector<Vec3> positions, std::vector<Attraction> targets);

  /// Sets the weights of the targets found after a step.
  void weigh(const std::vector<Vec3>& positions, std::vector<Attraction>& targets);

  /// Which particles go to the closest point whatever they face, for `attract`.
  const std::vector<std::uint8_t>& any_side() const { return doubted_; }

 private:
  std::vector<Vec3> positions_, moves_;  // after and in the step before
  std::vector<Attraction> targets_;
  std::vector<std::uint8_t> doubted_;  // 1 after the first doubt
  int steps_ = 0;
};

}  // namespace regarment
