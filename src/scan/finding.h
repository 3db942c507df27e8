#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace regarment {

/// How much a finding matters.
enum class Severity {
  Note,     // seen and dealt with; the result does not suffer
  Advice,   // the result may suffer, a person can do better
  Problem,  // a part of the result is likely to be wrong
};

/// "note", "advice", "problem".
std::string_view severity_name(Severity severity);

/// The severity of that name. Throws InvalidInput for another.
Severity severity_named(std::string_view name);

/// Something that was noticed about a scan. Sentences for a person begin with a capital letter and
/// have no full stop; those with nothing to say are empty.
struct Finding {
  // Stable, for programs: "floor", "wall", "post", "island", "outliers", "not_a_number",
  // "duplicates", "zero_area", "non_manifold", "mixed_normals", "inward_normals",
  // "replaced_normals", "far_from_origin", "sparse", "noisy", "coarsened",
  // "invented_surface", "tilted", "missing_head", "unsure_up", "unsure_front", "unsure_units",
  // "uneven_sides", "arm_touches_torso", "legs_touch".
  std::string code;
  Severity severity = Severity::Note;
  std::string found;   // what, with count or share
  std::string done;    // what was done about it
  std::string advice;  // what a person can do
};

/// "1 face", "12 faces".
std::string counted(std::size_t count, const std::string& thing, const std::string& things);

/// "0.4 %": a share in a hundred; below 0.1 "less than 0.1 %".
std::string percent(double share);

}  // namespace regarment
