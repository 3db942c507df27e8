#include "jobs/job_progress.h"

#include <algorithm>

#include <nlohmann/json.hpp>

namespace regarment {
namespace {

using Json = nlohmann::json;

/// The share of a fit that a stage takes, as fits of the examples spend their time.
struct Share {
  std::string_view stage;
  double begin, end;
};
constexpr Share kShares[] = {{"read", 0, 0.10},      {"prepare", 0.10, 0.25}, {"place", 0.25, 0.30},
                             {"measure", 0.30, 0.4}, {"fit", 0.40, 0.80},     {"draw", 0.80, 0.97},
                             {"write", 0.97, 1}};

double number_or(const Json& json, const char* name, double other) {
  const auto found = json.find(name);
  return found != json.end() && found->is_number() ? found->get<double>() : other;
}

std::string text_or(const Json& json, const char* name) {
  const auto found = json.find(name);
  return found != json.end() && found->is_string() ? found->get<std::string>() : std::string();
}

}  // namespace

std::optional<ProgressLine> parse_progress(std::string_view line) {
  if (!line.starts_with('{')) return std::nullopt;
  const Json json = Json::parse(line, nullptr, false);
  if (!json.is_object()) return std::nullopt;
  ProgressLine out{text_or(json, "stage"), number_or(json, "fraction", -1),
                   text_or(json, "detail")};
  if (out.stage.empty() || !(out.fraction >= 0 && out.fraction <= 1)) return std::nullopt;
  return out;
}

double JobProgress::after(const ProgressLine& line) {
  const bool fits = kind_ == JobKind::Fit || kind_ == JobKind::Refit;
  const auto* share = std::find_if(std::begin(kShares), std::end(kShares),
                                   [&](const Share& one) { return one.stage == line.stage; });
  double now = fits ? reached_ : line.fraction;
  if (fits && share != std::end(kShares)) {
    now = share->begin + (share->end - share->begin) * line.fraction;
  }
  reached_ = std::max(reached_, now);
  return reached_;
}

}  // namespace regarment
