#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "synthetic/body_shape.h"
#include "synthetic/case_outfit.h"
#include "synthetic/damage.h"
#include "synthetic/file_frame.h"
#include "synthetic/reconstruct.h"
#include "synthetic/scanner.h"

namespace regarment {

/// What a scan's file holds.
enum class ScanKind { Cloud, OpenMesh, ClosedMesh };

std::string_view kind_name(ScanKind kind);  // "cloud", "open", "closed"

/// Everything a case is made from.
struct CaseRecipe {
  std::uint64_t seed = 1;
  std::uint32_t index = 0;
  std::uint32_t attempt = 0;  // 0, or how often the case was drawn before
  Outfit outfit = Outfit::ALineSkirt;
  BodyShape body;
  std::vector<GarmentWish> garments;  // outermost first
  ScanKind kind = ScanKind::Cloud;
  ScannerOptions scanner;
  ReconstructOptions surface;  // of meshes
  double spacing = 0.004;      // m between the points of a cloud
  DamageOptions faults;        // of the cloud, besides those of the scanner
  FileFrame frame;
  std::vector<std::string> damage;  // what is wrong with the scan; empty: nothing

  std::string name() const;  // "case-0007"
};

/// Which cases are wanted; empty: all.
struct CaseWish {
  std::vector<std::string> garments;  // templates, outermost first: no other outfits than of these
  std::optional<ScanKind> kind;
};

/// Throws UsageError when no outfit consists of the garments wished for.
void check_wish(const CaseWish& wish);

/// Draws a case. It depends on the arguments alone, so any case can be made by itself; cases of
/// neighbouring indices share out outfits, kinds, damage, builds and units evenly. Throws as
/// check_wish does.
CaseRecipe sample_case(std::uint64_t seed, std::uint32_t index, const CaseWish& wish = {},
                       std::uint32_t attempt = 0);

}  // namespace regarment
