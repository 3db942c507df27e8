#include "scan/find_units.h"

#include <array>
#include <cstdio>
#include <string_view>
#include <vector>

#include "base/error.h"

namespace regarment {
namespace {

struct Unit {
  std::string_view name;
  double metres;
};
constexpr std::array<Unit, 4> kUnits = {
    {{"m", 1.0}, {"cm", 0.01}, {"mm", 0.001}, {"inch", 0.0254}}};

constexpr double kShortest = 0.5, kTallest = 2.3;             // m, a whole person
constexpr double kShortestGiven = 0.25, kTallestGiven = 3.0;  // m, what one may insist on
// Height of the neck over that of the head's top: an adult's is 0.86 or more, a child's of a metre
// 0.8, a baby's 0.75. The width of the head tells less, because of hair.
constexpr double kChildsNeck = 0.83;

std::string text(double value) {
  std::array<char, 32> buffer{};
  std::snprintf(buffer.data(), buffer.size(), "%.4g", value);
  return buffer.data();
}

}  // namespace

double metres_of(const std::string& unit) {
  for (const Unit& known : kUnits) {
    if (known.name == unit) return known.metres;
  }
  throw UsageError("\"" + unit + "\" is no unit: use mm, cm, m or inch");
}

FileUnit find_unit(double height, const PersonLikeness& likeness) {
  std::vector<Unit> fitting;
  for (const Unit& unit : kUnits) {
    const double metres = height * unit.metres;
    if (metres >= kShortest && metres <= kTallest) fitting.push_back(unit);
  }
  if (fitting.empty()) {
    throw NoPersonError("the body is " + text(height) +
                        " file units tall: no person in m, cm, mm or inch; scale the file, or "
                        "give its unit with --units");
  }
  if (fitting.size() == 1) return {std::string(fitting[0].name), fitting[0].metres, ""};
  // Only centimetres and inches overlap.
  const bool head_seen = likeness.head >= 0.3;
  const bool child = head_seen && likeness.neck_t < kChildsNeck * likeness.head_top_t;
  const Unit& chosen = fitting[child ? 0 : 1];
  return {std::string(chosen.name), chosen.metres,
          "The body is " + text(height) + " file units tall: taken as " +
              (child ? "a child in cm" : "an adult in inch") +
              (head_seen ? " by its proportions" : "")};
}

FileUnit given_unit(const std::string& unit, double height) {
  const double metres = metres_of(unit);
  if (!(height * metres >= kShortestGiven && height * metres <= kTallestGiven)) {
    throw NoPersonError("with --units " + unit + " the body is " + text(height * metres) +
                        " m tall: give another unit, or --units auto");
  }
  return {unit, metres, ""};
}

}  // namespace regarment
