#include "report/review_page.h"

#include <algorithm>

#include "base/sha256.h"
#include "report/checks.h"
#include "report/content_policy.h"
#include "report/embedded.h"
#include "report/judgement.h"
#include "report/page_parts.h"
#include "report/text.h"

namespace regarment {
namespace {

std::string digest_of(const std::string& text) {
  return sha256_hex(std::as_bytes(std::span(text))).substr(0, 16);
}

// Verdicts are kept under this: the same results in the same order give the same.
std::string page_digest(const std::vector<ReviewItem>& items) {
  std::string all;
  for (const ReviewItem& item : items) all += item.name + "\n" + item.result.scan.sha256 + "\n";
  return digest_of(all);
}

Gaps size_row(const ResultMeasurement& m) {
  Gaps row;
  row.set("title", m.title);
  row.set("value", fixed_text(m.value_cm, 1));
  row.set("low", fixed_text(m.low_cm, 1));
  row.set("high", fixed_text(m.high_cm, 1));
  row.set("hidden", !m.observable);
  row.set_maybe("error", m.error_cm() ? signed_cm_text(*m.error_cm() / 100.0) : "");
  const Judgement judgement = judge(m);
  row.set("out", judgement == Judgement::Fail || judgement == Judgement::LikelyFail);
  return row;
}

bool has_truth(const Result& result) {
  for (const ResultGarment& garment : result.garments) {
    for (const ResultMeasurement& m : garment.measurements) {
      if (m.error_cm()) return true;
    }
  }
  return false;
}

std::vector<Gaps> garments_of(const Result& result, bool with_truth) {
  std::vector<Gaps> out;
  for (const ResultGarment& garment : result.garments) {
    std::vector<Gaps> rows;
    for (const ResultMeasurement& m : garment.measurements) rows.push_back(size_row(m));
    Gaps& one = out.emplace_back();
    one.set("name", garment.title);
    one.set("layered", result.garments.size() > 1);
    one.set("columns", std::string(with_truth ? "4" : "3"));
    one.set("sizes", std::move(rows));
  }
  return out;
}

Gaps card(const ReviewItem& item, std::size_t number) {
  Gaps out;
  show_verdict(item.result, out);
  const bool with_truth = has_truth(item.result);
  out.set("wearing", garments_of(item.result, with_truth));
  out.set("with_truth", with_truth);
  out.set("number", std::to_string(number));
  out.set("name", item.name);
  out.set("digest", item.digest);
  out.set("scan_digest", item.result.scan.sha256);
  out.set_maybe("link", item.link);
  const std::vector<Check> checks = checks_of(item.result);
  const auto good = std::count_if(checks.begin(), checks.end(),
                                  [](const Check& c) { return c.level == CheckLevel::Good; });
  out.set_maybe("good_count", good > 0 ? std::to_string(good) : "");
  out.set("one_good", good == 1);
  const std::size_t remarks = item.result.warnings.size();
  out.set_maybe("remark_count", remarks == 0   ? ""
                                : remarks == 1 ? "1 remark"
                                               : std::to_string(remarks) + " remarks");
  out.set("has_picture", !item.picture.webp.empty());
  out.set("source", "data:image/webp;base64," + base64(item.picture.webp));
  out.set("width", std::to_string(item.picture.width));
  out.set("height", std::to_string(item.picture.height));
  return out;
}

}  // namespace

std::string review_page(const std::vector<ReviewItem>& items) {
  const std::string style = embedded_text("report.css") + embedded_text("review.css");
  const std::string script = embedded_text("review_verdicts.js") + embedded_text("review.js");
  std::vector<Gaps> cards;
  for (std::size_t i = 0; i < items.size(); ++i) cards.push_back(card(items[i], i + 1));
  Gaps page;
  page.set("title", items.size() == 1 ? std::string("1 result to review")
                                      : count_text(items.size()) + " results to review");
  page.set("page_digest", page_digest(items));
  page.set("cards", std::move(cards));
  page.set("version", items.empty() ? std::string() : items.front().result.version);
  page.set("style", style);
  page.set("script", script);
  page.set("policy", content_policy(style, script));
  return fill_template(embedded_text("review.html"), page);
}

}  // namespace regarment
