#pragma once

#include "app/command_line.h"

namespace regarment {

/// What a command line that could be read may still say wrongly: empty paths, options taken for
/// values, what does not go together. Throw UsageError.
void check(const FitArguments& a);
void check(const RefitArguments& a);
void check(const EvaluateArguments& a);
void check(const BatchArguments& a);
void check(const BatchTaskArguments& a);
void check(const SynthesizeArguments& a);
void check(const ReportArguments& a);
void check(const ReviewArguments& a);
void check(const RenderArguments& a);

}  // namespace regarment
