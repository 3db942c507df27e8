#include "synthetic/truth_json.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "garment/find_template.h"
#include "synthetic/body_library.h"

namespace regarment {
namespace {

using Json = nlohmann::ordered_json;

// A length as it is written: cm, to a micrometre.
double cm(double metres) { return std::round(metres * 1e6) / 1e4; }
double degrees(double radians) { return std::round(radians * 1.8e4 / std::numbers::pi) / 100; }
// Six figures behind the point say everything else.
double plain(double value) { return std::round(value * 1e6) / 1e6; }

std::string stem_of(const CaseRecipe& recipe) {
  return recipe.name() + (recipe.kind == ScanKind::Cloud ? ".cloud" : ".mesh");
}

// "+y" is told as "y", as the scans that were there before are.
std::string axis_name(const std::string& up) { return up[0] == '+' ? up.substr(1) : up; }

Json in_cm(const Dimensions& dimensions) {
  Json out = Json::object();
  for (const auto& [name, value] : dimensions) out[name] = cm(value);
  return out;
}

Json fabric_json(const SheetFabric& fabric) {
  return {{"thickness_mm", plain(fabric.thickness * 1000)},
          {"density", plain(fabric.density)},
          {"stiffness_along", plain(fabric.stiffness_along)},
          {"stiffness_across", plain(fabric.stiffness_across)},
          {"stiffness_shear", plain(fabric.stiffness_shear)},
          {"bending", fabric.bending},
          {"friction", plain(fabric.friction)}};
}

Json body_json(const BodyShape& shape) {
  Json blend = Json::object();
  for (std::size_t i = 0; i < shape.blend.size(); ++i) {
    if (shape.blend[i] > 0) blend[body_library().names[i]] = plain(shape.blend[i]);
  }
  return {{"blend", blend},
          {"scale", plain(shape.scale)},
          {"belly", plain(shape.belly)},
          {"chest", plain(shape.chest)},
          {"hips", plain(shape.hips)},
          {"thighs", plain(shape.thighs)},
          {"arms", plain(shape.arms)},
          {"shoulders", plain(shape.shoulders)},
          {"asymmetry", plain(shape.asymmetry)},
          {"arm_angle_deg", {degrees(shape.arm_angle[0]), degrees(shape.arm_angle[1])}},
          {"arms_back_deg", degrees(shape.arms_back)},
          {"legs_deg", degrees(shape.legs)},
          {"twist_deg", degrees(shape.twist)},
          {"lean_deg", degrees(shape.lean)},
          {"stoop_deg", degrees(shape.stoop)},
          {"tilt_deg", degrees(shape.tilt)},
          {"sway_cm", cm(shape.sway)}};
}

Json scanner_json(const CaseRecipe& recipe) {
  const ScannerOptions& scanner = recipe.scanner;
  Json out = {{"columns", scanner.rig.columns},
              {"missing", scanner.rig.missing},
              {"distance_m", plain(scanner.rig.distance)},
              {"pixel_mm", plain(scanner.rig.pixel * 1000)},
              {"noise_mm", plain(scanner.sensing.noise * 1000)},
              {"mixed", plain(scanner.sensing.mixed)},
              {"darkness", scanner.sensing.darkness},
              {"posts", scanner.props.posts},
              {"floor_m", plain(scanner.props.floor_radius)},
              {"islands", scanner.props.islands},
              {"holes", recipe.faults.holes},
              {"stray", plain(recipe.faults.stray)}};
  if (recipe.kind == ScanKind::Cloud) {
    out["spacing_mm"] = plain(recipe.spacing * 1000);
  } else {
    out["edge_mm"] = plain(recipe.surface.cell * 1000);
  }
  return out;
}

Json recipe_object(const CaseRecipe& recipe) {
  Json garments = Json::array();
  for (const GarmentWish& wish : recipe.garments) {
    Json garment = {{"template", wish.template_name}, {"fabric", fabric_json(wish.fabric)}};
    if (wish.band > 0) garment["band_cm"] = cm(wish.band);
    if (wish.top_height > 0) garment["top_height_cm"] = cm(wish.top_height);
    garments.push_back(garment);
  }
  return {{"seed", recipe.seed},
          {"index", recipe.index},
          {"attempt", recipe.attempt},
          {"outfit", outfit_name(recipe.outfit)},
          {"kind", kind_name(recipe.kind)},
          {"damage", recipe.damage},
          {"body", body_json(recipe.body)},
          {"garments", garments},
          {"scanner", scanner_json(recipe)}};
}

Json garments_json(const CaseTruth& truth) {
  Json out = Json::array();
  int layer = 1;
  for (const GarmentTruth& garment : truth.garments) {
    out.push_back({{"template", garment.template_name},
                   {"layer", layer++},
                   {"measurements_cm", in_cm(garment.flat)},
                   {"worn_cm", in_cm(garment.worn)},
                   {"not_observable", garment.hidden}});
  }
  return out;
}

Json labels_json(const CaseTruth& truth, std::size_t& total) {
  Json out = Json::object();
  for (std::size_t i = 0; i < truth.labels.size(); ++i) {
    if (truth.labels[i] == 0) continue;
    out[i + 1 == truth.labels.size() ? "255" : std::to_string(i)] = truth.labels[i];
    total += truth.labels[i];
  }
  return out;
}

std::string joined(const std::vector<std::string>& words) {
  std::string out;
  for (const std::string& word : words) out += (out.empty() ? "" : "; ") + word;
  return out;
}

std::string cell(double metres) { return Json(cm(metres)).dump(); }

}  // namespace

std::string scan_file(const CaseRecipe& recipe) { return stem_of(recipe) + ".ply"; }

std::string recipe_json(const CaseRecipe& recipe) { return recipe_object(recipe).dump(1); }

std::string truth_json(const CaseTruth& truth) {
  const CaseRecipe& recipe = truth.recipe;
  std::size_t total = 0;
  const Json labels = labels_json(truth, total);
  const Json out = {{"name", recipe.name()},
                    {"garments", garments_json(truth)},
                    {"scan",
                     {{"unit", recipe.frame.units},
                      {"up", axis_name(recipe.frame.up)},
                      {"yaw", degrees(recipe.frame.yaw)},
                      {"colour", truth.has_colours},
                      {"open", recipe.kind == ScanKind::OpenMesh}}},
                    {"points", {{"points", total}, {"labels", labels}}},
                    {"recipe", recipe_object(recipe)},
                    {"given_up", truth.given_up}};
  return out.dump(1);
}

std::string_view truth_csv_header() {
  return "scan,kind,layer,template,measurement,value_cm,worn_cm,observable,labels,damage,units,up,"
         "front\n";
}

std::string truth_csv_rows(const CaseTruth& truth) {
  const CaseRecipe& recipe = truth.recipe;
  std::string out;
  int layer = 1;
  for (const GarmentTruth& garment : truth.garments) {
    const GarmentTemplate kind = find_template(garment.template_name);
    for (const Dimension& dimension : kind.dimensions()) {
      const std::string& name = dimension.name;
      const bool hidden =
          std::find(garment.hidden.begin(), garment.hidden.end(), name) != garment.hidden.end();
      out += "../" + scan_file(recipe) + "," + std::string(kind_name(recipe.kind)) + "," +
             std::to_string(layer) + "," + garment.template_name + "," + name + "," +
             cell(garment.flat.at(name)) + "," + cell(garment.worn.at(name)) + "," +
             (hidden ? "false" : "true") + "," + stem_of(recipe) + ".labels.u8," +
             joined(recipe.damage) + "," + recipe.frame.units + "," + recipe.frame.up + "," +
             joined(front_axes(recipe.frame)) + "\n";
    }
    ++layer;
  }
  return out;
}

}  // namespace regarment
