// Fits a skirt to a scan and prints its flat sizes: fit_a_scan SCAN
#include <cstdio>

#include "analysis/analyze.h"
#include "base/error.h"
#include "garment/find_template.h"
#include "scan/make_scan.h"
#include "scan/read_sandboxed.h"

int main(int argc, char** argv) try {
  if (argc != 2) throw regarment::UsageError("usage: fit_a_scan SCAN");
  regarment::AnalyzeOptions options;
  options.method = regarment::Method::Joint;
  const auto found =
      regarment::analyze(regarment::make_scan(regarment::read_mesh_sandboxed(argv[1]).mesh),
                         {regarment::find_template("skirt")}, options);
  for (const auto& m : found.garments.front().measurements)
    std::printf("%-8s %6.1f cm, %.1f to %.1f\n", m.name.c_str(), 100 * m.flat, 100 * m.low,
                100 * m.high);
} catch (const regarment::Error& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return error.exit_status();
}
