#pragma once

#include "scan/body_slices.h"

namespace regarment {

/// How much a shape, cut across a direction, looks like a person whose head is at the top. Only
/// proportions count, no unit. Each cue runs from 0 (absent) to 1 (clear).
struct PersonLikeness {
  double head = 0.0;      // a compact piece at a tip, on a narrower neck, over wide shoulders
  double legs = 0.0;      // two pieces alike over the lower part
  double arms = 0.0;      // a piece on either side of the middle one
  double spread = 0.0;    // -1..1: the bottom stands wider than the top
  double too_wide = 0.0;  // penalty for a footprint no person has, 0..5

  double neck_t = 0.0;      // height of the neck, where head > 0
  double head_top_t = 0.0;  // height of the head's top, where head > 0
  double head_width = 0.0;  // in body heights, where head > 0

  double total() const { return 3 * head + 2 * legs + arms + spread - too_wide; }

  /// Whether enough independent cues agree to speak of a person. Lenient: a head or legs may be
  /// missing.
  bool is_person() const;
};

PersonLikeness judge_person(const BodySlices& slices);

}  // namespace regarment
