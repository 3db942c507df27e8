#include "bench/timed_fits.h"

#include <sys/resource.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "evaluation/child_pool.h"
#include "report/files.h"

namespace regarment {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

constexpr std::size_t kMostJson = std::size_t{64} << 20U;

std::optional<double> mean_error(const Json& result) {
  double sum = 0, n = 0;
  for (const Json& garment : result.at("garments"))
    for (const Json& m : garment.at("measurements"))
      if (m.contains("error_cm") && m.at("observable").get<bool>())
        sum += std::abs(m.at("error_cm").get<double>()), n += 1;
  if (n == 0) return std::nullopt;
  return sum / n;
}

/// Of all processes that have been waited for.
rusage child_usage() {
  rusage usage{};
  ::getrusage(RUSAGE_CHILDREN, &usage);
  return usage;
}

double child_seconds() {
  const rusage usage = child_usage();
  const auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

fs::path fit_folder(const BenchOptions& options) { return options.work / "fit"; }

}  // namespace

/// s of wall time that the program takes with these words.
double FitTimer::run(std::vector<std::string> words) const {
  const std::string command = words.front();
  words.insert(words.begin(), options_.program.string());
  ChildEnd end;
  run_children(
      {words}, {}, [&](std::size_t, const ChildEnd& how) { end = how; }, still_wanted_);
  if (end.status != 0)
    throw Error(end.status, "bench: 'regarment " + command + "' ended with: " + end.last_line);
  return end.seconds;
}

FitTimes FitTimer::fit(const BenchScan& scan, const std::string& method) const {
  const fs::path out = fit_folder(options_);
  std::vector<std::string> words = {"fit",     scan.file.string(), "--out",    out.string(),
                                    "--force", "--quiet",          "--method", method};
  for (const std::string& garment : scan.garments)
    words.insert(words.end(), {"--garment", garment});
  words.insert(words.end(), scan.truth.begin(), scan.truth.end());
  const double before = child_seconds();
  const double wall = run(words);
  const Json result = Json::parse(read_file(out / "result.json", kMostJson));
  FitTimes times{wall, child_seconds() - before, {}, mean_error(result)};
  double all = 0;
  for (const auto& [stage, seconds] : result.at("timing_s").items()) {
    if (stage == "total") continue;
    times.stages[stage] = seconds, all += seconds.get<double>();
  }
  times.stages["report"] = std::max(0.0, wall - all);
  return times;
}

double FitTimer::refit() const {
  const fs::path out = options_.work / "refit";
  return run({"refit", fit_folder(options_).string(), "--out", out.string(), "--force", "--quiet"});
}

double FitTimer::start() const { return run({"--version"}); }

double largest_child() { return static_cast<double>(child_usage().ru_maxrss) / 1024; }

}  // namespace regarment
