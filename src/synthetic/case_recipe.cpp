#include "synthetic/case_recipe.h"

#include <algorithm>
#include <array>
#include <numeric>

#include "base/error.h"
#include "base/one_line.h"
#include "synthetic/case_body.h"
#include "synthetic/case_scan.h"

namespace regarment {
namespace {

struct OutfitShare {
  Outfit outfit;
  double share;
};

constexpr std::array<OutfitShare, 9> kOutfits = {
    OutfitShare{Outfit::PencilSkirt, 0.08},    OutfitShare{Outfit::StraightSkirt, 0.08},
    OutfitShare{Outfit::ALineSkirt, 0.14},     OutfitShare{Outfit::FlaredSkirt, 0.12},
    OutfitShare{Outfit::TightTshirt, 0.12},    OutfitShare{Outfit::Tshirt, 0.16},
    OutfitShare{Outfit::OversizeTshirt, 0.08}, OutfitShare{Outfit::TshirtOverSkirt, 0.14},
    OutfitShare{Outfit::TuckedTshirt, 0.08}};

std::string listed(const std::vector<std::string>& names) {
  std::string out;
  for (const std::string& name : names) out += (out.empty() ? "" : ", ") + one_line(name, 60);
  return out;
}

Outfit sample_outfit(const CaseDice& dice, const CaseWish& wish) {
  std::vector<Outfit> outfits;
  std::vector<double> shares;
  for (const OutfitShare& each : kOutfits) {
    if (!wish.garments.empty() && outfit_templates(each.outfit) != wish.garments) continue;
    outfits.push_back(each.outfit);
    shares.push_back(each.share);
  }
  const double sum = std::accumulate(shares.begin(), shares.end(), 0.0);
  for (double& share : shares) share /= sum;
  return outfits[dice.pick(CaseChoice::Wear, shares)];
}

ScanKind sample_kind(const CaseDice& dice, const CaseWish& wish) {
  constexpr std::array<double, 3> kShares = {0.4, 0.3, 0.3};
  if (wish.kind) return *wish.kind;
  return static_cast<ScanKind>(dice.pick(CaseChoice::Kind, kShares));
}

}  // namespace

void check_wish(const CaseWish& wish) {
  const bool any = std::any_of(kOutfits.begin(), kOutfits.end(), [&](const OutfitShare& each) {
    return outfit_templates(each.outfit) == wish.garments;
  });
  if (any || wish.garments.empty()) return;
  throw UsageError("no outfit consists of " + listed(wish.garments) +
                   "; there are skirt; tshirt; tshirt over skirt; and skirt over tshirt");
}

std::string_view kind_name(ScanKind kind) {
  constexpr std::array<std::string_view, 3> kNames = {"cloud", "open", "closed"};
  return kNames[static_cast<std::size_t>(kind)];
}

std::string CaseRecipe::name() const {
  std::string number = std::to_string(index);
  if (number.size() < 4) number.insert(0, 4 - number.size(), '0');
  return "case-" + number;
}

CaseRecipe sample_case(std::uint64_t seed, std::uint32_t index, const CaseWish& wish,
                       std::uint32_t attempt) {
  check_wish(wish);
  CaseDice dice(seed, index, attempt);
  CaseRecipe out;
  out.seed = seed, out.index = index, out.attempt = attempt;
  out.outfit = sample_outfit(dice, wish);
  out.kind = sample_kind(dice, wish);
  out.body = sample_body(out.outfit, dice);
  const Mesh body = make_body(out.body);
  out.garments = sample_garments(out.outfit, body, body_girths(body), dice);
  sample_scan(dice, out);
  return out;
}

}  // namespace regarment
