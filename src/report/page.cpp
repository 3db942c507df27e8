#include "report/page.h"

#include "base/error.h"
#include "report/embedded.h"
#include "report/page_parts.h"

namespace regarment {

std::string report_page(const Result& result, const PageParts& parts) {
  if (parts.drawings.size() != result.garments.size() ||
      parts.evaluations.size() != result.garments.size()) {
    throw InvalidInput("one drawing and one table of evaluations per garment are needed");
  }
  Gaps page;
  page.set("style", embedded_text("report.css"));
  show_verdict(result, page);
  std::vector<Gaps> garments;
  for (std::size_t i = 0; i < result.garments.size(); ++i) {
    garments.push_back(show_garment(result.garments[i], i + 1, parts.drawings[i]));
  }
  page.set("garments", std::move(garments));
  show_figures(result, parts, page);
  show_searches(result, parts, page);
  show_scan(result, page);
  show_labels(result, page);
  show_settings(result, page);
  return fill_template(embedded_text("report.html"), page);
}

}  // namespace regarment
