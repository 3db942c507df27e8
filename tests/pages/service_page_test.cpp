#include "pages/service_page.h"

#include <gtest/gtest.h>

#include <regex>

#include "html_outline.h"

namespace regarment {
namespace {

const std::vector<std::vector<std::string>> kPages = {
    {}, {"review"}, {"evaluate"}, {"jobs", "0123"}, {"jobs", "0123", "correct"}};

ServicePage page_at(const std::vector<std::string>& path) {
  const std::optional<ServicePage> page = service_page(path);
  if (!page) throw std::runtime_error("no page");
  return *page;
}

std::set<std::string> all_matches(const std::string& text, const std::regex& what) {
  std::set<std::string> out;
  for (std::sregex_iterator at(text.begin(), text.end(), what), end; at != end; ++at)
    out.insert((*at)[1]);
  return out;
}

// Every script a page leads to: its own, and what these import or load by name.
std::set<std::string> scripts_of(const std::string& page) {
  std::set<std::string> out, open = all_matches(page, std::regex("src=\"/pages/([^\"]+)\""));
  while (!open.empty()) {
    const std::string name = *open.begin();
    open.erase(open.begin());
    if (!out.insert(name).second) continue;
    const std::string text = page_at({"pages", name}).text;
    open.merge(all_matches(text, std::regex("from '\\./([a-z0-9_]+\\.js)'")));
    open.merge(all_matches(text, std::regex("'([a-z0-9_]+\\.js)'")));
  }
  return out;
}

TEST(ServicePage, EachIsWellFormedAndHasOneHeading) {
  for (const auto& path : kPages) {
    const ServicePage page = page_at(path);
    EXPECT_EQ(page.content_type, "text/html; charset=utf-8");
    const HtmlOutline outline = HtmlReader(page.text).read();
    EXPECT_EQ(outline.mistake, "");
    for (const std::string& place : outline.references)
      EXPECT_TRUE(outline.ids.count(place)) << place;
    EXPECT_EQ(page.text.find("<h1"), page.text.rfind("<h1"));
    EXPECT_EQ(page.text.find("{{"), std::string::npos);
  }
}

TEST(ServicePage, HoldsNothingThatItsPolicyForbids) {
  for (const auto& path : kPages) {
    const ServicePage page = page_at(path);
    EXPECT_EQ(page.policy.find("unsafe"), std::string::npos);
    EXPECT_NE(page.policy.find("default-src 'none'"), std::string::npos);
    EXPECT_NE(page.policy.find("script-src 'self';"), std::string::npos);
    EXPECT_NE(page.policy.find("frame-ancestors 'none'"), std::string::npos);
    EXPECT_FALSE(
        std::regex_search(page.text, std::regex("<style|style=|\\son[a-z]+=|javascript:")));
    EXPECT_FALSE(std::regex_search(page.text, std::regex("<script(?![^>]*\\bsrc=)")));
  }
}

TEST(ServicePage, AsksNobodyElse) {
  // Names of XML's own vocabularies are no requests.
  const std::regex address("https?://(?!www\\.w3\\.org/)|[\"'(]//|@import|url\\(");
  for (const auto& path : kPages) {
    const std::string text = page_at(path).text;
    EXPECT_FALSE(std::regex_search(text, address));
    EXPECT_FALSE(std::regex_search(page_at({"pages", "style.css"}).text, address));
    for (const std::string& name : scripts_of(text))
      EXPECT_FALSE(std::regex_search(page_at({"pages", name}).text, address)) << name;
  }
}

TEST(ServicePage, HasEveryScriptThatPagesName) {
  std::set<std::string> all;
  for (const auto& path : kPages) all.merge(scripts_of(page_at(path).text));
  for (const char* name : {"home.js", "job.js", "correct.js", "evaluate.js", "review_queue.js",
                           "review.js", "review_verdicts.js", "posted_verdicts.js", "dom.js"})
    EXPECT_TRUE(all.count(name)) << name;
  for (const std::string& name : all)
    EXPECT_EQ(page_at({"pages", name}).content_type, "text/javascript; charset=utf-8");
}

// Scripts that read markup could be made to run what a scan's name holds.
TEST(ServicePage, BuildsNoMarkupFromText) {
  const std::regex markup(
      "innerHTML|outerHTML|insertAdjacentHTML|document\\.write|\\beval\\(|new Function");
  for (const auto& path : kPages)
    for (const std::string& name : scripts_of(page_at(path).text))
      EXPECT_FALSE(std::regex_search(page_at({"pages", name}).text, markup)) << name;
}

TEST(ServicePage, EveryElementAScriptAsksForIsOnItsPage) {
  for (const auto& path : kPages) {
    const std::string page = page_at(path).text;
    const std::set<std::string> ids = HtmlReader(page).read().ids;
    for (const std::string& name : scripts_of(page))
      for (const std::string& id :
           all_matches(page_at({"pages", name}).text, std::regex("byId\\('([^']+)'\\)")))
        EXPECT_TRUE(ids.count(id)) << name << " asks for " << id;
  }
}

TEST(ServicePage, OfAnotherPathIsNone) {
  const std::vector<std::vector<std::string>> paths = {{"nothing"},
                                                       {"jobs"},
                                                       {"jobs", "1", "other"},
                                                       {"pages"},
                                                       {"pages", "page.html"},
                                                       {"pages", ".js"},
                                                       {"pages", "../review.js"},
                                                       {"pages", "report.css"},
                                                       {"pages", "garment-trousers.svg"},
                                                       {"pages", "garment-.svg"},
                                                       {"pages", "view3d.js"},
                                                       {"review", "x"}};
  for (const auto& path : paths) EXPECT_FALSE(service_page(path)) << path.back();
}

TEST(ServicePage, IsTheSameEachTime) {
  for (const auto& path : kPages) EXPECT_EQ(page_at(path).text, page_at(path).text);
  EXPECT_EQ(service_page({""})->text, service_page({})->text);
}

}  // namespace
}  // namespace regarment
