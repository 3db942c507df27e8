#include "joint/length_evidence.h"

namespace regarment {
namespace {

constexpr double kSlopeStep = 1e-6;  // m

}  // namespace

std::vector<LengthEvidence> length_evidence(const GarmentTemplate& garment, const Dimensions& at,
                                            const std::vector<MeasuredLength>& lengths) {
  std::vector<LengthEvidence> out;
  for (const MeasuredLength& m : lengths) {
    LengthEvidence e{m.value, m.standard_deviation, garment.evaluate(m.formula, at), {}};
    e.slope.resize(static_cast<Eigen::Index>(garment.dimensions().size()));
    Eigen::Index k = 0;
    for (const Dimension& d : garment.dimensions()) {
      Dimensions moved = at;
      moved[d.name] += kSlopeStep;
      e.slope[k++] = (garment.evaluate(m.formula, moved) - e.at_model) / kSlopeStep;
    }
    out.push_back(std::move(e));
  }
  return out;
}

}  // namespace regarment
