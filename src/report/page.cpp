#include "report/page.h"

#include "base/error.h"
#include "report/embedded.h"
#include "report/page_parts.h"

namespace regarment {

std::string report_page(const Result& result, const PageParts& parts) {
  if (parts.drawings.size() != result.garments.size()) {
    throw InvalidInput("one drawing per garment is needed");
  }
  View page;
  page.set("style", embedded_text("report.css"));
  view_verdict(result, page);
  std::vector<View> garments;
  for (std::size_t i = 0; i < result.garments.size(); ++i) {
    garments.push_back(view_garment(result.garments[i], parts.drawings[i]));
  }
  page.set("garments", std::move(garments));
  view_figures(result, parts, page);
  view_scan(result, page);
  view_labels(result, page);
  view_settings(result, page);
  return fill_template(embedded_text("report.html"), page);
}

}  // namespace regarment
