#include "exports/pattern_dxf.h"

#include <cctype>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "exports/dxf_writer.h"
#include "garment/cut_piece.h"

namespace regarment {
namespace {

constexpr double kMm = 1000.0;       // per metre
constexpr double kGap = 60.0;        // mm between pieces
constexpr double kTextHeight = 6.0;  // mm
constexpr double kNotchDepth = 5.0;  // mm
constexpr const char* kOutline = "1";
constexpr const char* kTurnPoints = "2";
constexpr const char* kCurvePoints = "3";
constexpr const char* kNotches = "4";
constexpr const char* kGrain = "7";
constexpr const char* kInternal = "8";
constexpr const char* kSeams = "14";
constexpr const char* kRemarks = "15";

Vec2 in_mm(const Vec2& p) { return {kMm * p.x(), -kMm * p.y()}; }

std::vector<Vec2> in_mm(const std::vector<Vec2>& points) {
  std::vector<Vec2> out;
  out.reserve(points.size());
  for (const Vec2& p : points) out.push_back(in_mm(p));
  return out;
}

std::string upper(std::string text) {
  for (char& c : text) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return text;
}

std::string block_name(const GarmentTemplate& garment, const CutPiece& piece) {
  return upper(garment.name() + "-" + piece.name);
}

void write_outline(const CutPiece& piece, DxfWriter& dxf) {
  dxf.polyline(kOutline, in_mm(cut_outline(piece)), true);
  for (const CutEdge& edge : piece.edges) {
    dxf.point(kTurnPoints, in_mm(edge.points.front()));
    for (std::size_t i = 1; i + 1 < edge.points.size(); ++i)
      dxf.point(kCurvePoints, in_mm(edge.points[i]));
  }
  for (const CutEdge& edge : piece.edges)
    if (edge.is_sewn) dxf.polyline(kSeams, in_mm(edge.points), false);
}

void write_notches(const CutPiece& piece, DxfWriter& dxf) {
  for (const Notch& notch : piece.notches) {
    const double angle = std::atan2(-notch.inward.y(), notch.inward.x());
    dxf.notch(kNotches, in_mm(notch.at), angle * 180.0 / std::numbers::pi, kNotchDepth);
  }
}

/// Beside the grain line, one under the other, as the standard's readers look for it.
void write_text(const GarmentTemplate& garment, const CutPiece& piece, DxfWriter& dxf) {
  Vec2 at = in_mm(piece.grain[0]) + Vec2(kTextHeight, 0.0);
  const auto line = [&](const char* layer, const std::string& text) {
    at.y() -= 1.6 * kTextHeight;
    dxf.text(layer, at, kTextHeight, text);
  };
  line(kOutline, "PIECE NAME: " + block_name(garment, piece));
  line(kOutline, "SIZE: AS SCANNED");
  line(kOutline, "QUANTITY: 1");
  line(kOutline, "CATEGORY: " + upper(garment.name()));
  line(kRemarks, "NO SEAM ALLOWANCE: THE OUTLINE IS THE SEWING LINE");
}

void write_block(const GarmentTemplate& garment, const CutPiece& piece, DxfWriter& dxf) {
  dxf.begin_block(block_name(garment, piece));
  write_outline(piece, dxf);
  write_notches(piece, dxf);
  dxf.line(kGrain, in_mm(piece.grain[0]), in_mm(piece.grain[1]));
  for (const CutLine& line : piece.lines) dxf.line(kInternal, in_mm(line.from), in_mm(line.to));
  write_text(garment, piece, dxf);
  dxf.end_block();
}

/// The style text, above the pieces; returns the height it takes.
double write_style(const GarmentTemplate& garment, const Dimensions& dimensions, DxfWriter& dxf) {
  double y = kGap;
  const auto line = [&](const std::string& text) {
    dxf.text(kOutline, Vec2(0.0, y), kTextHeight, text);
    y += 1.6 * kTextHeight;
  };
  for (auto d = garment.dimensions().rbegin(); d != garment.dimensions().rend(); ++d) {
    char length[32];
    std::snprintf(length, sizeof length, " %.1f CM", 100.0 * dimensions.at(d->name));
    line(d->code + " " + upper(d->title) + length);
  }
  line("UNITS: METRIC");
  line("SAMPLE SIZE: AS SCANNED");
  line("AUTHOR: REGARMENT");
  line("STYLE NAME: " + upper(garment.name()));
  return y;
}

}  // namespace

std::string pattern_dxf(const GarmentTemplate& garment, const Dimensions& dimensions) {
  const std::vector<CutPiece> pieces = cut_pieces(garment, dimensions);
  DxfWriter dxf(
      {"0", kOutline, kTurnPoints, kCurvePoints, kNotches, kGrain, kInternal, kSeams, kRemarks});
  double x = 0.0, lowest = 0.0;
  for (const CutPiece& piece : pieces) {
    write_block(garment, piece, dxf);
    Vec2 low = Vec2::Constant(1e9), high = Vec2::Constant(-1e9);
    for (const Vec2& p : in_mm(cut_outline(piece))) {
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
    dxf.insert(block_name(garment, piece), Vec2(x - low.x(), -high.y()));
    x += high.x() - low.x() + kGap;
    lowest = std::min(lowest, low.y() - high.y());
  }
  const double top = write_style(garment, dimensions, dxf);
  return dxf.bytes(Vec2(0.0, lowest), Vec2(x - kGap, top));
}

}  // namespace regarment
