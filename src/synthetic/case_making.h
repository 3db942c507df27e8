#pragma once

#include <string>
#include <vector>

#include "base/progress.h"
#include "synthetic/case_recipe.h"
#include "synthetic/dress.h"
#include "synthetic/truth_json.h"

namespace regarment {

/// A file of a case; `path` within the folder: "truth/case-0007.cloud.labels.u8".
struct CaseFile {
  std::string path;
  std::string bytes;
};

/// A case made: its files and what goes into the tables of all cases.
struct MadeCase {
  CaseTruth truth;
  std::vector<CaseFile> files;  // scan, labels, one PLY per garment
};

/// Draws case `index` and makes it: dresses the person, scans it, writes scan, labels and draped
/// garments as bytes. When the cloth comes to no good rest the case is drawn again, up to 31 times;
/// `given_up` of the truth says why. Same bytes for the same arguments. Throws UsageError as
/// sample_case does or when every attempt failed, Stopped when progress says so.
MadeCase make_case(std::uint64_t seed, std::uint32_t index, const CaseWish& wish = {},
                   const DressOptions& options = {}, const Progress& progress = {});

/// Why a dressed person is not used, for a person to read; empty when they are fine.
std::string refusal(const Dressing& dressing);

}  // namespace regarment
