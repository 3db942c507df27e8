#include "exports/pattern_val.h"

#include <cstdio>

#include "exports/val_drawing.h"
#include "garment/svg_text.h"

namespace regarment {
namespace {

constexpr double kCm = 100.0;  // per metre
constexpr double kGap = 6.0;   // cm between pieces

/// 0, 1, ... 25, 26: A, B, ... Z, AA.
std::string letters(std::size_t i) {
  const std::string last(1, static_cast<char>('A' + i % 26));
  return i < 26 ? last : letters(i / 26 - 1) + last;
}

std::string increments(const GarmentTemplate& garment, const Dimensions& dimensions) {
  std::string xml = "  <increments>\n";
  for (const Dimension& d : garment.dimensions()) {
    char length[64];
    std::snprintf(length, sizeof length, "%.4f", kCm * dimensions.at(d.name));
    xml += "    <increment name=\"#" + d.name + "\" formula=\"" + length + "\" description=\"" +
           xml_escaped(d.code + " " + d.title + ": " + d.definition) + "\"/>\n";
  }
  return xml + "  </increments>\n";
}

double width_of(const CutPiece& piece) {
  double low = 1e9, high = -1e9;
  for (const Vec2& p : cut_outline(piece)) {
    low = std::min(low, p.x());
    high = std::max(high, p.x());
  }
  return high - low;
}

}  // namespace

std::string pattern_val(const GarmentTemplate& garment, const Dimensions& dimensions) {
  const std::vector<CutPiece> pieces = cut_pieces(garment, dimensions);
  std::string drawings;
  Vec2 corner(0.0, 0.0);
  int next_id = 1;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    drawings += val_drawing(pieces[i], letters(i), corner, next_id);
    corner.x() += kCm * width_of(pieces[i]) + kGap;
  }
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<pattern>\n"
         "  <version>0.8.8</version>\n  <unit>cm</unit>\n  <description>" +
         xml_escaped(garment.title() + ", flat pattern. No seam allowance.") +
         "</description>\n  <notes/>\n  <patternLabel/>\n  <measurements/>\n" +
         increments(garment, dimensions) + "  <previewCalculations/>\n" + drawings + "</pattern>\n";
}

}  // namespace regarment
