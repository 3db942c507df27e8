#include <algorithm>
#include <nlohmann/json.hpp>

#include "bench/bench.h"
#include "report/text.h"

namespace regarment {
namespace {

constexpr int kDigits = 3;

std::string figure(double value, const std::string& unit) {
  return significant_text(value, kDigits) + " " + unit;
}

std::string padded(std::string text, std::size_t width) {
  text.resize(std::max(text.size(), width), ' ');
  return text;
}

std::string verdict(const BenchRow& row) {
  const std::optional<bool> reached = row.reached();
  if (!reached) return "";
  const double aim = row.at_most ? *row.at_most : *row.at_least;
  return std::string(*reached ? "reached" : "MISSED") + ": " +
         (row.at_most ? "at most " : "at least ") + significant_text(aim, kDigits) +
         (row.by_ratio ? " times" : " " + row.unit);
}

}  // namespace

std::string bench_text(const Bench& bench) {
  std::string out = "regarment " + bench.version + ", " + bench.scan + "\n", group;
  for (const BenchRow& row : bench.rows) {
    if (row.group != group) out += "\n" + row.group + "\n", group = row.group;
    std::string line = "  " + padded(row.name, 62) + padded(figure(row.value, row.unit), 13);
    std::string other;
    if (row.other_value) other = row.other + " " + figure(*row.other_value, row.unit);
    if (const auto ratio = row.ratio()) other += ", " + significant_text(*ratio, 2) + " times";
    line += padded(other, 34) + verdict(row);
    line.erase(line.find_last_not_of(' ') + 1);
    out += line + "\n";
  }
  out += "\nGrowth\n";
  for (const GrowthCurve& curve : bench.curves) {
    out += "  " + padded(curve.name, 28) + "size^" + fixed_text(curve.exponent, 2) + " :";
    for (const GrowthCurve::Point& p : curve.points)
      out += " " + significant_text(p.size, kDigits) + " " + significant_text(p.seconds, kDigits) +
             " s;";
    out += " (" + curve.size_unit + ")\n";
  }
  return out;
}

std::string bench_json(const Bench& bench) {
  using Json = nlohmann::ordered_json;
  Json out{{"schema", "regarment.bench/1"}, {"version", bench.version}, {"scan", bench.scan}};
  out["rows"] = Json::array();
  for (const BenchRow& row : bench.rows) {
    Json one{{"group", row.group},
             {"name", row.name},
             {"value", rounded_significant(row.value, 4)},
             {"unit", row.unit}};
    if (row.other_value) {
      one["other"] = row.other;
      one["other_value"] = rounded_significant(*row.other_value, 4);
    }
    if (const auto ratio = row.ratio()) one["ratio"] = rounded_significant(*ratio, 4);
    if (const auto reached = row.reached()) one["reached"] = *reached;
    out["rows"].push_back(std::move(one));
  }
  out["curves"] = Json::array();
  for (const GrowthCurve& curve : bench.curves) {
    Json points = Json::array();
    for (const GrowthCurve::Point& p : curve.points)
      points.push_back({{"size", p.size}, {"seconds", rounded_significant(p.seconds, 4)}});
    out["curves"].push_back({{"name", curve.name},
                             {"size_unit", curve.size_unit},
                             {"exponent", rounded(curve.exponent, 3)},
                             {"points", std::move(points)}});
  }
  return out.dump(2) + "\n";
}

}  // namespace regarment
