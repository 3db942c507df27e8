#include "app/synthesize_options.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <thread>

#include "app/one_each.h"

namespace regarment {
namespace {

std::optional<ScanKind> kind_of(const std::string& name) {
  for (const ScanKind kind : {ScanKind::Cloud, ScanKind::OpenMesh, ScanKind::ClosedMesh}) {
    if (name == kind_name(kind)) return kind;
  }
  return {};
}

}  // namespace

void add_synthesize_options(CLI::App& synthesize, SynthesizeArguments& a) {
  synthesize.add_option("--out", a.out, "Folder for scans and truth")->required();
  synthesize.add_flag("--force", a.force, "Replace a folder that is not empty");
  synthesize.add_option("--cases", a.cases, "How many people to make")
      ->check(CLI::Range(1, 100000))
      ->capture_default_str();
  synthesize.add_option("--first", a.first, "Number of the first case")
      ->check(CLI::Range(0, 10000000))
      ->capture_default_str();
  one_each(
      synthesize.add_option("--garment", a.garments,
                            "Only people who wear this: skirt or tshirt; repeat, outermost first"));
  synthesize.add_option("--kind", a.kind, "What the scans are: cloud, open, closed or all")
      ->check(CLI::IsMember({"cloud", "open", "closed", "all"}))
      ->capture_default_str();
  synthesize
      .add_option("--threads", a.threads,
                  "Cases in the making at once; as many as there are cores by default")
      ->check(CLI::Range(1, 256));
}

SynthesizeOptions synthesize_options(const SynthesizeArguments& a) {
  SynthesizeOptions how;
  how.seed = a.seed;
  how.first = static_cast<std::uint32_t>(a.first);
  how.cases = a.cases;
  how.threads = a.threads;
  if (how.threads == 0) {
    how.threads = static_cast<int>(std::clamp(std::thread::hardware_concurrency(), 1U, 256U));
  }
  how.wish.garments = a.garments;
  how.wish.kind = kind_of(a.kind);
  check_wish(how.wish);
  return how;
}

}  // namespace regarment
