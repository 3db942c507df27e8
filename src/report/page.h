#pragma once

#include <map>
#include <string>
#include <vector>

#include "report/result.h"

namespace regarment {

/// What the page shows beside the numbers.
struct PageParts {
  std::map<std::string, std::string>
      pictures;                       // StoredFigure::file -> bytes of a WebP, JPEG or PNG
  std::vector<std::string> sketches;  // one SVG per garment, letters beside its arrows
  std::string view;                   // of view_json; empty: nothing to turn
  std::vector<std::string>
      evaluations;  // one evaluations-I.csv per garment, empty where nothing was searched
};

/// The whole report as one HTML file that requests nothing. Depends on its arguments alone, so a
/// stored result gives the same bytes again. Throws ReadError when a picture is missing or is not
/// what its name says, or evaluations are not those of the result.
std::string report_page(const Result& result, const PageParts& parts);

}  // namespace regarment
