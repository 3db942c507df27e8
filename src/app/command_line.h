#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "app/batch_options.h"
#include "app/known_options.h"
#include "app/service_options.h"
#include "app/speech.h"

namespace regarment {

/// What --method annealing can be told. Where the paper's method is departed from, a switch leads
/// back; `as_printed` is all of them.
struct AnnealingArguments {
  int runs = 3, evaluations = 500;
  double segment_distance_mm = 10, normal_angle_deg = 60;
  double layer_attenuation = 0.1;
  std::string attraction = "normals", drape_from = "best";
  bool collisions = false, cap_detection = true, border_rejection = true;
  bool held_edges = true, rough_search = true, hesitation = true, square_root = true;
  bool as_printed = false;
};

/// regarment fit SCAN --garment TEMPLATE ... --out DIR
struct FitArguments {
  Speech speech;
  std::filesystem::path scan, out;
  std::string name;                   // of the scan; empty: its file's
  std::vector<std::string> garments;  // template names or files, outermost first, at least one
  bool force = false, timing = true, state = true;
  std::string method = "joint", units = "auto", up = "auto", front = "auto";
  std::uint64_t seed = 1;
  int threads = 0;  // 0: as many as the machine has
  AnnealingArguments annealing;
  KnownArguments known;
  std::optional<std::filesystem::path> placement, ground_truth, ground_truth_labels;
  std::optional<std::filesystem::path> cache;
  int cache_mb = 2000;
  int pixel_ratio = 1;  // of the pictures
};

/// regarment refit DIR
struct RefitArguments {
  Speech speech;
  std::filesystem::path folder;
  std::optional<std::filesystem::path> out;  // none: the folder itself
  bool force = false, forget = false, timing = true, state = true;
  std::optional<std::string> method;
  int threads = 0;  // 0: as many as the machine has
  KnownArguments known;
};

/// regarment evaluate TABLE --out DIR
struct EvaluateArguments {
  Speech speech;
  std::filesystem::path table, out;
  std::optional<std::filesystem::path> scans, estimates, baseline;
  std::string only;
  std::vector<std::string> gates;
  std::vector<std::string> fit_options;  // words for every fit, checked: "--seed", "7"
  int jobs = 0;                          // 0: as many as the machine has cores
  int threads = 0;                       // of each fit; 0: the cores shared among the jobs
  int timeout = 1800;                    // of each fit, s
  bool force = false, timing = true;
};

/// regarment synthesize --out DIR
struct SynthesizeArguments {
  Speech speech;
  std::filesystem::path out;
  bool force = false;
  int cases = 10, first = 0;
  std::uint64_t seed = 1;
  int threads = 0;                    // 0: as many as the machine has
  std::vector<std::string> garments;  // outermost first; empty: all outfits
  std::string kind = "all";
};

/// regarment report DIR
struct ReportArguments {
  Speech speech;
  std::filesystem::path folder;
};

/// regarment review DIR... --out PAGE
struct ReviewArguments {
  Speech speech;
  std::vector<std::filesystem::path> folders;  // at least one
  std::filesystem::path out;
  bool force = false;
};

/// regarment render MESH... --out DIR
struct RenderArguments {
  Speech speech;
  std::vector<std::filesystem::path> meshes;  // at least one
  std::filesystem::path out;
  bool force = false;
  int pixel_ratio = 1;
};

/// regarment templates [NAME]
struct TemplatesArguments {
  Speech speech;
  std::optional<std::string> name;
  std::vector<std::string> at;  // NAME=CM: with --json, the flat pattern at these dimensions
};

/// regarment bench [SCAN]
struct BenchArguments {
  Speech speech;
  std::optional<std::filesystem::path> scan;    // none: a person is made
  std::vector<std::string> garments;            // outermost first; of a person that is made as well
  std::optional<std::filesystem::path> layers;  // a T-shirt over a skirt; none: a person is made
  std::optional<std::filesystem::path> ground_truth, out;
  bool force = false, annealing = false;
  int repeats = 5;
  double most_vertices = 1e6;
};

/// --help and --version: an answer that needs no work.
struct TextAnswer {
  std::string text;
};

using Command =
    std::variant<FitArguments, RefitArguments, EvaluateArguments, SynthesizeArguments,
                 ReportArguments, ReviewArguments, RenderArguments, TemplatesArguments,
                 ServeArguments, WorkerArguments, KeyArguments, ConfigArguments, DoctorArguments,
                 BenchArguments, BatchArguments, BatchTaskArguments, TextAnswer>;

/// Reads the command line. Throws UsageError, in one line, on anything it does not know.
Command parse_command_line(int argc, const char* const* argv);

}  // namespace regarment
