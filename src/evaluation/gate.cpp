#include "evaluation/gate.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "base/error.h"
#include "base/one_line.h"
#include "evaluation/named_statistics.h"
#include "report/text.h"

namespace regarment {
namespace {

std::string stripped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c != ' ' && c != '\t') out += c;
  }
  return out;
}

[[noreturn]] void refuse(const std::string& text, const std::string& what) {
  throw UsageError("--gate: '" + one_line(text, 80) + "' " + what);
}

double number_of(const std::string& text, const std::string& gate) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) {
    refuse(gate, "ends in no number; write for example \"mae_cm<=1.0\"");
  }
  return value;
}

bool is_statistic(const std::string& name) {
  const auto& all = named_statistics();
  return std::any_of(all.begin(), all.end(), [&](const auto& one) { return one.name == name; });
}

std::string statistic_names() {
  std::string out;
  for (const NamedStatistic& one : named_statistics()) {
    out += (out.empty() ? "" : ", ") + std::string(one.name);
  }
  return out;
}

std::optional<double> value_of(const Gate& gate, const std::vector<GroupStatistics>& groups) {
  for (const GroupStatistics& group : groups) {
    if (group.key != gate.group) continue;
    for (const NamedStatistic& one : named_statistics()) {
      if (one.name == gate.statistic) return one.value(group);
    }
  }
  return std::nullopt;
}

bool holds(const Gate& gate, double value) {
  if (gate.comparison == "<=") return value <= gate.limit;
  if (gate.comparison == ">=") return value >= gate.limit;
  return gate.comparison == "<" ? value < gate.limit : value > gate.limit;
}

}  // namespace

Gate parse_gate(const std::string& text) {
  Gate gate;
  gate.text = one_line(text, 200);
  const std::string plain = stripped(text);
  const auto at = plain.find_first_of("<>");
  if (at == std::string::npos || at == 0) {
    refuse(text, "is no condition; write for example \"mae_cm<=1.0\"");
  }
  const std::size_t length = plain.compare(at + 1, 1, "=") == 0 ? 2 : 1;
  gate.comparison = plain.substr(at, length);
  gate.limit = number_of(plain.substr(at + length), text);
  const std::string name = plain.substr(0, at);
  const auto point = name.rfind('.');
  gate.statistic = point == std::string::npos ? name : name.substr(point + 1);
  if (point != std::string::npos) gate.group = name.substr(0, point);
  if (!is_statistic(gate.statistic)) {
    refuse(text, "names no statistic; there are " + statistic_names());
  }
  return gate;
}

void check_gate_groups(const std::vector<Gate>& gates, const std::vector<GroupStatistics>& groups) {
  std::string known;
  for (const GroupStatistics& group : groups) {
    if (!group.key.empty()) known += (known.empty() ? "" : ", ") + group.key;
  }
  for (const Gate& gate : gates) {
    const std::string& name = gate.group;
    if (name == "kind.cloud" || name == "kind.open" || name == "kind.closed") continue;
    const bool there = std::any_of(groups.begin(), groups.end(),
                                   [&](const auto& group) { return group.key == name; });
    if (!there) refuse(gate.text, "names no group of this table; there are " + known);
  }
}

std::vector<GateResult> judge(const std::vector<Gate>& gates,
                              const std::vector<GroupStatistics>& groups) {
  std::vector<GateResult> out;
  for (const Gate& gate : gates) {
    const std::optional<double> value = value_of(gate, groups);
    out.push_back({gate.text, value, value && holds(gate, *value)});
  }
  return out;
}

std::string why_failed(const GateResult& gate) {
  return "gate failed: " + gate.text + ": " +
         (gate.value ? "the value is " + significant_text(*gate.value, 4)
                     : "nothing could be measured");
}

}  // namespace regarment
