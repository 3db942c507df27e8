#include <algorithm>
#include <array>
#include <cmath>

#include "render/heat_map.h"
#include "report/page_parts.h"
#include "report/text.h"

namespace regarment {
namespace {

Gaps fact(const std::string& name, const std::string& value, const std::string& note = "",
          const std::string& option = "") {
  Gaps gaps;
  gaps.set("name", name);
  gaps.set("value", value);
  gaps.set_maybe("note", note);
  gaps.set_maybe("option", option);
  return gaps;
}

// A fact that may be a guess, how sure it is, and the option that overrules it.
Gaps guess(const std::string& name, const std::string& value, bool is_guess,
           const std::string& option, const std::string& sureness = "") {
  if (!is_guess) return fact(name, value, "as given");
  return fact(name, value, "found from the shape" + sureness + "; overrule with", option);
}

std::string front_sureness(const ResultScan& scan) {
  return ", " + fixed_text(std::floor(scan.front_confidence * 100.0), 0) + "\u202f% sure";
}

std::string kind(const ResultScan& scan) {
  if (scan.triangles == 0) return "point cloud, " + count_text(scan.vertices) + " points";
  return "mesh, " + count_text(scan.vertices) + " vertices, " + count_text(scan.triangles) +
         " triangles";
}

Gaps finding_row(const Finding& finding) {
  static const std::array<std::array<const char*, 2>, 3> kSigns = {
      {{"i", "Note"}, {"!", "Advice"}, {"\u2717", "Problem"}}};
  const auto& [icon, word] = kSigns[static_cast<std::size_t>(finding.severity)];
  Gaps row;
  row.set("severity", std::string(severity_name(finding.severity)));
  row.set("icon", std::string(icon));
  row.set("word", std::string(word));
  row.set("found", finding.found);
  row.set_maybe("done", finding.done);
  row.set_maybe("advice", finding.advice);
  return row;
}

/// Worst first, else in the order found.
std::vector<Gaps> finding_rows(std::vector<Finding> findings) {
  std::stable_sort(findings.begin(), findings.end(),
                   [](const Finding& a, const Finding& b) { return a.severity > b.severity; });
  std::vector<Gaps> rows;
  rows.reserve(findings.size());
  for (const Finding& finding : findings) rows.push_back(finding_row(finding));
  return rows;
}

std::string share(std::size_t count, std::size_t of) {
  if (of == 0) return "0";
  return fixed_text(100.0 * static_cast<double>(count) / static_cast<double>(of), 1);
}

Gaps label_row(const std::string& name, std::size_t count, const Result& result, std::size_t at,
               int layer) {
  Gaps row;
  row.set("name", name);
  row.set("count", count_text(count));
  row.set("share", share(count, result.scan.vertices));
  row.set("colour", css_colour(garment_colour(layer)));
  const LabelScore* score = result.label_score ? &*result.label_score : nullptr;
  const bool scored = score != nullptr && at < score->iou.size() && score->iou[at].has_value();
  row.set_maybe("iou", scored ? fixed_text(*score->iou[at], 3) : "");
  return row;
}

// Each stage with a bar of its share of the whole.
void show_times(const Result& result, Gaps& page) {
  page.set("has_times", !result.timing_s.empty());
  if (result.timing_s.empty()) return;
  constexpr double kBar = 240.0;  // px, of everything
  const double total = result.timing_s.back().second;
  std::vector<Gaps> rows;
  for (const auto& [stage, seconds] : result.timing_s) {
    if (stage == "total") continue;
    const double part = total > 0.0 ? seconds / total : 0.0;
    Gaps& row = rows.emplace_back();
    row.set("name", stage);
    row.set("value", fixed_text(seconds, 2));
    row.set("width", fixed_text(part * kBar, 1));
    row.set("share", fixed_text(part * 100.0, 0));
  }
  page.set("total_time", fixed_text(total, 1));
  page.set("times", std::move(rows));
}

// Every option with the value it had; of a result that has not recorded them, those chosen.
void add_options(const Result& result, std::vector<Gaps>& settings) {
  const auto chosen = [&](const std::string& option) {
    return std::any_of(result.options.begin(), result.options.end(),
                       [&](const auto& given) { return given.first == option; });
  };
  for (const auto& [name, value] : result.settings.empty() ? result.options : result.settings)
    settings.push_back(fact("--" + name, value, chosen(name) ? "as given" : "default"));
}

}  // namespace

void show_scan(const Result& result, Gaps& page) {
  const ResultScan& scan = result.scan;
  std::vector<Gaps> facts = {
      fact("File", scan.file),
      fact("Kind", kind(scan)),
      guess("Units", scan.units, scan.units_guessed, "--units"),
      guess("Up", scan.up, scan.up_guessed, "--up"),
      guess("Front", scan.front, scan.front_guessed, "--front", front_sureness(scan)),
      fact("Height", fixed_text(scan.height_cm, 1) + " cm", "floor to the top of the head"),
      fact("Point spacing", fixed_text(scan.spacing_mm, 1) + " mm", "median"),
      fact("Noise", fixed_text(scan.noise_mm, 1) + " mm",
           "standard deviation about the local surface"),
      fact("Outliers", count_text(scan.outliers), "vertices kept out of every measurement"),
  };
  if (scan.triangles > 0) {
    facts.push_back(fact("Open borders", count_text(scan.holes)));
    facts.push_back(
        fact("Caps", count_text(scan.caps), "triangles of invented surface that close a hem"));
  }
  for (const auto& [name, height] : result.landmarks_cm) {
    if (name == "height") continue;
    std::string title = name;
    for (char& c : title) c = c == '_' ? ' ' : c;
    facts.push_back(fact("Level of " + title, fixed_text(height, 1) + " cm", "above the floor"));
  }
  page.set("scan_facts", std::move(facts));
  page.set("has_findings", !scan.findings.empty());
  page.set("findings", finding_rows(scan.findings));
}

void show_labels(const Result& result, Gaps& page) {
  std::vector<Gaps> rows = {label_row("Person", result.person, result, 0, 0)};
  for (std::size_t i = 0; i < result.garments.size() && i < result.garment_counts.size(); ++i) {
    rows.push_back(label_row(result.garments[i].title, result.garment_counts[i], result, i + 1,
                             result.garments[i].layer));
  }
  page.set("labels", std::move(rows));
  page.set("unsure", count_text(result.unsure));
  page.set("unsure_share", share(result.unsure, result.scan.vertices));
  page.set("has_label_score", result.label_score.has_value());
  if (!result.label_score) return;
  page.set("mean_iou", fixed_text(result.label_score->mean_iou, 3));
  page.set("accuracy", fixed_text(result.label_score->accuracy * 100.0, 1));
  page.set("scored", count_text(result.label_score->scored));
}

void show_settings(const Result& result, Gaps& page) {
  std::vector<Gaps> settings = {fact("Program", "regarment " + result.version),
                                fact("Method", result.method),
                                fact("Seed", std::to_string(result.seed))};
  if (result.refit) settings.push_back(fact("Scan", "as an earlier fit prepared and stored it"));
  if (result.threads) settings.push_back(fact("Threads", std::to_string(*result.threads)));
  add_options(result, settings);
  settings.push_back(fact("SHA-256 of the scan", result.scan.sha256));
  page.set("settings", std::move(settings));
  page.set("command", result.command);
  show_times(result, page);
}

}  // namespace regarment
