#include <algorithm>
#include <cctype>
#include <cmath>

#include "report/page_parts.h"
#include "report/text.h"

namespace regarment {
namespace {

struct Tally {
  std::size_t dimensions = 0, observable = 0, judged = 0, passed = 0;
  std::vector<double> half_widths;  // cm, of the intervals of observable dimensions
  std::vector<std::pair<double, std::string>> errors;  // cm, with the dimension's title
};

Tally tally(const Result& result) {
  Tally out;
  for (const ResultGarment& garment : result.garments) {
    for (const ResultMeasurement& m : garment.measurements) {
      ++out.dimensions;
      if (!m.observable) continue;
      ++out.observable;
      if (m.fixed) continue;
      out.half_widths.push_back((m.high_cm - m.low_cm) / 2.0);
      if (const auto error = m.error_cm()) out.errors.emplace_back(*error, m.title);
      if (const auto within = m.within_tolerance()) {
        ++out.judged;
        if (*within) ++out.passed;
      }
    }
  }
  return out;
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

std::string of(std::size_t part, std::size_t whole) {
  return std::to_string(part) + " of " + std::to_string(whole);
}

std::string sureness(const Result& result, Tally& all) {
  std::string text;
  if (!all.half_widths.empty()) {
    const auto middle = all.half_widths.begin() + static_cast<long>(all.half_widths.size() / 2);
    std::nth_element(all.half_widths.begin(), middle, all.half_widths.end());
    text = "Half of the dimensions are known to \u00b1\u202f" + fixed_text(*middle, 1) +
           "\u202fcm or better (90\u202f%). ";
  }
  const double vertices = static_cast<double>(std::max<std::size_t>(1, result.scan.vertices));
  const double sure = 1.0 - static_cast<double>(result.unsure) / vertices;
  // Rounded down, so that 100 % means all.
  return text + fixed_text(std::floor(sure * 1000.0) / 10.0, 1) + "\u202f% of the labels are sure.";
}

std::string against_truth(const Tally& all) {
  if (all.errors.empty()) return {};
  double sum = 0.0;
  std::pair<double, std::string> worst = all.errors.front();
  for (const auto& error : all.errors) {
    sum += std::abs(error.first);
    if (std::abs(error.first) > std::abs(worst.first)) worst = error;
  }
  std::string text = "Against the truth given: mean absolute error " +
                     fixed_text(sum / static_cast<double>(all.errors.size()), 1) +
                     "\u202fcm, the largest " + signed_cm_text(worst.first / 100.0) + "\u202fcm (" +
                     worst.second + ").";
  if (all.judged > 0) text += " Within tolerance: " + of(all.passed, all.judged) + ".";
  return text;
}

/// Findings about the scan that a person should look at.
std::size_t serious_findings(const Result& result) {
  const auto& findings = result.scan.findings;
  return static_cast<std::size_t>(
      std::count_if(findings.begin(), findings.end(),
                    [](const Finding& f) { return f.severity != Severity::Note; }));
}

}  // namespace

void show_verdict(const Result& result, Gaps& page) {
  Tally all = tally(result);
  const bool clear =
      all.observable == all.dimensions && result.warnings.empty() && serious_findings(result) == 0;
  page.set("title", names(result));
  page.set("file", result.scan.file);
  page.set("method", result.method);
  page.set("version", result.version);
  page.set("is_clear", clear);
  page.set("needs_a_look", !clear);
  page.set("found", of(all.observable, all.dimensions) + " dimensions measured");
  page.set("sureness", sureness(result, all));
  page.set_maybe("against_truth", against_truth(all));
  const std::size_t serious = serious_findings(result);
  page.set_maybe("scan_remarks", serious == 0 ? ""
                                              : counted(serious, "finding about the scan needs",
                                                        "findings about the scan need") +
                                                    " a look");
  std::vector<Gaps> warnings;
  for (const std::string& warning : result.warnings) {
    Gaps& gaps = warnings.emplace_back();
    gaps.set("text", warning);
  }
  page.set("has_warnings", !warnings.empty());
  page.set("warnings", std::move(warnings));
}

}  // namespace regarment
