#pragma once

#include "app/command_line.h"
#include "synthetic/synthesize.h"

namespace CLI {
class App;
}

namespace regarment {

/// Declares the options of `synthesize`.
void add_synthesize_options(CLI::App& synthesize, SynthesizeArguments& a);

/// What the arguments ask for. Throws UsageError for garments nobody wears together.
SynthesizeOptions synthesize_options(const SynthesizeArguments& a);

}  // namespace regarment
