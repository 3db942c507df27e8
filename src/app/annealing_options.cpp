#include "app/annealing_options.h"

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <numbers>

namespace regarment {
namespace {

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.10g", value);
  return text;
}

/// CLI::Range lets "nan" pass.
std::string a_number(const std::string& text) {
  return std::isnan(std::strtod(text.c_str(), nullptr)) ? "'" + text + "' is no number" : "";
}

/// The switches: name, whether it is thrown, what for.
struct Switch {
  const char* name;
  bool AnnealingArguments::*member;
  bool thrown;  // value of the member when the switch is given
  const char* help;
};

constexpr Switch kSwitches[] = {
    {"collisions", &AnnealingArguments::collisions, true, "Keep the cloth outside of the scan"},
    {"no-cap-detection", &AnnealingArguments::cap_detection, false,
     "Let surface invented under a hem attract the cloth"},
    {"no-border-rejection", &AnnealingArguments::border_rejection, false,
     "Let the border of an open scan attract the cloth"},
    {"free-edges", &AnnealingArguments::held_edges, false,
     "Let hem, waist, cuffs and neck slide instead of holding them where they show on the scan"},
    {"no-rough-search", &AnnealingArguments::rough_search, false,
     "Weigh the error and begin the runs at the template's typical size"},
    {"no-hesitation", &AnnealingArguments::hesitation, false,
     "Pull particles whose closest point jumps to and fro as strongly as others"},
    {"no-square-root", &AnnealingArguments::square_root, false,
     "Leave the square root of Eq. (1) out"},
    {"as-printed", &AnnealingArguments::as_printed, true,
     "The paper's method without our departures: free edges that attract, each drape from the "
     "last, "
     "no rough search, no hesitation"},
};

std::vector<std::pair<std::string, std::string>> with_values(const AnnealingArguments& a) {
  return {{"runs", std::to_string(a.runs)},
          {"evaluations", std::to_string(a.evaluations)},
          {"segment-distance", number(a.segment_distance_mm)},
          {"attraction", a.attraction},
          {"normal-angle", number(a.normal_angle_deg)},
          {"layer-attenuation", number(a.layer_attenuation)},
          {"drape-from", a.drape_from}};
}

}  // namespace

void add_annealing_options(CLI::App& fit, AnnealingArguments& a) {
  const auto add = [&](CLI::Option* option) { return option->group("Method annealing"); };
  add(fit.add_option("--runs", a.runs, "Searches from different seeds; the best is kept"))
      ->check(CLI::Range(1, 100))
      ->capture_default_str();
  add(fit.add_option("--evaluations", a.evaluations, "At most so many drapes a run"))
      ->check(CLI::Range(20, 100'000))
      ->capture_default_str();
  add(fit.add_option("--segment-distance", a.segment_distance_mm,
                     "Scan this near to the draped garment is labelled garment, mm"))
      ->check(CLI::Range(0.1, 1000.0))
      ->check(a_number)
      ->capture_default_str();
  add(fit.add_option("--attraction", a.attraction,
                     "What attracts the cloth: surface of similar normals, or the closest"))
      ->check(CLI::IsMember({"normals", "closest"}))
      ->capture_default_str();
  add(fit.add_option("--normal-angle", a.normal_angle_deg,
                     "Largest angle between normals that are similar, degrees"))
      ->check(CLI::Range(1.0, 180.0))
      ->check(a_number)
      ->capture_default_str();
  add(fit.add_option("--layer-attenuation", a.layer_attenuation,
                     "How strongly scan of an outer garment attracts the next one, 0 to 1"))
      ->check(CLI::Range(0.0, 1.0))
      ->check(a_number)
      ->capture_default_str();
  add(fit.add_option("--drape-from", a.drape_from,
                     "Where a drape starts: at the run's best one so far, or at the last"))
      ->check(CLI::IsMember({"best", "last"}))
      ->capture_default_str();
  for (const Switch& one : kSwitches)
    add(fit.add_flag(std::string(one.thrown ? "--" : "!--") + one.name, a.*one.member, one.help));
}

void apply_annealing(const AnnealingArguments& a, AnalyzeOptions& how) {
  const bool departs = !a.as_printed;
  how.segment_distance = a.segment_distance_mm / 1000;
  how.cap_detection = a.cap_detection;
  how.layer_attenuation = a.layer_attenuation;
  how.hold_edges = departs && a.held_edges;
  how.fit.runs = a.runs;
  how.fit.search.max_evaluations = a.evaluations;
  how.fit.start_from_best = departs && a.drape_from == "best";
  how.fit.rough_search = departs && a.rough_search;
  how.fit.square_root = a.square_root;
  how.fit.drape.hesitation = departs && a.hesitation;
  how.fit.drape.collisions = a.collisions;
  AttractionOptions& attraction = how.fit.drape.attraction;
  attraction.by_normals = a.attraction == "normals";
  attraction.normal_angle = a.normal_angle_deg * std::numbers::pi / 180;
  attraction.border_rejection = departs && a.border_rejection;
}

std::vector<std::pair<std::string, std::string>> chosen_annealing(const AnnealingArguments& a) {
  const auto of_these = with_values(a), usual = with_values({});
  std::vector<std::pair<std::string, std::string>> out;
  for (std::size_t i = 0; i < of_these.size(); ++i)
    if (of_these[i] != usual[i]) out.push_back(of_these[i]);
  for (const Switch& one : kSwitches)
    if (a.*one.member == one.thrown) out.emplace_back(one.name, "");
  return out;
}

std::vector<std::pair<std::string, std::string>> every_annealing(const AnnealingArguments& a) {
  auto out = with_values(a);
  for (const Switch& one : kSwitches)
    out.emplace_back(one.name, a.*one.member == one.thrown ? "yes" : "no");
  return out;
}

}  // namespace regarment
