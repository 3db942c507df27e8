#include "analysis/advice.h"

#include <cmath>
#include <optional>
#include <string>

namespace regarment {
namespace {

// Shares of the height. Armpits are at 0.72 to 0.77 of it, crotches at 0.44 to 0.5.
constexpr double kBelowArmpits = 0.69, kFingertips = 0.36;
constexpr double kBelowCrotch = 0.40;
constexpr double kLeastContact = 0.03;  // m of height

std::string whole_cm(double metres) { return std::to_string(std::lround(100 * metres)); }

struct Contact {
  double low = 0.0, high = 0.0;  // m above the floor
};

/// The longest run of levels below the armpits at which an arm and the torso are one.
std::optional<Contact> arm_contact(const Body& body, int side) {
  std::optional<Contact> longest, run;
  for (const TrunkLevel& level : body.trunk) {
    const bool reachable =
        level.y > kFingertips * body.height && level.y < kBelowArmpits * body.height;
    const bool joined = side == 0 ? level.left_arm_joined : level.right_arm_joined;
    if (!reachable || !level.present || !joined) {
      run.reset();
      continue;
    }
    if (!run) run = Contact{level.y - body.slice_height / 2, 0};
    run->high = level.y + body.slice_height / 2;
    if (!longest || run->high - run->low > longest->high - longest->low) longest = run;
  }
  if (longest && longest->high - longest->low < kLeastContact) return std::nullopt;
  return longest;
}

}  // namespace

std::vector<Finding> advise(const Body& body) {
  std::vector<Finding> findings;
  for (const int side : {0, 1}) {
    const std::string arm = std::string("The ") + (side == 0 ? "left" : "right") + " arm";
    if (const auto contact = arm_contact(body, side)) {
      findings.push_back({"arm_touches_torso", Severity::Advice,
                          arm + " touches the torso (from " + whole_cm(contact->low) + " to " +
                              whole_cm(contact->high) + " cm above the floor)",
                          "The torso is cut off there at the width it has below",
                          "Scan again with the arms held out"});
    } else if (!body.arms[static_cast<std::size_t>(side)].present()) {
      findings.push_back({"arm_touches_torso", Severity::Advice,
                          arm + " is not seen apart from the torso", "",
                          "Scan again with the arms held out"});
    }
  }
  if (!body.fork_is_garment && body.fork > 0 && body.fork < kBelowCrotch * body.height) {
    findings.push_back({"legs_touch", Severity::Advice,
                        "The legs touch from " + whole_cm(body.fork) + " cm above the floor up", "",
                        "Scan again with the feet apart"});
  }
  return findings;
}

}  // namespace regarment
