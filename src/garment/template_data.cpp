#include "garment/template_data.h"

#include "base/error.h"

namespace regarment {

NameScope::NameScope(const TemplateData& data, const Dimensions& dimensions) : data_(data) {
  for (const Dimension& dimension : data.dimensions) {
    const auto found = dimensions.find(dimension.name);
    if (found == dimensions.end())
      throw InvalidInput(data.name + ": no value for the dimension '" + dimension.name + "'");
    known_.emplace(dimension.name, found->second * data.units_in_meter);
  }
  for (const auto& [name, value] : data.constants) known_.emplace(name, value);
}

double NameScope::operator()(std::string_view name) const {
  if (const auto found = known_.find(name); found != known_.end()) return found->second;
  for (const Derived& derived : data_.derived) {
    if (derived.name != name) continue;
    // No deeper than there are derived names: each uses only those before it.
    const double result = value(derived.formula);
    known_.emplace(derived.name, result);
    return result;
  }
  throw InvalidInput("'" + std::string(name) + "' is not a name of the template " + data_.name);
}

double NameScope::value(const Formula& formula) const {
  return formula.evaluate([this](std::string_view name) { return (*this)(name); });
}

Vec2 NameScope::metres(const std::array<Formula, 2>& point) const {
  return Vec2(value(point[0]), value(point[1])) / data_.units_in_meter;
}

std::string swap_sides(const std::string& name) {
  if (name.starts_with("left_")) return "right_" + name.substr(5);
  if (name.starts_with("right_")) return "left_" + name.substr(6);
  return name;
}

std::string edge_name(const TemplateData& data, const EdgeRef& ref) {
  const PanelData& panel = data.panels[static_cast<std::size_t>(ref.panel)];
  const ShapeData& shape = data.shapes[static_cast<std::size_t>(panel.shape)];
  const std::string& name = shape.edges[static_cast<std::size_t>(ref.edge)].name;
  return panel.mirrored != (ref.half == 1) ? swap_sides(name) : name;
}

bool is_turned(const PanelData& panel, int half) {
  return (panel.mirrored != (half == 1)) != !panel.is_front;
}

bool has_panel_on_left(const TemplateData& data, const EdgeRef& ref) {
  // A front seen from outside has t pointing down, so its outline runs left-handed in (s, t).
  const PanelData& panel = data.panels[static_cast<std::size_t>(ref.panel)];
  const bool left_handed = data.outline_sign[static_cast<std::size_t>(panel.shape)] < 0;
  return left_handed != is_turned(panel, ref.half);
}

}  // namespace regarment
