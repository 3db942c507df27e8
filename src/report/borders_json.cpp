#include "report/borders_json.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "report/text.h"

namespace regarment {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kUseful = 1e-5;  // m, finer digits would be noise

int decimals_of(const Scan& scan) {
  const double file_units = scan.file_from_body.linear().col(0).norm();  // in a metre
  return std::clamp(static_cast<int>(std::ceil(-std::log10(kUseful * file_units))), 0, 9);
}

Json line_json(const BorderLine& line, const Scan& scan) {
  const int digits = decimals_of(scan);
  Json points = Json::array();
  for (const Vec3& p : line.points) {
    const Vec3 q = scan.file_from_body * p;
    points.push_back({rounded(q.x(), digits), rounded(q.y(), digits), rounded(q.z(), digits)});
  }
  return {{"edge", line.edge}, {"shown", rounded(line.shown, 3)}, {"points", std::move(points)}};
}

}  // namespace

std::string borders_json(const Analysis& analysis) {
  Json garments = Json::array();
  for (const GarmentAnalysis& garment : analysis.garments) {
    Json lines = Json::array();
    for (const BorderLine& line : garment.borders) {
      lines.push_back(line_json(line, analysis.scan));
    }
    garments.push_back({{"template", garment.template_name},
                        {"layer", garment.layer},
                        {"lines", std::move(lines)}});
  }
  return Json{{"schema", "regarment.borders/1"}, {"garments", std::move(garments)}}.dump() + "\n";
}

}  // namespace regarment
