#include "report/json_schema.h"

#include <map>
#include <mutex>
#include <nlohmann/json.hpp>
#include <set>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validation_results.hpp>
#include <valijson/validator.hpp>

#include "base/error.h"
#include "base/one_line.h"
#include "report/embedded.h"

namespace regarment {
namespace {

using Json = nlohmann::json;
using Adapter = valijson::adapters::NlohmannJsonAdapter;

constexpr int kDeepest = 64;

Json parse_strictly(const std::string& text, const std::string& name) {
  std::vector<std::set<std::string>> keys;
  const auto check = [&](int depth, Json::parse_event_t event, Json& parsed) {
    if (depth > kDeepest) throw ReadError(name + ": nests deeper than 64 levels");
    if (event == Json::parse_event_t::object_start) keys.emplace_back();
    if (event == Json::parse_event_t::object_end) keys.pop_back();
    if (event == Json::parse_event_t::key && !keys.back().insert(parsed).second) {
      throw ReadError(name + ": has the key '" + one_line(parsed.get<std::string>(), 80) +
                      "' twice in one object");
    }
    return true;
  };
  try {
    return Json::parse(text, check);
  } catch (const Json::exception& error) {
    throw ReadError(name + ": is not JSON: " + one_line(error.what(), 160));
  }
}

// Each is made once; they live as long as the program.
const valijson::Schema& schema_named(const std::string& name) {
  static std::mutex guard;
  static std::map<std::string, valijson::Schema> known;
  const std::lock_guard lock(guard);
  const auto [entry, made] = known.try_emplace(name);
  if (made) {
    const Json json = Json::parse(embedded_text(name));
    valijson::SchemaParser().populateSchema(Adapter(json), entry->second);
  }
  return entry->second;
}

std::string place_of(const valijson::ValidationResults::Error& error) {
  std::string place;
  for (const std::string& step : error.context) {
    if (step == "<root>") continue;
    // "[name]" and "[3]" are how valijson writes a step.
    place +=
        "/" + (step.size() > 2 && step.front() == '[' ? step.substr(1, step.size() - 2) : step);
  }
  return place.empty() ? "/" : place;
}

}  // namespace

void check_by_schema(const std::string& text, const std::string& schema, const std::string& name,
                     const std::string& advice) {
  const Json json = parse_strictly(text, name);
  valijson::Validator validator;
  valijson::ValidationResults results;
  if (validator.validate(schema_named(schema), Adapter(json), &results)) return;
  // valijson tells the innermost failure first.
  valijson::ValidationResults::Error error;
  results.popError(error);
  throw ReadError(name + ": at " + one_line(place_of(error), 120) + ": " +
                  one_line(error.description, 160) + "; " + advice);
}

void check_by_result_schema(const std::string& text, const std::string& name) {
  check_by_schema(text, "result.schema.json", name, "make the result again with 'regarment fit'");
}

}  // namespace regarment
