#include "placement/placement_file.h"

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "base/error.h"
#include "base/one_line.h"

namespace regarment {
namespace {

constexpr std::uintmax_t kLargest = 1 << 20;  // bytes
constexpr double kTallest = 3.0;              // m
constexpr const char* kLandmarks[] = {"crotch", "left_armpit", "right_armpit", "shoulder", "neck"};

[[noreturn]] void refuse(const std::filesystem::path& file, const std::string& what) {
  throw ReadError(one_line(file.filename().string()) + ": " + what);
}

std::map<std::string, double> heights(const std::filesystem::path& file, const nlohmann::json& all,
                                      const char* field, bool landmarks) {
  std::map<std::string, double> out;
  if (!all.contains(field)) return out;
  if (!all[field].is_object())
    refuse(file, std::string(field) + " must be an object of names and heights in cm");
  for (const auto& [name, value] : all[field].items()) {
    const std::string where = std::string(field) + "." + one_line(name);
    if (!value.is_number())
      refuse(file, where + " must be a number, the height above the floor in cm");
    const double metres = value.get<double>() / 100;
    if (!(metres > 0 && metres < kTallest)) refuse(file, where + " must lie between 0 and 300 cm");
    const bool known = std::any_of(std::begin(kLandmarks), std::end(kLandmarks),
                                   [&name = name](const char* l) { return name == l; });
    if (landmarks && !known)
      refuse(
          file,
          where + " is no landmark; known are crotch, left_armpit, right_armpit, shoulder, neck");
    out[name] = metres;
  }
  return out;
}

}  // namespace

PlacementOverrides read_placement(const std::filesystem::path& file) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error))
    refuse(file, "is not a file; give a placement file (JSON)");
  if (std::filesystem::file_size(file, error) > kLargest || error)
    refuse(file, "is too large for a placement file");
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  if (!in) refuse(file, "cannot be read; check its permissions");
  const auto limited = [](int depth, nlohmann::json::parse_event_t, nlohmann::json&) {
    return depth < 8;
  };
  const nlohmann::json all = nlohmann::json::parse(text.str(), limited, false);
  if (all.is_discarded() || !all.is_object())
    refuse(file, "is not a JSON object; see README, \"Placement by hand\"");
  if (!all.contains("format") || all["format"] != "regarment.placement/1")
    refuse(file, "format must be \"regarment.placement/1\"");
  for (const auto& [name, value] : all.items())
    if (name != "format" && name != "landmarks_cm" && name != "edges_cm")
      refuse(file,
             "unknown field " + one_line(name) + "; known are format, landmarks_cm, edges_cm");
  return {heights(file, all, "landmarks_cm", true), heights(file, all, "edges_cm", false)};
}

void apply_landmarks(const PlacementOverrides& overrides, Body& body) {
  const auto put = [&](const char* name, double& value) {
    const auto it = overrides.landmarks.find(name);
    if (it != overrides.landmarks.end()) value = it->second;
  };
  put("crotch", body.fork);
  put("left_armpit", body.armpit[0]);
  put("right_armpit", body.armpit[1]);
  put("shoulder", body.shoulder);
  put("neck", body.neck);
}

}  // namespace regarment
