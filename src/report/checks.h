#pragma once

#include <string>
#include <vector>

#include "report/result.h"

namespace regarment {

enum class CheckLevel { Good, Look, Poor };  // from best to worst

/// One light of the verdict. Texts may come from outside and are not escaped.
struct Check {
  CheckLevel level = CheckLevel::Good;
  std::string name;       // "Skirt on the scan"
  std::string found;      // "95 % of it within 0.7 mm"
  std::string threshold;  // "Good up to 5 mm, poor beyond 10 mm."
  std::string advice;     // what to do, empty when all is good
  std::string place;      // id of the section of the page that shows more
};

/// What the verdict rests on, in the order a reader asks: what was measured, how surely, how it
/// compares with the specification, how well garment and scan agree, the labels, the scan. Checks
/// without their data (a method that drapes nothing, no truth) are left out.
std::vector<Check> checks_of(const Result& result);

/// The worst level among them; Good for none.
CheckLevel worst_level(const std::vector<Check>& checks);

}  // namespace regarment
