#include "garment/drawn_line.h"

#include <algorithm>

#include "garment/plane.h"
#include "garment/template_data.h"

namespace regarment {
namespace {

constexpr int kProbes = 32;       // points of a line that are looked for on a panel
constexpr double kOnPanel = 0.9;  // share of them that must be found
constexpr double kSlack = 1e-6;   // m^2, of twice an area: a line may run along a panel's edge

bool holds(const Pattern& pattern, const Triangle& t, const Vec2& p) {
  const Vec2 &a = pattern.flat[t[0]], &b = pattern.flat[t[1]], &c = pattern.flat[t[2]];
  const double sign = twice_area(a, b, c) > 0 ? 1 : -1;
  return sign * twice_area(a, b, p) > -kSlack && sign * twice_area(b, c, p) > -kSlack &&
         sign * twice_area(c, a, p) > -kSlack;
}

bool lies_on_panel(const Pattern& pattern, const DrawnLine& line) {
  int found = 0;
  for (int k = 0; k < kProbes; ++k) {
    const Vec2 p = line.from + (k + 0.5) / kProbes * (line.to - line.from);
    found += std::any_of(pattern.triangles.begin(), pattern.triangles.end(),
                         [&](const Triangle& t) {
                           return pattern.panel[t[0]] == line.panel && holds(pattern, t, p);
                         })
                 ? 1
                 : 0;
  }
  return found >= kOnPanel * kProbes;
}

}  // namespace

std::vector<DrawnLine> drawn_lines(const GarmentTemplate& garment, const Dimensions& dimensions,
                                   const Pattern& pattern, const std::string& name) {
  const std::vector<MeasureArrow>& arrows = garment.data().arrows;
  const auto arrow = std::find_if(arrows.begin(), arrows.end(),
                                  [&](const MeasureArrow& a) { return a.dimension == name; });
  std::vector<DrawnLine> out;
  if (arrow == arrows.end()) return out;
  const NameScope scope(garment.data(), dimensions);
  const Vec2 mirror(-1, 1);
  for (std::size_t panel = 0; panel < pattern.panel_names.size(); ++panel) {
    const DrawnLine line{static_cast<int>(panel), scope.metres(arrow->from),
                         scope.metres(arrow->to)};
    const DrawnLine mirrored{line.panel, line.from.cwiseProduct(mirror),
                             line.to.cwiseProduct(mirror)};
    for (const DrawnLine& one : {line, mirrored}) {
      if (lies_on_panel(pattern, one)) out.push_back(one);
    }
  }
  return out;
}

}  // namespace regarment
