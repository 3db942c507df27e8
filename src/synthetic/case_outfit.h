#pragma once

#include <string_view>
#include <vector>

#include "synthetic/body_girths.h"
#include "synthetic/case_dice.h"
#include "synthetic/dress.h"

namespace regarment {

/// What somebody wears.
enum class Outfit {
  PencilSkirt,
  StraightSkirt,
  ALineSkirt,
  FlaredSkirt,
  TightTshirt,
  Tshirt,
  OversizeTshirt,
  TshirtOverSkirt,
  TuckedTshirt,
};

std::string_view outfit_name(Outfit outfit);  // "flared skirt"
bool has_skirt(Outfit outfit);
bool has_tshirt(Outfit outfit);

/// The templates it consists of, outermost first.
std::vector<std::string> outfit_templates(Outfit outfit);

/// Sizes and fabrics for a person of make_body: drawn from the girths of this body where the
/// garment holds, plus ease, so that it can be put on and stays up; legal by its template. Garments
/// outermost first. Throws nothing of its own.
std::vector<GarmentWish> sample_garments(Outfit outfit, const Mesh& body, const BodyGirths& girths,
                                         CaseDice& dice);

}  // namespace regarment
