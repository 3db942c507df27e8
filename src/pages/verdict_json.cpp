#include "pages/verdict_json.h"

#include <nlohmann/json.hpp>

#include "report/page_parts.h"

namespace regarment {
namespace {

using Json = nlohmann::ordered_json;

const std::string& text(const Gaps& gaps, const char* name) {
  return std::get<std::string>(gaps.values.at(name));
}

const std::vector<Gaps>& list(const Gaps& gaps, const char* name) {
  return std::get<std::vector<Gaps>>(gaps.values.at(name));
}

}  // namespace

std::string verdict_json(const Result& result) {
  // What the report's page says first, so that both say the same.
  Gaps verdict;
  show_verdict(result, verdict);
  Json checks = Json::array(), warnings = Json::array();
  for (const Gaps& check : list(verdict, "checks")) {
    Json& out = checks.emplace_back();
    for (const char* name : {"level", "name", "found", "threshold", "advice"})
      out[name] = text(check, name);
  }
  for (const Gaps& warning : list(verdict, "warnings")) warnings.push_back(text(warning, "text"));
  Json out;
  for (const char* name : {"level", "title", "headline", "against_truth"})
    out[name] = text(verdict, name);
  out["checks"] = std::move(checks);
  out["warnings"] = std::move(warnings);
  return out.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace regarment
