#include "garment/garment_template.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iomanip>
#include <sstream>

#include "base/error.h"
#include "base/one_line.h"
#include "garment/template_check.h"
#include "garment/template_data.h"
#include "garment/template_reader.h"

namespace regarment {

namespace {

constexpr double kBoundTolerance = 1e-9;          // m, so that a bound given in cm is inside
constexpr std::uintmax_t kMaxFileBytes = 262144;  // 256 KiB
constexpr int kHalvings = 10;                     // 1/1024 of the way

bool within(const Dimension& dimension, double value) {
  return value >= dimension.lower - kBoundTolerance && value <= dimension.upper + kBoundTolerance;
}

std::string bounds_text(const Dimension& dimension) {
  std::ostringstream text;
  text << std::fixed << std::setprecision(1) << 100.0 * dimension.lower << " to "
       << 100.0 * dimension.upper << " cm";
  return text.str();
}

}  // namespace

GarmentTemplate GarmentTemplate::load(const std::filesystem::path& file) {
  const std::string name = one_line(file.string());
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error))
    throw ReadError(name + ": no such template file");
  if (std::filesystem::file_size(file, error) > kMaxFileBytes)
    throw ReadError(name + ": larger than 256 KiB, too large for a garment template");
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream text;
  if (!stream || !(text << stream.rdbuf())) throw ReadError(name + ": cannot be read");
  return parse(text.str(), one_line(file.filename().string()));
}

GarmentTemplate GarmentTemplate::parse(const std::string& json,
                                       const std::string& name_for_messages) {
  TemplateData data = read_template(json, name_for_messages);
  check_geometry(data);
  return GarmentTemplate(std::make_shared<const TemplateData>(std::move(data)));
}

const std::string& GarmentTemplate::name() const { return data_->name; }
const std::string& GarmentTemplate::title() const { return data_->title; }
const std::string& GarmentTemplate::description() const { return data_->description; }
const std::vector<std::string>& GarmentTemplate::sources() const { return data_->sources; }
const std::vector<Dimension>& GarmentTemplate::dimensions() const { return data_->dimensions; }
const std::vector<Observation>& GarmentTemplate::observations() const {
  return data_->observations;
}

const Dimension& GarmentTemplate::dimension(const std::string& name) const {
  for (const Dimension& dimension : data_->dimensions)
    if (dimension.name == name) return dimension;
  throw InvalidInput(data_->name + " has no dimension '" + name + "'");
}

double GarmentTemplate::evaluate(const std::string& formula, const Dimensions& dimensions) const {
  return NameScope(*data_, dimensions).value(Formula::parse(formula)) / data_->units_in_meter;
}

bool GarmentTemplate::gives(const std::string& formula, const std::string& name,
                            const Dimensions& dimensions) const {
  constexpr double kNudge = 1e-4;  // m
  Dimensions more = dimensions;
  more[name] += kNudge;
  return evaluate(formula, more) - evaluate(formula, dimensions) > 0.5 * kNudge;
}

Dimensions GarmentTemplate::typical() const {
  Dimensions dimensions;
  for (const Dimension& dimension : data_->dimensions)
    dimensions[dimension.name] = dimension.typical;
  return dimensions;
}

void GarmentTemplate::check(const Dimensions& dimensions) const {
  for (const auto& [name, value] : dimensions) {
    const bool known = std::any_of(data_->dimensions.begin(), data_->dimensions.end(),
                                   [&n = name](const Dimension& d) { return d.name == n; });
    if (!known) throw UsageError(data_->name + " has no dimension '" + one_line(name, 60) + "'");
  }
  for (const Dimension& dimension : data_->dimensions) {
    const auto given = dimensions.find(dimension.name);
    if (given == dimensions.end())
      throw UsageError(data_->name + ": no value for '" + dimension.name + "'");
    if (!within(dimension, given->second))
      throw UsageError(data_->name + ": " + dimension_text(dimension, given->second) +
                       " is out of bounds, " + bounds_text(dimension));
  }
  if (const auto reason = why_impossible(*data_, dimensions))
    throw UsageError(data_->name + ": these dimensions make no garment: " + *reason);
}

Dimensions GarmentTemplate::nearest_possible(const Dimensions& dimensions) const {
  const Dimensions safe = typical();
  Dimensions wanted = safe;
  for (const Dimension& dimension : data_->dimensions) {
    const auto given = dimensions.find(dimension.name);
    if (given != dimensions.end() && std::isfinite(given->second))
      wanted[dimension.name] = std::clamp(given->second, dimension.lower, dimension.upper);
  }
  if (!why_impossible(*data_, wanted)) return wanted;
  const auto between = [&](double share) {
    Dimensions mixed = wanted;
    for (auto& [name, value] : mixed) value += share * (safe.at(name) - value);
    return mixed;
  };
  double impossible = 0.0, possible = 1.0;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = (impossible + possible) / 2.0;
    (why_impossible(*data_, between(middle)) ? impossible : possible) = middle;
  }
  return possible == 1.0 ? safe : between(possible);
}

}  // namespace regarment
