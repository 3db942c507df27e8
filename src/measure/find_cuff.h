#pragma once

#include <optional>
#include <string>

#include "measure/edge_choice.h"

namespace regarment {

/// The stretch of an arm's axis where a cuff may be, m.
struct ArmStretch {
  double s_low = 0, s_high = 0;
};

/// Looks for the edge `name` of a sleeve on the arm `limb`, whose view this is. `said`: the mean
/// height of the cuff above the floor (m) that a person gave: it is looked for within 3 cm of that
/// place along the arm and taken from there in any case; what the whole arm shows best remains its
/// `clearest` place. Nothing when the arm is too short.
/// Throws UsageError when the arm has nothing at such a height, or is held so level there that the
/// height does not say where.
std::optional<Cuff> find_cuff(const LimbView& arm, const std::string& name, const std::string& limb,
                              const ArmStretch& where, const std::optional<double>& said);

}  // namespace regarment
