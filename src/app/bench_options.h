#pragma once

#include "app/command_line.h"

namespace CLI {
class App;
}

namespace regarment {

/// Adds what `regarment bench` can be told. Afterwards check_bench().
void add_bench_options(CLI::App& bench, BenchArguments& a);

/// Throws UsageError for what does not go together.
void check_bench(const BenchArguments& a);

}  // namespace regarment
