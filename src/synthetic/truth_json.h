#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "synthetic/case_recipe.h"
#include "synthetic/dressed_person.h"

namespace regarment {

/// What is true of one garment of a case.
struct GarmentTruth {
  std::string template_name;
  Dimensions flat, worn;            // m
  std::vector<std::string> hidden;  // dimensions the scan does not show
};

/// What is true of a case.
struct CaseTruth {
  CaseRecipe recipe;
  std::vector<GarmentTruth> garments;  // outermost first
  std::vector<std::size_t> labels;     // how many vertices of each label: 0, 1, ..., last: 255
  std::vector<std::string> given_up;   // why earlier attempts came to nothing, in their order
  bool has_colours = false;
};

/// The scan's file: "case-0007.cloud.ply".
std::string scan_file(const CaseRecipe& recipe);

/// The case as an object of truth/truth.json, indented by one space.
std::string truth_json(const CaseTruth& truth);

/// The recipe alone, everything drawn.
std::string recipe_json(const CaseRecipe& recipe);

/// First line of truth/ground_truth.csv, and a case's lines. Paths are seen from the table.
std::string_view truth_csv_header();
std::string truth_csv_rows(const CaseTruth& truth);

}  // namespace regarment
