#include "evaluation/group_statistics.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <set>

namespace regarment {
namespace {

using Chosen = std::function<bool(const EvaluatedScan&, const TrueDimension&)>;

// A group and which dimensions of which scans are in it.
struct Member {
  std::string by, key, name;
  Chosen chosen;
};

std::string words(std::string text) {
  std::replace(text.begin(), text.end(), '_', ' ');
  return text;
}

std::vector<std::string> damages(const EvaluatedScan& scan) {
  return scan.about.damage.empty() ? std::vector<std::string>{"none"} : scan.about.damage;
}

bool has_damage(const EvaluatedScan& scan, const std::string& damage) {
  const std::vector<std::string> all = damages(scan);
  return std::find(all.begin(), all.end(), damage) != all.end();
}

// By rank of the kind of group, then key.
std::vector<Member> members(const std::vector<EvaluatedScan>& scans) {
  std::map<std::pair<int, std::string>, Member> out;
  out[{0, ""}] = {"all", "", "all", [](const auto&, const auto&) { return true; }};
  for (const EvaluatedScan& scan : scans) {
    for (const TrueDimension& d : scan.about.dimensions) {
      const std::string of = d.template_name, key = measurement_key(d);
      const int layer = d.layer;
      out[{1, of}] = {"template", of, words(of),
                      [of](const auto&, const auto& x) { return x.template_name == of; }};
      out[{layer > 1 ? 3 : 2, key}] = {
          "measurement", key, measurement_name(d),
          [key](const auto&, const auto& x) { return measurement_key(x) == key; }};
      const std::string number = std::to_string(layer);
      out[{4, "layer." + number}] = {
          "layer", "layer." + number, "layer " + number,
          [layer](const auto&, const auto& x) { return x.layer == layer; }};
    }
    const std::string kind = scan.about.kind;
    if (!kind.empty()) {
      out[{5, "kind." + kind}] = {
          "kind", "kind." + kind, words(kind),
          [kind](const auto& s, const auto&) { return s.about.kind == kind; }};
    }
    for (const std::string& damage : damages(scan)) {
      out[{6, "damage." + damage}] = {
          "damage", "damage." + damage, words(damage),
          [damage](const auto& s, const auto&) { return has_damage(s, damage); }};
    }
  }
  std::vector<Member> list;
  list.reserve(out.size());
  for (auto& [rank, member] : out) list.push_back(std::move(member));
  return list;
}

// What is gathered of a group before it is summed up.
struct Gathered {
  std::vector<Sample> errors, worn, published;
  std::vector<double> iou, border, seconds, truths;
  bool circumference = false;
};

void add_dimension(const TrueDimension& truth, const FoundDimension& found, GroupStatistics& out,
                   Gathered& all) {
  if (truth.hidden()) {
    ++out.hidden;
    if (!found.observable) ++out.hidden_flagged;
    return;
  }
  ++out.visible;
  if (!found.observable) ++out.visible_flagged;
  if (found.observable) {
    ++out.confident;
    if (std::abs(found.value_cm - truth.truth_cm) > kConfidentError) ++out.confident_wrong;
  }
  if (truth.tolerates(found.value_cm - truth.truth_cm)) ++out.in_tolerance;
  all.truths.push_back(truth.truth_cm);
  all.circumference = truth.circumference;
  all.errors.push_back({truth.truth_cm, found.value_cm, found.low_cm, found.high_cm});
  if (truth.worn_cm && found.worn_cm) all.worn.push_back({*truth.worn_cm, *found.worn_cm, {}, {}});
  if (truth.published_cm) all.published.push_back({truth.truth_cm, *truth.published_cm, {}, {}});
}

void add_scan(const EvaluatedScan& scan, const Chosen& chosen, GroupStatistics& out,
              Gathered& all) {
  TrueDimension none;
  none.layer = 0;
  bool in = scan.about.dimensions.empty() && chosen(scan, none);
  for (std::size_t i = 0; i < scan.about.dimensions.size(); ++i) {
    const TrueDimension& truth = scan.about.dimensions[i];
    if (!chosen(scan, truth)) continue;
    in = true;
    if (i < scan.found.size() && scan.found[i]) add_dimension(truth, *scan.found[i], out, all);
  }
  if (!in) return;
  ++out.scans;
  if (scan.failure) ++out.failures;
  if (scan.frame_right) {
    ++out.frames;
    if (!*scan.frame_right) ++out.frames_wrong;
  }
  if (scan.labels) all.iou.push_back(scan.labels->mean_iou);
  if (scan.labels && scan.labels->border_mm) all.border.push_back(*scan.labels->border_mm);
  if (scan.seconds) all.seconds.push_back(*scan.seconds);
}

std::optional<double> mean(const std::vector<double>& values) {
  if (values.empty()) return std::nullopt;
  double sum = 0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

std::vector<std::pair<std::string, double>> class_means(const std::vector<EvaluatedScan>& scans) {
  std::map<std::string, std::vector<double>> by_name;
  for (const EvaluatedScan& scan : scans) {
    if (!scan.labels) continue;
    for (const auto& [name, iou] : scan.labels->class_iou) by_name[name].push_back(iou);
  }
  std::vector<std::pair<std::string, double>> out;
  out.reserve(by_name.size());
  for (const auto& [name, values] : by_name) out.emplace_back(name, *mean(values));
  return out;
}

GroupStatistics summed(const Member& member, const std::vector<EvaluatedScan>& scans) {
  GroupStatistics out;
  out.by = member.by, out.key = member.key, out.name = member.name;
  Gathered all;
  for (const EvaluatedScan& scan : scans) add_scan(scan, member.chosen, out, all);
  out.errors = error_statistics(all.errors);
  out.worn = error_statistics(all.worn);
  out.published = error_statistics(all.published);
  if (member.by == "measurement" && !all.truths.empty()) {
    out.iso = iso_verdict(out.errors, iso_limit_cm(all.circumference, *mean(all.truths)));
  }
  if (member.by == "all") out.class_iou = class_means(scans);
  out.labelled = all.iou.size();
  out.miou = mean(all.iou);
  out.border_mm = mean(all.border);
  if (!all.seconds.empty()) {
    out.seconds_median = quantile(all.seconds, 0.5);
    out.seconds_p95 = quantile(all.seconds, 0.95);
  }
  return out;
}

}  // namespace

std::string measurement_key(const TrueDimension& d) {
  return (d.layer > 1 ? "inner." : "") + d.template_name + "." + d.measurement;
}

std::string measurement_name(const TrueDimension& d) {
  return words(d.template_name + " " + d.measurement) + (d.layer > 1 ? ", under another" : "");
}

std::vector<GroupStatistics> group_statistics(const std::vector<EvaluatedScan>& scans) {
  std::vector<GroupStatistics> out;
  for (const Member& member : members(scans)) out.push_back(summed(member, scans));
  return out;
}

}  // namespace regarment
