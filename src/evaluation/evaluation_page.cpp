#include "evaluation/evaluation_page.h"

#include <algorithm>
#include <array>

#include "evaluation/page_sections.h"
#include "report/content_policy.h"
#include "report/embedded.h"
#include "report/text.h"

namespace regarment {
namespace {

constexpr std::size_t kMostWorst = 12;

// Each has a template of its own, filled with the gaps of the whole page.
constexpr std::array kSections = {"baseline", "measurements", "repeats", "scans", "dimensions"};
constexpr std::array kStyles = {"report.css", "report_pictures.css", "report_media.css",
                                "evaluation.css"};

}  // namespace

std::string figure_text(const std::optional<double>& value, int digits) {
  return value ? fixed_text(*value, digits) : "–";
}

std::string signed_figure_text(const std::optional<double>& value, int digits) {
  return value ? signed_text(*value, digits) : "–";
}

std::string percent_text(const std::optional<double>& share) {
  return share ? fixed_text(100 * *share, 0) + "\u00a0%" : "–";
}

std::vector<std::size_t> worst_scans(const Evaluation& evaluation) {
  std::vector<std::pair<double, std::size_t>> order;
  for (std::size_t i = 0; i < evaluation.scans.size(); ++i) {
    if (const auto error = evaluation.scans[i].mean_error_cm()) order.emplace_back(-*error, i);
  }
  std::sort(order.begin(), order.end());
  std::vector<std::size_t> out;
  for (std::size_t k = 0; k < std::min(order.size(), kMostWorst); ++k) {
    out.push_back(order[k].second);
  }
  return out;
}

std::string evaluation_page(const Evaluation& evaluation) {
  Gaps page;
  page.set("table", evaluation.table);
  page.set("version", evaluation.version);
  std::string options;
  for (const std::string& word : evaluation.fit_options) options += " " + shell_quoted(word);
  page.set_maybe("fit_options", options);
  page.set_maybe("estimates", evaluation.estimates.value_or(""));
  show_summary(evaluation, page);
  show_groups(evaluation, page);
  show_plots(evaluation, page);
  show_scans(evaluation, page);
  show_repeats(evaluation, page);
  show_dimensions(evaluation, page);
  show_baseline(evaluation, page);
  for (const std::string section : kSections) {
    page.set(section + "_html",
             fill_template(embedded_text("evaluation_" + section + ".html"), page));
  }
  std::string style;
  for (const char* name : kStyles) style += embedded_text(name);
  const std::string script = embedded_text("evaluation.js");
  page.set("style", style);
  page.set("script", script);
  page.set("policy", content_policy(style, script));
  return fill_template(embedded_text("evaluation.html"), page);
}

}  // namespace regarment
