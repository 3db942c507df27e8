#pragma once

#include <string>

#include "scan/person_likeness.h"

namespace regarment {

/// The unit of a file's numbers.
struct FileUnit {
  std::string name;     // "mm", "cm", "m" or "inch"
  double metres = 1.0;  // one file unit, m
  std::string doubt;    // why it may be another, for a person; empty when sure
};

/// Metres of a unit by name. Throws UsageError for anything but "mm", "cm", "m" and "inch".
double metres_of(const std::string& unit);

/// The unit in which a person of `height` file units is 0.5 to 2.3 m tall. Centimetres and inches
/// overlap (a child of 0.5 to 0.9 m or an adult): the proportions of the head decide, and that is
/// said. Throws NoPersonError when no unit fits.
FileUnit find_unit(double height, const PersonLikeness& likeness);

/// A unit someone has given. Throws NoPersonError when a body of that height is no person at all.
FileUnit given_unit(const std::string& unit, double height);

}  // namespace regarment
