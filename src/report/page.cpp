#include "report/page.h"

#include <array>

#include "base/error.h"
#include "report/content_policy.h"
#include "report/embedded.h"
#include "report/page_parts.h"
#include "report/size_json_ld.h"
#include "report/view3d.h"

namespace regarment {
namespace {

// Each has a template of its own, filled with the gaps of the whole page.
constexpr std::array kSections = {"verdict",  "garments", "pictures", "view",
                                  "searches", "scan",     "settings"};
constexpr std::array kStyles = {"report.css", "report_pictures.css", "report_media.css"};
constexpr std::array kScripts = {"compare.js", "view3d_gl.js", "view3d.js"};

std::string joined(const auto& names) {
  std::string out;
  for (const char* name : names) out += embedded_text(name);
  return out;
}

}  // namespace

std::string report_page(const Result& result, const PageParts& parts) {
  if (parts.sketches.size() != result.garments.size() ||
      parts.evaluations.size() != result.garments.size()) {
    throw InvalidInput("one sketch and one table of evaluations per garment are needed");
  }
  Gaps page;
  show_verdict(result, page);
  std::vector<Gaps> garments;
  for (std::size_t i = 0; i < result.garments.size(); ++i) {
    garments.push_back(show_garment(result.garments[i], i + 1, parts.sketches[i]));
  }
  page.set("garments", std::move(garments));
  show_figures(result, parts, page);
  check_view(parts.view);
  page.set_maybe("view", parts.view);
  show_searches(result, parts, page);
  show_scan(result, page);
  show_labels(result, page);
  show_settings(result, page);
  for (const std::string section : kSections) {
    page.set(section + "_html", fill_template(embedded_text(section + ".html"), page));
  }
  page.set("sizes", size_json_ld(result));
  const std::string style = joined(kStyles), script = joined(kScripts);
  page.set("style", style);
  page.set("script", script);
  page.set("policy", content_policy(style, script));
  return fill_template(embedded_text("report.html"), page);
}

}  // namespace regarment
