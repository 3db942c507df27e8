#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace regarment {

/// The options of a job as words for the command line: {"method": "direct", "seed": 7, "fix":
/// {"length": 54}, "collisions": true} becomes --method direct --seed 7 --fix length=54
/// --collisions. Names are those of the command line without dashes; "-" may be "_". Options that
/// name files, choose the output or speak of threads are refused, since the service decides these.
/// Throws UsageError naming the option and its value. Ranges of values are for the command line.
std::vector<std::string> option_words(std::string_view json);

/// The names there are, sorted, for a message and the API's description.
std::vector<std::string> job_option_names();

}  // namespace regarment
