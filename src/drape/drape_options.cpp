#include <cmath>
#include <sstream>

#include "base/error.h"
#include "drape/drape.h"

namespace regarment {
namespace {

void need(bool good, const char* field, double value, const char* rule) {
  if (good && std::isfinite(value)) return;
  std::ostringstream text;
  text << "DrapeOptions: " << field << " must " << rule << ", not " << value;
  throw InvalidInput(text.str());
}

void positive(const char* field, double value) {
  need(value > 0, field, value, "be a positive number");
}

void not_negative(const char* field, double value) {
  need(value >= 0, field, value, "be zero or a positive number");
}

}  // namespace

void DrapeOptions::check() const {
  not_negative("spring_stiffness", spring_stiffness);
  not_negative("spring_damping", spring_damping);
  not_negative("bending_stiffness", bending_stiffness);
  not_negative("bending_damping", bending_damping);
  not_negative("attraction_stiffness", attraction_stiffness);
  need(attraction_grip >= 0 && attraction_grip <= 1, "attraction_grip", attraction_grip,
       "lie between 0 and 1");
  attraction.check();
  need(true, "gravity", gravity, "be a number");
  not_negative("contact_stiffness", contact_stiffness);
  not_negative("contact_thickness", contact_thickness);
  positive("least_step", least_step);
  need(first_step >= least_step, "first_step", first_step, "be at least least_step");
  need(largest_step >= first_step, "largest_step", largest_step, "be at least first_step");
  positive("largest_move", largest_move);
  positive("largest_stretch_change", largest_stretch_change);
  need(solver_tolerance > 0 && solver_tolerance < 1, "solver_tolerance", solver_tolerance,
       "lie between 0 and 1");
  need(max_steps >= 1, "max_steps", max_steps, "be at least 1");
  positive("rest_speed", rest_speed);
  positive("rest_distance_change", rest_distance_change);
  positive("rest_stretch_change", rest_stretch_change);
}

}  // namespace regarment
