#include "app/known_options.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <cstring>

#include "app/one_each.h"
#include "base/error.h"
#include "base/one_line.h"

namespace regarment {
namespace {

constexpr double kLongest = 1000;  // cm
constexpr double kTallest = 300;   // cm
constexpr std::size_t kMostTexts = 64;
constexpr const char* kEdge = "_edge";

std::string in_quotes(std::string_view text) { return "'" + one_line(text, 60) + "'"; }

NamedLength named_length(const std::string& option, const std::string& text) {
  const auto equals = text.find('=');
  if (equals == std::string::npos || equals == 0)
    throw UsageError(option + ": " + in_quotes(text) + " is not of the form NAME=CM");
  NamedLength out{text.substr(0, equals), 0};
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data() + equals + 1, end, out.cm);
  const bool number = error == std::errc() && stop == end;
  if (!number || !(out.cm > 0 && out.cm <= kLongest))
    throw UsageError(option + ": " + in_quotes(text.substr(equals + 1)) + " for " +
                     one_line(out.name, 60) +
                     " is no length; give a number of centimetres between 0 and 1000");
  return out;
}

std::vector<std::string> split_at_commas(const std::string& text) {
  std::vector<std::string> out(1);
  for (const char c : text) {
    if (c == ',')
      out.emplace_back();
    else
      out.back() += c;
  }
  return out;
}

/// Names of one garment that can be given.
struct Named {
  std::string garment;
  std::vector<std::string> names;
};

std::string all_names(const std::vector<Named>& garments) {
  std::string out;
  for (const Named& one : garments)
    for (const std::string& name : one.names)
      out += (out.empty() ? "" : ", ") + (garments.size() > 1 ? one.garment + "." + name : name);
  return out;
}

/// The garment and the name in it that `given` means.
std::pair<std::string, std::string> find_named(const std::string& option, const std::string& given,
                                               const std::vector<Named>& garments) {
  const auto dot = given.find('.');
  const std::string wanted = dot == std::string::npos ? "" : given.substr(0, dot);
  const std::string name = dot == std::string::npos ? given : given.substr(dot + 1);
  std::vector<std::string> found;
  for (const Named& one : garments)
    if ((wanted.empty() || one.garment == wanted) &&
        std::find(one.names.begin(), one.names.end(), name) != one.names.end())
      found.push_back(one.garment);
  if (found.empty())
    throw UsageError(option + ": " + in_quotes(given) + " is unknown; use " + all_names(garments));
  if (found.size() > 1 && found[0] == found[1])
    throw UsageError(option + ": two garments are of the template " + found[0] +
                     "; help with one of them needs a template of another name");
  if (found.size() > 1)
    throw UsageError(option + ": " + found[0] + " and " + found[1] + " both have " +
                     in_quotes(name) + "; write " + found[0] + "." + name);
  return {found[0], name};
}

std::vector<Named> dimension_names(const std::vector<GarmentTemplate>& templates) {
  std::vector<Named> out;
  for (const GarmentTemplate& garment : templates) {
    Named& one = out.emplace_back(Named{garment.name(), {}});
    for (const Dimension& d : garment.dimensions()) one.names.push_back(d.name);
  }
  return out;
}

/// Edges that have one height: of necklines, front and back differ.
std::vector<Named> edge_names(const std::vector<GarmentTemplate>& templates) {
  constexpr double kCoarse = 0.2;  // m: the names are the same at any size
  std::vector<Named> out;
  for (const GarmentTemplate& garment : templates) {
    Named& one = out.emplace_back(Named{garment.name(), {}});
    for (const PatternEdge& edge : make_pattern(garment, garment.typical(), kCoarse).edges)
      if (edge.limb != "neck") one.names.push_back(edge.name + kEdge);
  }
  return out;
}

void fix(const std::vector<NamedLength>& lengths, const std::vector<GarmentTemplate>& templates,
         AnalyzeOptions& how) {
  const std::vector<Named> names = dimension_names(templates);
  for (const NamedLength& one : lengths) {
    const auto [garment, name] = find_named("--fix", one.name, names);
    if (!how.fixed[garment].emplace(name, one.cm / 100).second)
      throw UsageError("--fix: " + in_quotes(one.name) + " is given twice; give it once");
  }
  try {
    check_fixed(how, templates);
  } catch (const UsageError& error) {
    throw UsageError(std::string("--fix: ") + error.what());
  }
}

void hint(const std::vector<NamedLength>& heights, const std::vector<GarmentTemplate>& templates,
          AnalyzeOptions& how) {
  const std::vector<Named> names = edge_names(templates);
  std::map<std::string, double> edges;
  for (const NamedLength& one : heights) {
    const auto [garment, name] = find_named("--hint", one.name, names);
    if (one.cm > kTallest)
      throw UsageError("--hint: " + in_quotes(one.name) +
                       " lies more than 300 cm above the floor; give its height in cm");
    const std::string edge = garment + "." + name.substr(0, name.size() - std::strlen(kEdge));
    if (!edges.emplace(edge, one.cm / 100).second)
      throw UsageError("--hint: " + in_quotes(one.name) + " is given twice; give it once");
  }
  for (const auto& [edge, height] : edges) how.placement.edges[edge] = height;
}

/// "length" and "skirt.length" are the same: a plain name is given only where it is the only one.
bool same_name(const std::string& a, const std::string& b) {
  return a == b || a.ends_with("." + b) || b.ends_with("." + a);
}

std::vector<std::string> more_texts(const std::string& option,
                                    const std::vector<std::string>& before,
                                    const std::vector<std::string>& now) {
  const std::vector<NamedLength> newer = named_lengths(option, now);
  std::vector<std::string> out;
  for (const std::string& text : before)
    for (const std::string& one : split_at_commas(text)) {
      const std::string name = named_length(option, one).name;
      if (std::none_of(newer.begin(), newer.end(),
                       [&](const NamedLength& n) { return same_name(n.name, name); }))
        out.push_back(one);
    }
  out.insert(out.end(), now.begin(), now.end());
  return out;
}

std::string joined(const std::vector<std::string>& texts) {
  std::string out;
  for (const std::string& text : texts) out += (out.empty() ? "" : ",") + text;
  return out;
}

}  // namespace

void add_known_options(CLI::App& command, KnownArguments& a) {
  const auto add = [&](CLI::Option* option) { return option->group("Help from a person"); };
  one_each(add(command.add_option("--fix", a.fix,
                                  "A dimension that is known, NAME=CM: held exactly; of several "
                                  "garments skirt.length=54; repeat for more")));
  one_each(
      add(command.add_option("--hint", a.hint,
                             "Height of an edge above the floor, NAME_edge=CM (waist, hem, "
                             "left_cuff ...): looked for within 3 cm of it; repeat for more")));
  add(command.add_option("--fabric", a.fabric,
                         "How far worn cloth stretches: woven, jersey or elastic"));
}

std::vector<NamedLength> named_lengths(const std::string& option,
                                       const std::vector<std::string>& texts) {
  std::vector<NamedLength> out;
  for (const std::string& text : texts)
    for (const std::string& one : split_at_commas(text)) out.push_back(named_length(option, one));
  if (out.size() > kMostTexts) throw UsageError(option + ": more than 64 are given; give fewer");
  return out;
}

void check_known(const KnownArguments& a) {
  named_lengths("--fix", a.fix);
  named_lengths("--hint", a.hint);
  if (!a.fabric.empty()) fabric_named(a.fabric);
}

void apply_known(const KnownArguments& a, const std::vector<GarmentTemplate>& templates,
                 AnalyzeOptions& how) {
  if (!a.fabric.empty()) how.fabric = fabric_named(a.fabric);
  if (!a.fix.empty()) fix(named_lengths("--fix", a.fix), templates, how);
  if (!a.hint.empty()) hint(named_lengths("--hint", a.hint), templates, how);
}

KnownArguments more_known(const KnownArguments& before, const KnownArguments& now) {
  return {more_texts("--fix", before.fix, now.fix), more_texts("--hint", before.hint, now.hint),
          now.fabric.empty() ? before.fabric : now.fabric};
}

std::vector<std::pair<std::string, std::string>> chosen_known(const KnownArguments& a) {
  std::vector<std::pair<std::string, std::string>> out;
  if (!a.fix.empty()) out.emplace_back("fix", joined(a.fix));
  if (!a.hint.empty()) out.emplace_back("hint", joined(a.hint));
  if (!a.fabric.empty()) out.emplace_back("fabric", a.fabric);
  return out;
}

}  // namespace regarment
