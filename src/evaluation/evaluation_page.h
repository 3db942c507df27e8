#pragma once

#include <string>
#include <vector>

#include "evaluation/evaluation.h"

namespace regarment {

/// The page of an evaluation as one HTML file that requests nothing and needs no script. Depends
/// on its argument alone.
std::string evaluation_page(const Evaluation& evaluation);

/// The scans the page shows first: at most twelve, those with the largest mean absolute error
/// first, into Evaluation::scans. Failed ones are not among them.
std::vector<std::size_t> worst_scans(const Evaluation& evaluation);

}  // namespace regarment
