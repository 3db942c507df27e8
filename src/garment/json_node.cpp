#include "garment/json_node.h"

#include <algorithm>
#include <set>
#include <sstream>

#include "base/error.h"
#include "base/one_line.h"

namespace regarment {

namespace {

constexpr std::size_t kMaxBytes = 262144;  // 256 KiB
constexpr int kMaxDepth = 16;
constexpr std::size_t kMaxEcho = 60;  // longest piece of a file repeated in a message

std::string echo(const std::string& text) { return one_line(text, kMaxEcho); }

}  // namespace

nlohmann::json parse_template_json(const std::string& text, const std::string& file) {
  if (text.size() > kMaxBytes)
    throw ReadError(file + ": larger than 256 KiB, too large for a garment template");
  std::vector<std::set<std::string>> keys(kMaxDepth + 2);
  using Json = nlohmann::json;
  const auto watch = [&](int depth, Json::parse_event_t event, Json& value) {
    if (depth > kMaxDepth) throw ReadError(file + ": nested more than 16 levels deep");
    if (event == Json::parse_event_t::object_start)
      keys[static_cast<std::size_t>(depth) + 1].clear();
    if (event == Json::parse_event_t::key) {
      const std::string key = value.get<std::string>();
      if (!keys[static_cast<std::size_t>(depth)].insert(key).second)
        throw ReadError(file + ": the key '" + echo(key) + "' stands twice in one object");
    }
    return true;
  };
  try {
    return Json::parse(text, watch);
  } catch (const Json::parse_error& error) {
    const std::size_t end = std::min(error.byte > 0 ? error.byte - 1 : 0, text.size());
    const auto line = 1 + std::count(text.begin(), text.begin() + static_cast<long>(end), '\n');
    throw ReadError(file + ": not JSON: syntax error in line " + std::to_string(line));
  } catch (const Json::exception&) {
    throw ReadError(file + ": not JSON: a number or a text in it cannot be represented");
  }
}

void JsonNode::fail(const std::string& what) const {
  throw ReadError(*file_ + ": " + (path_.empty() ? "/" : path_) + ": " + what);
}

void JsonNode::keys(std::initializer_list<const char*> allowed) const {
  if (!value_->is_object()) fail("must be an object");
  for (const auto& [key, unused] : value_->items()) {
    const bool known = key == "note" || std::any_of(allowed.begin(), allowed.end(),
                                                    [&k = key](const char* a) { return k == a; });
    if (!known) fail("unknown key '" + echo(key) + "'");
  }
}

bool JsonNode::has(const char* key) const { return value_->is_object() && value_->contains(key); }

JsonNode JsonNode::at(const std::string& key) const {
  if (!value_->is_object()) fail("must be an object");
  const auto found = value_->find(key);
  if (found == value_->end()) fail("'" + echo(key) + "' is missing");
  return {*found, path_ + "/" + echo(key), *file_};
}

std::vector<JsonNode> JsonNode::items(std::size_t fewest, std::size_t most) const {
  if (!value_->is_array()) fail("must be an array");
  if (value_->size() < fewest || value_->size() > most) {
    fail("must have " + std::to_string(fewest) +
         (most > fewest ? " to " + std::to_string(most) : "") + " entries, has " +
         std::to_string(value_->size()));
  }
  std::vector<JsonNode> nodes;
  for (std::size_t i = 0; i < value_->size(); ++i)
    nodes.emplace_back((*value_)[i], path_ + "/" + std::to_string(i), *file_);
  return nodes;
}

std::vector<std::string> JsonNode::member_names(std::size_t most) const {
  if (!value_->is_object()) fail("must be an object");
  if (value_->size() > most) fail("must have at most " + std::to_string(most) + " members");
  std::vector<std::string> names;
  for (const auto& [key, unused] : value_->items()) names.push_back(key);
  return names;
}

std::string JsonNode::text(std::size_t most) const {
  if (!value_->is_string()) fail("must be a text in quotes");
  std::string text = value_->get<std::string>();
  if (text.empty()) fail("must not be empty");
  if (text.size() > most) fail("must be shorter than " + std::to_string(most) + " characters");
  for (const char c : text)
    if (static_cast<unsigned char>(c) < 32) fail("must not contain control characters");
  return text;
}

std::string JsonNode::name() const {
  std::string name = text(40);
  const auto is_part = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_';
  };
  if (!(name[0] >= 'a' && name[0] <= 'z') || !std::all_of(name.begin(), name.end(), is_part))
    fail("'" + echo(name) + "' is not a name: lower-case letters, digits and '_', letter first");
  return name;
}

double JsonNode::number(double lowest, double highest) const {
  if (!value_->is_number()) fail("must be a number");
  const double number = value_->get<double>();
  if (!(number >= lowest && number <= highest)) {
    std::ostringstream range;
    range << "must lie between " << lowest << " and " << highest << ", is " << number;
    fail(range.str());
  }
  return number;
}

int JsonNode::integer(int lowest, int highest) const {
  if (!value_->is_number_integer()) fail("must be a whole number");
  return static_cast<int>(number(lowest, highest));
}

bool JsonNode::boolean() const {
  if (!value_->is_boolean()) fail("must be true or false");
  return value_->get<bool>();
}

bool JsonNode::is_number() const { return value_->is_number(); }

}  // namespace regarment
