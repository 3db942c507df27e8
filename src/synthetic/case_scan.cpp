#include "synthetic/case_scan.h"

#include <array>
#include <numbers>

namespace regarment {
namespace {

constexpr double kPi = std::numbers::pi;

Colour shade(CaseDice& dice, double low, double high) {
  Colour out;
  for (auto& channel : out) channel = static_cast<std::uint8_t>(dice.uniform(low, high));
  return out;
}

void sample_colours(CaseDice& dice, CaseRecipe& recipe) {
  ColourOptions& colours = recipe.scanner.colours;
  colours.coloured = dice.share(CaseChoice::Paint) < 0.5;
  const double dark = dice.uniform(0.35, 1.0);
  for (auto& channel : colours.skin) channel = static_cast<std::uint8_t>(channel * dark);
  for (std::size_t g = 0; g < recipe.garments.size(); ++g) {
    ClothColour cloth;
    cloth.colour = shade(dice, 25, 240);
    cloth.second = shade(dice, 25, 240);
    if (dice.chance(0.25)) cloth.stripe = dice.uniform(0.01, 0.06);
    colours.garments.push_back(cloth);
  }
  if (dice.chance(0.15)) colours.alike = dice.uniform(0.6, 1.0);
}

void sample_frame(CaseDice& dice, FileFrame& frame) {
  constexpr std::array<double, 4> kUnitShares = {0.35, 0.1, 0.45, 0.1};
  constexpr std::array<const char*, 4> kUnits = {"mm", "cm", "m", "inch"};
  constexpr std::array<const char*, 6> kAxes = {"+y", "+z", "+x", "-x", "-y", "-z"};
  frame.units = kUnits[dice.pick(CaseChoice::Unit, kUnitShares)];
  const double axis = dice.uniform(0, 1);
  if (axis < 0.8) {
    frame.up = kAxes[axis < 0.4 ? 0 : 1];
  } else {
    frame.up = kAxes[2 + static_cast<std::size_t>(dice.uniform(0, 4))];
  }
  const double turn = dice.uniform(0, 1);
  if (turn > 0.4) frame.yaw = dice.uniform(-0.5, 0.5);
  if (turn > 0.65) frame.yaw += kPi / 2 * std::floor(dice.uniform(-1, 3));
  if (dice.chance(0.5)) {
    for (int k = 0; k < 3; ++k) frame.shift[k] = dice.uniform(-1.5, 1.5);
  }
}

// A scanner as there are: its number of columns, its grain and its everyday noise.
void sample_scanner(CaseDice& dice, CaseRecipe& recipe) {
  RigOptions& rig = recipe.scanner.rig;
  rig.columns = dice.chance(0.6) ? 4 : static_cast<int>(dice.uniform(3, 7));
  rig.distance = dice.uniform(1.7, 2.6);
  rig.yaw = kPi / rig.columns + dice.about(0, 0.1);
  rig.pixel = dice.uniform(0.0028, 0.004);
  SensingOptions& sensing = recipe.scanner.sensing;
  sensing.noise = dice.uniform(0.0002, 0.0008);
  sensing.calibration = dice.uniform(0, 0.0004);
  sensing.mixed = dice.uniform(0, 0.1);
  if (dice.chance(0.3)) sensing.quantum = dice.uniform(0.0002, 0.001);
  recipe.spacing = dice.uniform(0.0032, 0.005);
  recipe.surface.cell = dice.uniform(0.0055, 0.009);
  recipe.surface.invented = std::max(0.012, 1.6 * recipe.surface.cell);
  recipe.surface.open_reach = std::max(0.012, 1.6 * recipe.surface.cell);
}

void add_noise(CaseDice& dice, CaseRecipe& recipe) {
  recipe.scanner.sensing.noise = dice.uniform(0.001, 0.003);
  recipe.damage.emplace_back("noise");
}

void add_holes(CaseDice& dice, CaseRecipe& recipe) {
  recipe.faults.holes = 2 + static_cast<int>(dice.uniform(0, 12));
  recipe.faults.hole_radius = dice.uniform(0.02, 0.07);
  recipe.damage.emplace_back("holes");
}

void add_missing_column(CaseDice& dice, CaseRecipe& recipe) {
  const int columns = recipe.scanner.rig.columns;
  recipe.scanner.rig.missing = {static_cast<int>(dice.uniform(0, columns))};
  recipe.damage.emplace_back("missing column");
}

void add_outliers(CaseDice& dice, CaseRecipe& recipe) {
  recipe.scanner.sensing.mixed = dice.uniform(0.3, 0.9);
  recipe.faults.stray = dice.uniform(0.0005, 0.01);
  recipe.faults.stray_reach = dice.uniform(0.02, 0.5);
  recipe.scanner.props.islands = static_cast<int>(dice.uniform(0, 8));
  recipe.damage.emplace_back("outliers");
}

void add_props(CaseDice& dice, CaseRecipe& recipe) {
  if (dice.chance(0.6)) {
    recipe.scanner.props.posts = 1 + static_cast<int>(dice.uniform(0, 4));
    recipe.damage.emplace_back("posts");
  }
  if (recipe.scanner.props.posts == 0 || dice.chance(0.5)) {
    recipe.scanner.props.floor_radius = dice.uniform(0.35, 0.8);
    recipe.damage.emplace_back("floor");
  }
}

void make_sparse(CaseDice& dice, CaseRecipe& recipe) {
  recipe.spacing = dice.uniform(0.007, 0.011);
  recipe.surface.cell = dice.uniform(0.011, 0.016);
  recipe.surface.invented = 1.5 * recipe.surface.cell;
  recipe.surface.open_reach = 1.5 * recipe.surface.cell;
  recipe.damage.emplace_back("sparse");
}

void add_dark_cloth(CaseDice& dice, CaseRecipe& recipe) {
  std::vector<double>& darkness = recipe.scanner.sensing.darkness;
  darkness.assign(recipe.garments.size() + 1, 0.0);
  darkness[1] = dice.uniform(0.4, 0.85);
  recipe.damage.emplace_back("dark cloth");
}

void add_damage(std::size_t which, CaseDice& dice, CaseRecipe& recipe) {
  switch (which) {
    case 0:
      return add_noise(dice, recipe);
    case 1:
      return add_holes(dice, recipe);
    case 2:
      return add_missing_column(dice, recipe);
    case 3:
      return add_outliers(dice, recipe);
    case 4:
      return add_props(dice, recipe);
    case 5:
      return make_sparse(dice, recipe);
    default:
      return add_dark_cloth(dice, recipe);
  }
}

}  // namespace

void sample_scan(CaseDice& dice, CaseRecipe& recipe) {
  constexpr double kUndamaged = 0.34, kTwice = 0.3;
  constexpr std::size_t kFaults = 7;
  sample_scanner(dice, recipe);
  sample_colours(dice, recipe);
  sample_frame(dice, recipe.frame);
  const double share = dice.share(CaseChoice::Damage);
  if (share < kUndamaged) return;
  const auto first = static_cast<std::size_t>(kFaults * (share - kUndamaged) / (1 - kUndamaged));
  add_damage(first, dice, recipe);
  if (!dice.chance(kTwice)) return;
  const auto second = static_cast<std::size_t>(dice.uniform(1, kFaults));
  add_damage((first + second) % kFaults, dice, recipe);
}

}  // namespace regarment
