#include "jobs/job_options.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/one_line.h"

namespace regarment {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kMostBytes = 64U << 10U;
constexpr std::size_t kLongestText = 1000;

enum class Value { Text, Number, Lengths, Switch };

struct Option {
  const char* name;
  Value value;
};

// Sorted.
constexpr Option kOptions[] = {
    {"as-printed", Value::Switch},
    {"attraction", Value::Text},
    {"collisions", Value::Switch},
    {"drape-from", Value::Text},
    {"evaluations", Value::Number},
    {"fabric", Value::Text},
    {"fix", Value::Lengths},
    {"forget", Value::Switch},
    {"free-edges", Value::Switch},
    {"front", Value::Text},
    {"hint", Value::Lengths},
    {"layer-attenuation", Value::Number},
    {"method", Value::Text},
    {"no-border-rejection", Value::Switch},
    {"no-cap-detection", Value::Switch},
    {"no-hesitation", Value::Switch},
    {"no-rough-search", Value::Switch},
    {"no-square-root", Value::Switch},
    {"no-timing", Value::Switch},
    {"normal-angle", Value::Number},
    {"pixel-ratio", Value::Number},
    {"runs", Value::Number},
    {"seed", Value::Number},
    {"segment-distance", Value::Number},
    {"units", Value::Text},
    {"up", Value::Text},
};

[[noreturn]] void refuse(const std::string& name, const std::string& wanted) {
  throw UsageError("options: '" + one_line(name, 60) + "' " + wanted);
}

Json parsed(std::string_view text) {
  if (text.size() > kMostBytes) throw UsageError("options: more than 64 KiB; give fewer");
  const auto too_deep = [](int depth, Json::parse_event_t, Json&) {
    if (depth > 3) throw UsageError("options: nested too deep; give an object of plain values");
    return true;
  };
  try {
    Json json = Json::parse(text, too_deep);
    if (json.is_object()) return json;
  } catch (const nlohmann::json::exception&) {
    throw UsageError("options: no JSON; give an object such as {\"method\": \"joint\"}");
  }
  throw UsageError("options: no JSON object; give one such as {\"method\": \"joint\"}");
}

std::string text_of(const std::string& name, const Json& value) {
  if (!value.is_string()) refuse(name, "wants a text");
  auto text = value.get<std::string>();
  if (text.empty() || text.size() > kLongestText || text.find('\0') != std::string::npos) {
    refuse(name, "wants a text of 1 to 1000 characters");
  }
  return text;
}

// "length=54,hip=95.5": numbers as JSON writes them, which reads back exactly.
std::string lengths_of(const std::string& name, const Json& value) {
  if (value.is_string()) return text_of(name, value);
  if (!value.is_object() || value.empty()) {
    refuse(name, "wants an object such as {\"length\": 54}, in cm");
  }
  std::string text;
  for (const auto& [what, cm] : value.items()) {
    if (!cm.is_number()) refuse(name, "wants numbers of cm, such as {\"length\": 54}");
    text += (text.empty() ? "" : ",") + what + "=" + cm.dump();
  }
  return text;
}

void add_words(const Option& option, const Json& value, std::vector<std::string>& words) {
  const std::string name = option.name, dashed = "--" + name;
  switch (option.value) {
    case Value::Switch:
      if (!value.is_boolean()) refuse(name, "wants true or false");
      if (value.get<bool>()) words.push_back(dashed);
      return;
    case Value::Number:
      if (!value.is_number()) refuse(name, "wants a number");
      words.push_back(dashed + "=" + value.dump());
      return;
    case Value::Text:
      words.push_back(dashed + "=" + text_of(name, value));
      return;
    case Value::Lengths:
      words.push_back(dashed + "=" + lengths_of(name, value));
      return;
  }
}

}  // namespace

std::vector<std::string> option_words(std::string_view text) {
  std::vector<std::string> words, seen;
  const Json options = parsed(text);
  for (const auto& [given, value] : options.items()) {
    std::string name = given;
    std::replace(name.begin(), name.end(), '_', '-');
    const auto* option = std::find_if(std::begin(kOptions), std::end(kOptions),
                                      [&](const Option& one) { return one.name == name; });
    if (option == std::end(kOptions)) {
      std::string all;
      for (const Option& one : kOptions) all.append(all.empty() ? "" : ", ").append(one.name);
      refuse(given, "is unknown or not for a service; use " + all);
    }
    if (std::find(seen.begin(), seen.end(), name) != seen.end()) refuse(given, "is given twice");
    seen.push_back(name);
    add_words(*option, value, words);
  }
  return words;
}

std::vector<std::string> job_option_names() {
  std::vector<std::string> names;
  for (const Option& one : kOptions) names.emplace_back(one.name);
  return names;
}

}  // namespace regarment
