#include "synthetic/case_outfit.h"

#include <algorithm>
#include <array>
#include <numbers>

#include "garment/find_template.h"
#include "synthetic/case_fabric.h"
#include "synthetic/surface_contact.h"

namespace regarment {
namespace {

constexpr double kHipDepth = 0.2;      // m below the top edge, as in the skirt's template
constexpr double kThickAtTwo = 0.002;  // m, thickest cloth where two garments lie on each other
constexpr double kStep = 0.02;         // m between heights whose girths are compared

struct OutfitRow {
  Outfit outfit;
  const char* name;
  bool skirt, tshirt;
};

constexpr std::array<OutfitRow, 9> kOutfits = {
    OutfitRow{Outfit::PencilSkirt, "pencil skirt", true, false},
    OutfitRow{Outfit::StraightSkirt, "straight skirt", true, false},
    OutfitRow{Outfit::ALineSkirt, "A-line skirt", true, false},
    OutfitRow{Outfit::FlaredSkirt, "flared skirt", true, false},
    OutfitRow{Outfit::TightTshirt, "tight T-shirt", false, true},
    OutfitRow{Outfit::Tshirt, "T-shirt", false, true},
    OutfitRow{Outfit::OversizeTshirt, "oversize T-shirt", false, true},
    OutfitRow{Outfit::TshirtOverSkirt, "T-shirt over skirt", true, true},
    OutfitRow{Outfit::TuckedTshirt, "T-shirt tucked into skirt", true, true}};

const OutfitRow& row_of(Outfit outfit) { return kOutfits[static_cast<std::size_t>(outfit)]; }

// How much longer than a tape on the skin the middle of cloth is that lies on it.
double round_the_body(double thickness) {
  return 2 * std::numbers::pi * (0.5 * thickness + kAirGap);
}

double widest(const Mesh& body, double from, double to) {
  double out = 0;
  for (double y = from; y <= to; y += kStep) out = std::max(out, tape_girth(body, y));
  return std::max(out, tape_girth(body, to));
}

GarmentWish finish(const char* name, const Dimensions& drawn, const SheetFabric& fabric) {
  GarmentWish wish;
  wish.template_name = name;
  wish.dimensions = find_template(name).nearest_possible(drawn);
  wish.fabric = fabric;
  return wish;
}

// How a skirt falls below the hip: the hem against the hip.
double flare(Outfit outfit, CaseDice& dice) {
  switch (outfit) {
    case Outfit::PencilSkirt:
      return dice.uniform(0.86, 1.0);
    case Outfit::StraightSkirt:
      return dice.uniform(1.0, 1.12);
    case Outfit::FlaredSkirt:
      return dice.uniform(1.5, 2.05);
    default:
      return dice.uniform(1.12, 1.5);
  }
}

// Longest that leaves the hem a hand's breadth above the floor; flared ones are shorter, for their
// folds would stand on the feet.
double skirt_length(Outfit outfit, double top, CaseDice& dice) {
  const double most = std::min(outfit == Outfit::FlaredSkirt ? 0.75 : 0.95, top - 0.12);
  const double least = outfit == Outfit::PencilSkirt ? 0.38 : 0.3;
  return dice.uniform(least, most);
}

GarmentWish sample_skirt(Outfit outfit, const Mesh& body, const BodyGirths& girths, double inside,
                         CaseDice& dice) {
  const SheetFabric fabric =
      sample_fabric(dice.uniform(0, 1), inside > 0 ? kThickAtTwo : 0.005, dice);
  const double low = girths.hip_height + 0.45 * (girths.waist_height - girths.hip_height);
  const double top = dice.uniform(low, girths.waist_height + 0.02);
  const double around = round_the_body(fabric.thickness) + 2 * std::numbers::pi * inside;
  const double ease = inside > 0 ? dice.uniform(1.0, 1.05) : dice.uniform(0.96, 1.04);
  const double hip_ease = inside > 0 ? dice.uniform(0.04, 0.2) : dice.uniform(-0.02, 0.2);
  const double hip_girth = widest(body, std::max(top - kHipDepth, girths.crotch), top) + around;
  Dimensions d;
  d["length"] = skirt_length(outfit, top, dice);
  d["waist"] = ease * (tape_girth(body, top) + around);
  d["hip"] = std::max((1 + hip_ease) * hip_girth, d["waist"]);
  // A hem goes round both legs wherever it ends, and so do all places above it.
  const double legs = widest(body, std::max(top - d["length"], 0.05), girths.hip_height) + around;
  d["width"] = std::max(flare(outfit, dice) * d["hip"], 1.02 * legs);
  GarmentWish wish = finish("skirt", d, fabric);
  wish.top_height = top;
  if (dice.chance(0.4)) wish.band = dice.uniform(0.02, 0.045);
  return wish;
}

enum class Sleeve { Cap, Short, Half, Long };

Sleeve draw_sleeve(CaseDice& dice) {
  const double u = dice.uniform(0, 1);
  if (u < 0.1) return Sleeve::Cap;
  if (u < 0.65) return Sleeve::Short;
  return u < 0.82 ? Sleeve::Half : Sleeve::Long;
}

// Share of the way from the shoulder's tip to the wrist.
double sleeve_share(Sleeve sleeve, CaseDice& dice) {
  switch (sleeve) {
    case Sleeve::Cap:
      return dice.uniform(0.12, 0.2);
    case Sleeve::Short:
      return dice.uniform(0.25, 0.45);
    case Sleeve::Half:
      return dice.uniform(0.5, 0.72);
    default:
      return dice.uniform(0.85, 1.0);
  }
}

struct Ease {
  double low, high;  // m, of the T-shirt's width over the chest
};

Ease tshirt_ease(Outfit outfit) {
  if (outfit == Outfit::TightTshirt) return {0.0, 0.05};
  if (outfit == Outfit::OversizeTshirt) return {0.2, 0.42};
  if (outfit == Outfit::TuckedTshirt) return {0.01, 0.07};
  return {0.05, 0.22};
}

// Adds the sleeves of a T-shirt whose width is known.
void sample_sleeves(Outfit outfit, const BodyGirths& girths, CaseDice& dice, Dimensions& d) {
  const Sleeve sleeve = draw_sleeve(dice);
  const double shoulder_point = std::min(0.86 * d["width"] / 4, 0.235);  // the template's rule
  // The joint lies within the shoulder, whose tip is about 4 cm further out.
  const double arm = girths.arm + girths.shoulder + 0.04 - shoulder_point;
  const double share = sleeve_share(sleeve, dice);
  const bool wide = outfit == Outfit::OversizeTshirt;
  const double girth = girths.upper_arm_girth + std::max(0.0, (share - 0.35) / 0.65) *
                                                    (girths.wrist_girth - girths.upper_arm_girth);
  d["sleeve_length"] = share * arm;
  d["sleeve_seam"] = 1.15 * girths.upper_arm_girth + dice.uniform(0.06, wide ? 0.24 : 0.17);
  double loose =
      outfit == Outfit::TightTshirt ? dice.uniform(1.06, 1.22) : dice.uniform(1.12, 1.55);
  if (dice.chance(0.12)) loose = dice.uniform(1.5, 2.0);  // wide cuffs
  d["sleeve_opening"] = std::min(loose * girth, 1.15 * d["sleeve_seam"]);
}

// Where the hem of a T-shirt ends, m above the floor.
double hem_height(Outfit outfit, const BodyGirths& girths, double skirt_top, CaseDice& dice) {
  const double waist = girths.waist_height;
  if (outfit == Outfit::TuckedTshirt) return skirt_top - dice.uniform(0.08, 0.16);
  if (outfit == Outfit::TshirtOverSkirt) return skirt_top - dice.uniform(0.06, 0.2);
  if (dice.chance(0.12)) return dice.uniform(waist - 0.05, waist + 0.1);  // shows the belly
  const double low = outfit == Outfit::OversizeTshirt ? girths.crotch - 0.2 : girths.crotch - 0.04;
  return dice.uniform(low, waist - 0.08);
}

GarmentWish sample_tshirt(Outfit outfit, const Mesh& body, const BodyGirths& girths,
                          const GarmentWish* skirt, CaseDice& dice) {
  const SheetFabric fabric =
      sample_fabric(dice.uniform(0, skirt ? 0.7 : 1.0), skirt ? kThickAtTwo : 0.004, dice);
  const double around = round_the_body(fabric.thickness);
  const Ease ease = tshirt_ease(outfit);
  const double hem = hem_height(outfit, girths, skirt ? skirt->top_height : 0, dice);
  Dimensions d;
  d["width"] = girths.chest + around + dice.uniform(ease.low, ease.high);
  // The sides are straight, so the hem must go round the hips as well, and round a skirt.
  const bool over = outfit == Outfit::TshirtOverSkirt;
  const double cover = over ? 2 * std::numbers::pi * 2 * kThickAtTwo : 0;
  const double below = widest(body, hem, girths.waist_height) + around + cover;
  d["width"] = std::max(d["width"], (over ? 1.04 : 1.0) * below);
  if (over) d["width"] = std::max(d["width"], 1.02 * skirt->dimensions.at("hip"));
  d["length"] = girths.neck_height - hem;
  sample_sleeves(outfit, girths, dice, d);
  return finish("tshirt", d, fabric);
}

// What the skirt of two garments looks like: over a T-shirt it may not be wide above.
Outfit skirt_of_two(CaseDice& dice) {
  constexpr std::array<Outfit, 3> kSkirts = {Outfit::StraightSkirt, Outfit::ALineSkirt,
                                             Outfit::FlaredSkirt};
  return kSkirts[static_cast<std::size_t>(dice.uniform(0, 3))];
}

}  // namespace

std::string_view outfit_name(Outfit outfit) { return row_of(outfit).name; }
bool has_skirt(Outfit outfit) { return row_of(outfit).skirt; }
bool has_tshirt(Outfit outfit) { return row_of(outfit).tshirt; }

std::vector<std::string> outfit_templates(Outfit outfit) {
  if (outfit == Outfit::TuckedTshirt) return {"skirt", "tshirt"};
  if (outfit == Outfit::TshirtOverSkirt) return {"tshirt", "skirt"};
  return {has_skirt(outfit) ? "skirt" : "tshirt"};
}

std::vector<GarmentWish> sample_garments(Outfit outfit, const Mesh& body, const BodyGirths& girths,
                                         CaseDice& dice) {
  if (!has_tshirt(outfit)) return {sample_skirt(outfit, body, girths, 0, dice)};
  if (!has_skirt(outfit)) return {sample_tshirt(outfit, body, girths, nullptr, dice)};
  const bool tucked = outfit == Outfit::TuckedTshirt;
  const double inside = tucked ? kThickAtTwo : 0;
  const GarmentWish skirt = sample_skirt(skirt_of_two(dice), body, girths, inside, dice);
  const GarmentWish tshirt = sample_tshirt(outfit, body, girths, &skirt, dice);
  if (tucked) return {skirt, tshirt};
  return {tshirt, skirt};
}

}  // namespace regarment
