#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace regarment {

/// The options of a job as words for the command line: {"method": "direct", "seed": 7, "fix":
/// {"length": 54}, "collisions": true} becomes --method=direct --seed=7 --fix=length=54
/// --collisions, in the order given. Names are those of the command line without dashes, "_" for
/// "-" where one likes. `fix` and `hint` are an object of numbers, or text as on the command line;
/// switches are true or false. Options that name files, choose the output or speak of threads are
/// not among them: the service decides these. Throws UsageError naming the option and what it may
/// be; whether a value is in range is for the command line to say.
std::vector<std::string> option_words(std::string_view json);

/// The names there are, sorted, for a message and the API's description.
std::vector<std::string> job_option_names();

}  // namespace regarment
