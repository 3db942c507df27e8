#include <array>
#include <cctype>
#include <cmath>

#include "report/checks.h"
#include "report/judgement.h"
#include "report/page_parts.h"
#include "report/text.h"

namespace regarment {
namespace {

struct Sign {
  const char *css, *icon, *word;
};

// Each light is told by its shape and its word as well as by its colour.
constexpr std::array<Sign, 3> kSigns = {
    {{"good", "\u2713", "Good"}, {"look", "!", "Look"}, {"poor", "\u2717", "Poor"}}};

Sign sign_of(CheckLevel level) { return kSigns[static_cast<std::size_t>(level)]; }

void show_sign(CheckLevel level, Gaps& gaps) {
  const Sign sign = sign_of(level);
  gaps.set("level", sign.css);
  gaps.set("icon", sign.icon);
  gaps.set("word", sign.word);
}

Gaps show_check(const Check& check) {
  Gaps row;
  show_sign(check.level, row);
  row.set("name", check.name);
  row.set("found", check.found);
  row.set("threshold", check.threshold);
  row.set("place", check.place);
  row.set_maybe("advice", check.advice);
  return row;
}

std::string names(const Result& result) {
  std::string out;
  for (std::size_t i = 0; i < result.garments.size(); ++i) {
    if (i > 0) out += i + 1 == result.garments.size() ? " over " : ", ";
    std::string title = result.garments[i].title;
    // A title inside a sentence: "T-shirt over skirt".
    if (i > 0 && title.size() > 1 && title[1] >= 'a' && title[1] <= 'z') {
      title[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(title[0])));
    }
    out += title;
  }
  return out;
}

// What the page says first: how many dimensions, and how many lights are not good.
std::string headline(const Result& result, const std::vector<Check>& checks) {
  std::size_t dimensions = 0, measured = 0;
  for (const ResultGarment& garment : result.garments) {
    for (const ResultMeasurement& m : garment.measurements) {
      ++dimensions;
      measured += m.observable;
    }
  }
  std::size_t look = 0, poor = 0;
  for (const Check& check : checks) {
    look += check.level == CheckLevel::Look;
    poor += check.level == CheckLevel::Poor;
  }
  std::string text =
      std::to_string(measured) + " of " + std::to_string(dimensions) + " dimensions measured; ";
  if (poor > 0) text += counted(poor, "check is poor", "checks are poor");
  if (poor > 0 && look > 0) text += ", ";
  if (look > 0) text += counted(look, "check needs a look", "checks need a look");
  return text + (look + poor == 0 ? "all checks are good" : "");
}

std::string against_truth(const Result& result) {
  double sum = 0.0;
  std::size_t count = 0;
  const ResultMeasurement* worst = nullptr;
  for (const ResultGarment& garment : result.garments) {
    for (const ResultMeasurement& m : garment.measurements) {
      if (judge(m) == Judgement::NotJudged || judge(m) == Judgement::NotMeasurable) continue;
      if (!m.error_cm()) continue;
      sum += std::abs(*m.error_cm());
      ++count;
      if (worst == nullptr || std::abs(*m.error_cm()) > std::abs(*worst->error_cm())) worst = &m;
    }
  }
  if (worst == nullptr) return {};
  return "Mean absolute difference from the specification " +
         fixed_text(sum / static_cast<double>(count), 1) + "\u202fcm, the largest " +
         signed_cm_text(*worst->error_cm() / 100.0) + "\u202fcm (" + worst->title + ").";
}

}  // namespace

void show_verdict(const Result& result, Gaps& page) {
  const std::vector<Check> checks = checks_of(result);
  // A remark about a garment is no light of its own; it needs a reader all the same.
  CheckLevel level = worst_level(checks);
  if (!result.warnings.empty()) level = std::max(level, CheckLevel::Look);
  show_sign(level, page);
  page.set("title", names(result));
  page.set("file", result.scan.file);
  page.set("method", result.method);
  page.set("version", result.version);
  page.set("headline", headline(result, checks));
  page.set_maybe("against_truth", against_truth(result));
  std::vector<Gaps> rows, warnings;
  for (const Check& check : checks) rows.push_back(show_check(check));
  page.set("checks", std::move(rows));
  for (const std::string& warning : result.warnings) {
    warnings.emplace_back().set("text", warning);
  }
  page.set("has_warnings", !warnings.empty());
  page.set("warnings", std::move(warnings));
}

}  // namespace regarment
