#include "app/bench_options.h"

#include <CLI/CLI.hpp>

#include "app/one_each.h"
#include "base/error.h"

namespace regarment {

void add_bench_options(CLI::App& bench, BenchArguments& a) {
  bench.add_option("SCAN", a.scan, "What is fitted; a person made for it by default");
  one_each(bench.add_option(
      "--garment", a.garments,
      "Template name or file; repeat for layers, outermost first; skirt by default"));
  bench.add_option(
      "--layers", a.layers,
      "A scan of a T-shirt over a skirt, for the time of two layers; a person made for "
      "it by default. With two --garment SCAN has them itself");
  bench.add_option("--ground-truth", a.ground_truth, "CSV table of SCAN's true dimensions");
  bench.add_option("--out", a.out, "A page with the figures, such as bench.html");
  bench.add_flag("--force", a.force, "Replace a page that is there");
  bench.add_flag("--annealing", a.annealing, "Fit by that method too, which takes minutes");
  bench.add_option("--repeats", a.repeats, "Fits of the scan; their median counts")
      ->check(CLI::Range(1, 100))
      ->capture_default_str();
  bench.add_option("--most-vertices", a.most_vertices, "Of the largest copy of the scan")
      ->check(CLI::Range(1e3, 1e7));
}

void check_bench(const BenchArguments& a) {
  if (a.scan && a.garments.empty())
    throw UsageError("bench: give --garment NAME, what is worn on the scan");
  if (a.garments.size() > 8) throw UsageError("--garment: more than 8 layers; give fewer");
  if (a.layers && a.garments.size() > 1)
    throw UsageError("--layers: SCAN has several garments already; leave one of the two out");
  if (a.ground_truth && !a.scan) throw UsageError("--ground-truth: give its scan as well");
  if (a.out && a.out->empty()) throw UsageError("--out: the value is empty; give a file");
}

}  // namespace regarment
