#include "drape/drape.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "drape/attraction_force.h"
#include "drape/bending_force.h"
#include "drape/contact_force.h"
#include "drape/hesitation.h"
#include "drape/spring_force.h"
#include "drape/time_step.h"

namespace regarment {
namespace {

constexpr double kGrow = 1.5;    // of the step's time after an accepted step
constexpr double kShrink = 0.5;  // after a rejected one
constexpr int kCalmSteps = 3;    // in a row make a rest

/// What the scan does to the cloth where it lies now.
struct Surroundings {
  std::vector<Attraction> targets;
  std::vector<Contact> contacts;  // empty without collisions
};

Surroundings look_around(const Cloth& cloth, const ClosestPoint& scan, const DrapeOptions& options,
                         const std::vector<std::uint8_t>& any_side,
                         const std::vector<float>& shares) {
  Surroundings around;
  around.targets = attract(cloth, scan, options.attraction, any_side, shares);
  if (options.collisions) around.contacts = find_contacts(cloth, scan);
  return around;
}

/// All forces on the cloth and how they change.
void sum_forces(const Cloth& cloth, const Surroundings& around, const DrapeOptions& options,
                std::vector<Vec3>& forces, ForceJacobian& jacobian) {
  for (std::size_t i = 0; i < cloth.size(); ++i)
    forces[i] = Vec3(0, -options.gravity * cloth.masses[i], 0);
  jacobian.set_zero();
  const auto add = [&](const auto& force) {
    force.add_forces(cloth, forces);
    force.add_jacobian(cloth, jacobian);
  };
  add(SpringForce{options.spring_stiffness, options.spring_damping});
  add(BendingForce{options.bending_stiffness, options.bending_damping});
  add(AttractionForce{options.attraction_stiffness, options.attraction_grip, around.targets});
  if (options.collisions)
    add(ContactForce{options.contact_stiffness, options.contact_thickness, around.contacts});
}

double largest_norm(const std::vector<Vec3>& vectors) {
  double largest = 0;
  for (const Vec3& v : vectors) largest = std::max(largest, v.squaredNorm());
  return std::sqrt(largest);
}

double root_mean_square(const std::vector<Vec3>& vectors) {
  double sum = 0;
  for (const Vec3& v : vectors) sum += v.squaredNorm();
  return std::sqrt(sum / static_cast<double>(vectors.size()));
}

/// Did a step move the cloth so little that the forces it was made from still hold? False also for
/// anything that is not a number.
bool acceptable(const Cloth& before, const Cloth& after, const DrapeOptions& options) {
  for (std::size_t i = 0; i < after.size(); ++i)
    if (!((after.positions[i] - before.positions[i]).norm() <= options.largest_move)) return false;
  return std::abs(mean_stretch(after) - mean_stretch(before)) <= options.largest_stretch_change;
}

/// Where no step is short enough: each particle goes in its direction as far as it may, and stops.
void creep(const Cloth& before, const DrapeOptions& options, Cloth& after) {
  for (std::size_t i = 0; i < after.size(); ++i) {
    const Vec3 move = after.positions[i] - before.positions[i];
    const double length = move.norm();
    const double share = length > options.largest_move ? options.largest_move / length : 1;
    after.positions[i] = before.positions[i];
    if (move.allFinite()) after.positions[i] += share * move;
    after.velocities[i].setZero();
  }
}

/// Counts the steps in a row in which nothing went on.
class RestWatch {
 public:
  RestWatch(const DrapeOptions& options, const DrapeOutcome& start)
      : options_(options), last_(start) {}

  void observe(const DrapeOutcome& now, double h) {
    const bool calm =
        h >= options_.first_step && now.mean_speed < options_.rest_speed &&
        std::abs(now.mean_distance - last_.mean_distance) < options_.rest_distance_change &&
        std::abs(now.mean_stretch - last_.mean_stretch) < options_.rest_stretch_change;
    calm_steps_ = calm ? calm_steps_ + 1 : 0;
    last_ = now;
  }

  bool settled() const { return calm_steps_ >= kCalmSteps; }

 private:
  const DrapeOptions& options_;
  DrapeOutcome last_;
  int calm_steps_ = 0;
};

void judge(const Cloth& cloth, const Surroundings& around, DrapeOutcome& outcome) {
  outcome.mean_speed = root_mean_square(cloth.velocities);
  outcome.largest_speed = largest_norm(cloth.velocities);
  outcome.mean_distance = mean_distance(around.targets);
  outcome.mean_stretch = mean_stretch(cloth);
}

/// Moves the cloth by one step, of at most `h` seconds; shortens `h` until the step is acceptable.
/// Returns how many times it was repeated.
int move_cloth(const std::vector<Vec3>& forces, const ForceJacobian& jacobian,
               const DrapeOptions& options, TimeStep& time_step, double& h, Cloth& cloth) {
  const Cloth before = cloth;
  for (int rejected = 0;; ++rejected) {
    cloth = before;
    advance(cloth, time_step.velocity_change(before, forces, jacobian, h, options.solver_tolerance),
            h);
    if (acceptable(before, cloth, options)) return rejected;
    if (h <= options.least_step) {
      creep(before, options, cloth);
      return rejected;
    }
    h = std::max(options.least_step, kShrink * h);
  }
}

}  // namespace

DrapeOutcome drape(Cloth& cloth, const ClosestPoint& scan, const DrapeOptions& options,
                   const Progress& progress, const std::vector<HeldEdge>& held,
                   const std::vector<float>& shares) {
  options.check();
  cloth.check();
  if (scan.empty()) throw InvalidInput("drape: the scan is empty, there is nothing to lie on");
  std::vector<Vec3> forces(cloth.size());
  ForceJacobian jacobian = make_jacobian(cloth);
  TimeStep time_step(cloth);
  Surroundings around = look_around(cloth, scan, options, {}, shares);
  Hesitation hesitation(cloth.positions, around.targets);
  hold(held, cloth, around.targets);
  DrapeOutcome outcome;
  judge(cloth, around, outcome);
  RestWatch rest(options, outcome);
  double h = options.first_step;
  while (!rest.settled() && outcome.steps < options.max_steps) {
    progress.report("drape", static_cast<double>(outcome.steps) / options.max_steps);
    sum_forces(cloth, around, options, forces, jacobian);
    outcome.rejected += move_cloth(forces, jacobian, options, time_step, h, cloth);
    ++outcome.steps;
    around = look_around(cloth, scan, options, hesitation.any_side(), shares);
    if (options.hesitation) hesitation.weigh(cloth.positions, around.targets);
    hold(held, cloth, around.targets);
    judge(cloth, around, outcome);
    rest.observe(outcome, h);
    h = std::min(options.largest_step, kGrow * h);
  }
  outcome.ending = rest.settled() ? DrapeEnding::CameToRest : DrapeEnding::StepLimit;
  return outcome;
}

}  // namespace regarment
