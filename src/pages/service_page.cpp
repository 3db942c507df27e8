#include "pages/service_page.h"

#include <algorithm>
#include <array>

#include "base/error.h"
#include "pages/garment_choices.h"
#include "pages/page_texts.h"
#include "report/embedded.h"
#include "report/gaps.h"
#include "report/version.h"

namespace regarment {
namespace {

constexpr const char* kPagePolicy =
    "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' data:; "
    "connect-src 'self'; form-action 'none'; base-uri 'none'; frame-ancestors 'none'";
constexpr const char* kFilePolicy = "default-src 'none'; frame-ancestors 'none'";
// A drawing brings its style with it.
constexpr const char* kDrawingPolicy =
    "default-src 'none'; style-src 'unsafe-inline'; frame-ancestors 'none'; sandbox";

struct PageKind {
  const char *main, *script, *title, *subject;
};
constexpr PageKind kHome = {"home.html", "home.js", "Measure scans",
                            "Flat sizes and labels of the clothes on a 3D scan."};
constexpr PageKind kJob = {"job.html", "job.js", "Job", ""};
constexpr PageKind kCorrect = {"correct.html", "correct.js", "Correct a result", ""};
constexpr PageKind kReview = {"review_queue.html", "review_queue.js", "Results to review",
                              "What was measured and has no verdict yet."};
constexpr PageKind kEvaluate = {"evaluate.html", "evaluate.js", "Evaluation",
                                "How far many scans are from their truth."};

// The review page's own scripts are used again.
constexpr std::array kReportScripts = {"review.js", "review_verdicts.js"};

ServicePage html(const PageKind& kind) {
  Gaps page;
  page.set("title", std::string(kind.title));
  page.set("subject", std::string(kind.subject));
  page.set("script", std::string(kind.script));
  page.set("main", page_text(kind.main));
  page.set("version", version());
  return {"text/html; charset=utf-8", fill_template(page_text("page.html"), page), kPagePolicy};
}

std::string style() {
  std::string out;
  for (const char* name : {"report.css", "report_pictures.css", "report_media.css", "review.css"})
    out += embedded_text(name);
  return out + page_text("service.css");
}

std::optional<std::string> script(const std::string& name) try {
  const bool of_report =
      std::find(kReportScripts.begin(), kReportScripts.end(), name) != kReportScripts.end();
  return of_report ? embedded_text(name) : page_text(name);
} catch (const InvalidInput&) {
  return std::nullopt;  // none of this name is compiled in
}

std::optional<ServicePage> file(const std::string& name) {
  constexpr std::string_view kDrawing = "garment-", kDrawingEnd = ".svg";
  if (name.ends_with(".js")) {
    std::optional<std::string> text = script(name);
    if (!text) return std::nullopt;
    return ServicePage{"text/javascript; charset=utf-8", std::move(*text), kFilePolicy};
  }
  if (name == "style.css") return ServicePage{"text/css; charset=utf-8", style(), kFilePolicy};
  if (name == "garments.json")
    return ServicePage{"application/json", garment_choices_json(), kFilePolicy};
  if (!name.starts_with(kDrawing) || !name.ends_with(kDrawingEnd)) return std::nullopt;
  const std::string garment =
      name.substr(kDrawing.size(), name.size() - kDrawing.size() - kDrawingEnd.size());
  std::optional<std::string> drawing = garment_sketch(garment);
  if (!drawing) return std::nullopt;
  return ServicePage{"image/svg+xml", std::move(*drawing), kDrawingPolicy};
}

}  // namespace

std::optional<ServicePage> service_page(const std::vector<std::string>& path) {
  const std::string first = path.empty() ? std::string() : path[0];
  if (path.size() <= 1) {
    if (first.empty()) return html(kHome);
    if (first == "review") return html(kReview);
    if (first == "evaluate") return html(kEvaluate);
    return std::nullopt;
  }
  if (first == "pages" && path.size() == 2) return file(path[1]);
  if (first == "jobs" && path.size() == 2) return html(kJob);
  if (first == "jobs" && path.size() == 3 && path[2] == "correct") return html(kCorrect);
  return std::nullopt;
}

const std::vector<std::string>& service_page_patterns() {
  static const std::vector<std::string> patterns = {
      "/", "/review", "/evaluate", "/jobs/{id}", "/jobs/{id}/correct", "/pages/{file}"};
  return patterns;
}

}  // namespace regarment
