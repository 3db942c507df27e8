#include <stdlib.h>

#include "app/commands.h"
#include "base/error.h"
#include "base/one_line.h"
#include "bench/bench.h"
#include "report/files.h"
#include "synthetic/synthesize.h"

namespace regarment {
namespace {

namespace fs = std::filesystem;

// An empty folder, removed with everything in it.
class WorkFolder {
 public:
  WorkFolder() {
    std::string name = (fs::temp_directory_path() / "regarment-bench-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr)
      throw TemporaryError(name + ": no folder to work in; is there room, and is TMPDIR right?");
    path_ = name;
  }
  ~WorkFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  WorkFolder(const WorkFolder&) = delete;
  WorkFolder& operator=(const WorkFolder&) = delete;

  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

// A person who wears these garments, as a closed mesh with its truth.
BenchScan make_person(const fs::path& folder, const std::vector<std::string>& garments,
                      const Progress& progress) {
  BenchScan scan{{}, garments};
  SynthesizeOptions options;
  options.cases = 1;
  options.wish.garments = garments;
  options.wish.kind = ScanKind::ClosedMesh;
  const auto take = [&](const std::vector<CaseFile>& files) {
    for (const CaseFile& file : files) {
      fs::create_directories((folder / file.path).parent_path());
      write_file(folder / file.path, file.bytes);
      if (file.path.find(".mesh.ply") != std::string::npos) scan.file = folder / file.path;
    }
  };
  const Synthesis made = synthesize(options, take, progress);
  take(truth_tables(made));
  scan.truth = {"--ground-truth", (folder / "truth" / "ground_truth.csv").string()};
  return scan;
}

// What `a` names, or a person made for it.
BenchScan scan_of(const BenchArguments& a, const fs::path& folder, const Progress& progress) {
  const auto garments = a.garments.empty() ? std::vector<std::string>{"skirt"} : a.garments;
  if (!a.scan) return make_person(folder, garments, progress);
  BenchScan scan{*a.scan, garments};
  if (a.ground_truth) scan.truth = {"--ground-truth", a.ground_truth->string()};
  return scan;
}

// The same with two layers, unless the scan has several already.
std::optional<BenchScan> layers_of(const BenchArguments& a, const fs::path& folder,
                                   const Progress& progress) {
  if (a.garments.size() > 1) return std::nullopt;
  const std::vector<std::string> garments = {"tshirt", "skirt"};
  if (a.layers) return BenchScan{*a.layers, garments};
  return make_person(folder, garments, progress);
}

void check_page(const BenchArguments& a) {
  if (a.out && !a.force && fs::exists(*a.out))
    throw UsageError(one_line(a.out->string(), 300) +
                     ": is there; choose another --out or --force");
}

void write_page(const BenchArguments& a, const Bench& bench) {
  if (!a.out) return;
  fs::remove(*a.out);
  write_file(*a.out, bench_page(bench));
}

}  // namespace

void run_bench(const BenchArguments& a, Console& console) {
  check_page(a);
  const Progress progress = console.progress();
  const WorkFolder work;
  BenchOptions how;
  how.program = fs::read_symlink("/proc/self/exe");
  how.work = work.path();
  how.repeats = a.repeats, how.annealing = a.annealing, how.most_vertices = a.most_vertices;
  how.scan = scan_of(a, work.path() / "person", progress);
  how.layers = layers_of(a, work.path() / "layers", progress);
  const Bench bench = run_bench(how, progress);
  write_page(a, bench);
  console.say(bench_text(bench));
  if (console.wants_json()) console.answer(bench_json(bench));
}

}  // namespace regarment
