#include "garment/pattern_svg.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <numbers>
#include <sstream>

#include "base/error.h"
#include "garment/notches.h"
#include "garment/panel_outline.h"
#include "garment/pattern_style.h"
#include "garment/svg_text.h"
#include "garment/template_check.h"

namespace regarment {

namespace {

constexpr double kMm = 1000.0;           // per metre
constexpr double kNotch = 5.0;           // mm
constexpr double kFontShare = 1 / 62.0;  // font size over the larger side of the pieces
constexpr double kSketchFontShare = 1 / 30.0;
const char* const kHalf = "\xC2\xBD";

std::size_t index(int i) { return static_cast<std::size_t>(i); }

struct Box {
  Vec2 low = Vec2::Constant(1e9), high = Vec2::Constant(-1e9);
  void add(const Vec2& p) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  Vec2 size() const { return high - low; }
};

std::string cm_text(double metres) {
  std::ostringstream text;
  text << std::fixed << std::setprecision(1) << 100.0 * metres;
  return text.str();
}

/// A piece and where its panel origin (s, t) = (0, 0) lies on the sheet.
struct PlacedPiece {
  const DrawnPiece* piece = nullptr;
  std::vector<std::vector<OutlineEdge>> outlines;  // per panel of the piece
  Box box;                                         // mm, relative to the panel origin
  Box room;                                        // the same with its arrows and their text
  Vec2 origin = Vec2::Zero();                      // mm on the sheet

  Vec2 on_sheet(const Vec2& flat) const { return origin + kMm * flat; }
};

class Drawing {
 public:
  Drawing(const GarmentTemplate& garment, const Dimensions& dimensions, PatternStyle style)
      : garment_(garment),
        data_(garment.data()),
        dimensions_(dimensions),
        scope_(data_, dimensions),
        is_sketch_(style == PatternStyle::Sketch) {
    lay_out();
  }

  std::string svg(const PatternDrawingOptions& options) {
    std::string body;
    for (const MeasureArrow& arrow : data_.arrows) body += draw_extensions(arrow);
    for (const PlacedPiece& piece : pieces_) body += draw_piece(piece);
    for (const MeasureArrow& arrow : data_.arrows) body += draw_arrow(arrow);
    if (!is_sketch_) body += draw_legend();
    return header(options) + "<style>\n" + pattern_style(options.standalone) + "</style>\n" + body +
           "</svg>\n";
  }

 private:
  void lay_out() {
    double tallest = 0.0, widest = 0.0;
    for (const DrawnPiece& drawn : data_.pieces) {
      PlacedPiece piece;
      piece.piece = &drawn;
      for (const int panel : drawn.panels) {
        piece.outlines.push_back(panel_outline(data_, panel, scope_));
        for (const OutlineEdge& edge : piece.outlines.back())
          for (const Vec2& p : edge.points) piece.box.add(kMm * p);
      }
      tallest = std::max(tallest, piece.box.size().y());
      widest += piece.box.size().x();
      pieces_.push_back(std::move(piece));
    }
    font_ = std::max({widest, tallest, 300.0}) * (is_sketch_ ? kSketchFontShare : kFontShare);
    margin_ = (is_sketch_ ? 0.5 : 3.0) * font_;
    add_arrow_room();
    double x = margin_, above = 0.0;
    for (const PlacedPiece& piece : pieces_) above = std::max(above, -piece.room.low.y());
    for (PlacedPiece& piece : pieces_) {
      piece.origin = Vec2(x - piece.room.low.x(), margin_ + above);
      x += piece.room.size().x() + margin_;
      bottom_ = std::max(bottom_, piece.origin.y() + piece.room.high.y());
    }
    width_ = is_sketch_ ? x : std::max(x, 46.0 * font_);
    centre_pieces(width_ - x);
    height_ = bottom_ + margin_ + (is_sketch_ ? 0.0 : legend_height());
  }

  /// Arrows beside a piece take room with their text, two lines high.
  void add_arrow_room() {
    for (PlacedPiece& piece : pieces_) piece.room = piece.box;
    const Vec2 text = Vec2::Constant(2.0 * font_);
    for (const MeasureArrow& arrow : data_.arrows) {
      for (const Vec2& end : arrow_ends(arrow)) {
        pieces_[index(arrow.piece)].room.add(kMm * end - text);
        pieces_[index(arrow.piece)].room.add(kMm * end + text);
      }
    }
  }

  void centre_pieces(double spare) {
    for (PlacedPiece& piece : pieces_) piece.origin.x() += spare / 2.0;
  }

  double legend_height() const {
    const std::size_t rows = std::max(data_.dimensions.size(), pieces_.size() + 2);
    return font_ * (4.0 + 1.7 * static_cast<double>(rows));
  }

  /// The two ends of the arrow itself, beside the line it measures; flat, m.
  std::array<Vec2, 2> arrow_ends(const MeasureArrow& arrow) const {
    const Vec2 a = scope_.metres(arrow.from), b = scope_.metres(arrow.to);
    const Vec2 along = (b - a).normalized();
    const Vec2 left(along.y(), -along.x());
    const double offset = scope_.value(arrow.offset) / data_.units_in_meter;
    return {a + offset * left, b + offset * left};
  }

  /// 0: the edge is cut. 1 or 2: it is the first or second side of a seam inside the piece.
  int side_of_inner_seam(const PlacedPiece& piece, const EdgeRef& ref) const {
    const auto in_piece = [&](const EdgeRef& other) {
      const auto& panels = piece.piece->panels;
      return std::find(panels.begin(), panels.end(), other.panel) != panels.end();
    };
    for (const auto& seam : data_.seams) {
      if (seam[0] == ref && in_piece(seam[1])) return 1;
      if (seam[1] == ref && in_piece(seam[0])) return 2;
    }
    return 0;
  }

  std::string edge_path(const PlacedPiece& piece, const OutlineEdge& edge, bool begin) const {
    std::string d = begin ? "M" + svg_point(piece.on_sheet(edge.points.front())) : std::string();
    if (edge.controls.empty()) d += " L";
    if (edge.controls.size() == 1) d += " Q";
    if (edge.controls.size() == 2) d += " C";
    for (const Vec2& control : edge.controls) d += svg_point(piece.on_sheet(control)) + " ";
    return d + svg_point(piece.on_sheet(edge.points.back()));
  }

  std::string draw_piece(const PlacedPiece& piece) const {
    std::string cloth, seams, cut;
    for (const auto& outline : piece.outlines) {
      std::string d;
      for (const OutlineEdge& edge : outline) {
        d += edge_path(piece, edge, d.empty());
        const int side = side_of_inner_seam(piece, edge.ref);
        if (side == 0) cut += edge_path(piece, edge, true) + " ";
        if (side == 1) seams += edge_path(piece, edge, true) + " ";
      }
      cloth += svg_path("rp-cloth", d + " Z");
    }
    std::string svg = cloth + svg_path("rp-cut", cut);
    if (!seams.empty()) svg += svg_path("rp-seam", seams);
    for (const int panel : piece.piece->panels) svg += draw_lines(piece, panel);
    return is_sketch_ ? svg : svg + draw_notches(piece) + draw_grain(piece);
  }

  std::string draw_notches(const PlacedPiece& piece) const {
    std::string svg;
    for (std::size_t i = 0; i < piece.outlines.size(); ++i) {
      const int panel = piece.piece->panels[i];
      for (const Notch& notch : panel_notches(data_, panel, piece.outlines[i], scope_)) {
        const Vec2 at = piece.on_sheet(notch.at);
        svg += svg_line("rp-notch", at, at + kNotch * notch.inward);
      }
    }
    return svg;
  }

  /// Construction lines that have a title, and the centre line of a panel cut on the fold.
  std::string draw_lines(const PlacedPiece& piece, int panel) const {
    const PanelData& info = data_.panels[index(panel)];
    const ShapeData& shape = data_.shapes[index(info.shape)];
    const auto point = [&](int i, double side) {
      const std::size_t n = shape.vertices.size();
      const Vec2 p =
          scope_.metres(index(i) < n ? shape.vertices[index(i)] : shape.points[index(i) - n]);
      return piece.on_sheet(Vec2(side * p.x(), p.y()));
    };
    std::string svg;
    for (const ShapeLine& line : shape.lines) {
      if (line.title.empty()) continue;
      svg += svg_line("rp-line", point(line.from, 1.0), point(line.to, 1.0));
      if (shape.on_fold) svg += svg_line("rp-line", point(line.from, -1.0), point(line.to, -1.0));
      const Vec2 a = point(line.from, 1.0), b = point(line.to, 1.0);
      const Vec2 right = a.x() > b.x() ? a : b;
      if (is_sketch_) continue;
      svg += svg_text("rp-small", right + Vec2(-1.2, -0.5) * font_, "end", line.title);
    }
    if (shape.on_fold) {
      const Vec2 a = point(shape.edges.front().from, 1.0), b = point(shape.edges.back().to, 1.0);
      const Vec2 lower = a.y() > b.y() ? a : b;
      svg += svg_line("rp-centre", a, b);
      if (!is_sketch_) {
        svg +=
            svg_text("rp-small", lower + Vec2(-0.5, -1.2) * font_, "start", "centre line", -90.0);
      }
    }
    return svg;
  }

  std::string draw_grain(const PlacedPiece& piece) const {
    const Vec2 a = piece.on_sheet(scope_.metres(piece.piece->grain_from));
    const Vec2 b = piece.on_sheet(scope_.metres(piece.piece->grain_to));
    return svg_double_arrow("rp-grain", a, b, 1.1 * font_) +
           svg_text("rp-small", (a + b) / 2.0 + Vec2(-0.5 * font_, 0.0), "middle", "grain line",
                    -90.0);
  }

  /// Thin lines from the measured ends to an arrow that lies beside them; drawn below everything.
  std::string draw_extensions(const MeasureArrow& arrow) const {
    const PlacedPiece& piece = pieces_[index(arrow.piece)];
    const auto ends = arrow_ends(arrow);
    const Vec2 a = piece.on_sheet(ends[0]), b = piece.on_sheet(ends[1]);
    const Vec2 from = piece.on_sheet(scope_.metres(arrow.from));
    const Vec2 to = piece.on_sheet(scope_.metres(arrow.to));
    if ((a - from).norm() < 0.1) return "";
    const Vec2 beyond = (a - from).normalized() * 0.6 * font_;
    return svg_line("rp-extension", from, a + beyond) + svg_line("rp-extension", to, b + beyond);
  }

  std::string draw_arrow(const MeasureArrow& arrow) const {
    const PlacedPiece& piece = pieces_[index(arrow.piece)];
    const Dimension& dimension = garment_.dimension(arrow.dimension);
    const auto ends = arrow_ends(arrow);
    const Vec2 a = piece.on_sheet(ends[0]), b = piece.on_sheet(ends[1]);
    std::string svg = svg_double_arrow("rp-measure", a, b, font_);
    const Vec2 along = (b - a).x() > 1e-9 || std::abs((b - a).x()) <= 1e-9 ? b - a : a - b;
    double degrees = std::atan2(along.y(), along.x()) * 180.0 / std::numbers::pi;
    if (degrees > 89.9) degrees -= 180.0;  // an upright arrow is read from the right
    const double radians = degrees * std::numbers::pi / 180.0;
    const Vec2 down(-std::sin(radians), std::cos(radians));
    const Vec2 middle = a + arrow.label_at * (b - a);
    const double value = arrow.share * dimensions_.at(arrow.dimension);
    const std::string share = arrow.share == 0.5   ? std::string(kHalf) + " = "
                              : arrow.share == 1.0 ? ""
                                                   : svg_number(arrow.share) + " x = ";
    const std::string length = share + cm_text(value) + (is_sketch_ ? "" : " cm");
    if (is_sketch_) {
      // Beside the badge, on the side away from the piece.
      const bool above = (ends[0] - scope_.metres(arrow.from)).dot(down) < -1e-9;
      const Vec2 place = middle + (above ? -1.3 : 2.05) * font_ * down;
      return svg + draw_badge(middle, letter_of(dimension)) +
             svg_text("rp-value rp-halo", place, "middle", length, degrees);
    }
    svg += svg_text("rp-label", middle - 0.5 * font_ * down, "middle",
                    dimension.code + "  " + dimension.title, degrees);
    svg += svg_text("rp-value", middle + 1.25 * font_ * down, "middle", length, degrees);
    return svg;
  }

  std::string letter_of(const Dimension& dimension) const {
    const auto& all = garment_.dimensions();
    const auto at = std::find_if(all.begin(), all.end(),
                                 [&](const Dimension& d) { return d.name == dimension.name; });
    return dimension_letter(static_cast<std::size_t>(at - all.begin()));
  }

  std::string draw_badge(const Vec2& p, const std::string& letter) const {
    const std::string radius = svg_number(0.85 * font_);
    return "<circle class=\"rp-badge\" cx=\"" + svg_number(p.x()) + "\" cy=\"" + svg_number(p.y()) +
           "\" r=\"" + radius + "\"/>" +
           svg_text("rp-letter", p + Vec2(0.0, 0.36 * font_), "middle", letter);
  }

  std::string draw_legend() const {
    const double line = 1.7 * font_, left = margin_, right = width_ - margin_ - 24.0 * font_;
    double y = bottom_ + 3.5 * font_;
    std::string svg =
        svg_line("rp-rule", Vec2(left, bottom_ + font_), Vec2(width_ - margin_, bottom_ + font_));
    svg += svg_text("rp-title", Vec2(left, y), "start", garment_.title());
    double row = y + line;
    for (const PlacedPiece& piece : pieces_) {
      svg += svg_text("rp-body", Vec2(left, row), "start",
                      piece.piece->title + ": cut " + std::to_string(piece.piece->cut));
      row += line;
    }
    svg += svg_text(
        "rp-small", Vec2(left, row), "start",
        "Real size. No seam allowance. Dashed: seam inside the piece. Short strokes: notches.");
    svg += draw_scale(Vec2(left, row + line));
    svg += svg_text("rp-head", Vec2(right, y), "start", "Measurement of the flat garment") +
           svg_text("rp-head", Vec2(width_ - margin_ - 5.0 * font_, y), "end", "cm") +
           svg_text("rp-head", Vec2(width_ - margin_, y), "end", kHalf);
    for (const Dimension& d : garment_.dimensions()) {
      y += line;
      const double value = dimensions_.at(d.name);
      svg += svg_text("rp-code", Vec2(right, y), "start", d.code) +
             svg_text("rp-body", Vec2(right + 3.2 * font_, y), "start", d.title) +
             svg_text("rp-number", Vec2(width_ - margin_ - 5.0 * font_, y), "end", cm_text(value));
      if (d.circumference)
        svg += svg_text("rp-number", Vec2(width_ - margin_, y), "end", cm_text(value / 2.0));
    }
    return svg;
  }

  std::string draw_scale(const Vec2& p) const {
    const Vec2 tick(0.0, 0.5 * font_);
    std::string svg = svg_line("rp-scale", p, p + Vec2(100.0, 0.0));
    for (int cm = 0; cm <= 10; ++cm) {
      const Vec2 at = p + Vec2(10.0 * cm, 0.0);
      svg += svg_line("rp-scale", at, at - (cm % 5 == 0 ? 1.0 : 0.5) * tick);
    }
    return svg + svg_text("rp-small", p + Vec2(100.0 + 0.6 * font_, 0.0), "start",
                          "10 cm, to check a print");
  }

  std::string header(const PatternDrawingOptions& options) const {
    std::string svg;
    if (options.standalone) svg += "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
    const std::string w = svg_number(width_), h = svg_number(height_);
    svg += "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"rp-pattern\" role=\"img\" width=\"" +
           w + "mm\" height=\"" + h + "mm\" font-size=\"" + svg_number(font_) +
           "\" viewBox=\"0 0 " + w + " " + h + "\">\n";
    return svg + "<title>" + xml_escaped(garment_.title() + ", flat pattern") + "</title>\n<desc>" +
           xml_escaped(description()) + "</desc>\n";
  }

  std::string description() const {
    std::string text = "Pieces in real size with their measurements:";
    for (const Dimension& d : garment_.dimensions())
      text += " " + d.code + " " + d.title + " " + cm_text(dimensions_.at(d.name)) + " cm;";
    text.back() = '.';
    return text;
  }

  const GarmentTemplate& garment_;
  const TemplateData& data_;
  const Dimensions& dimensions_;
  NameScope scope_;
  std::vector<PlacedPiece> pieces_;
  bool is_sketch_;
  double font_ = 0.0, margin_ = 0.0, width_ = 0.0, height_ = 0.0, bottom_ = 0.0;  // mm
};

}  // namespace

std::string dimension_letter(std::size_t index) { return {static_cast<char>('A' + index % 26)}; }

std::string pattern_svg(const GarmentTemplate& garment, const Dimensions& dimensions,
                        const PatternDrawingOptions& options) {
  garment.evaluate("0", dimensions);  // says which dimension is missing
  if (const auto reason = why_impossible(garment.data(), dimensions))
    throw InvalidInput(garment.name() + ": these dimensions make no garment: " + *reason);
  return Drawing(garment, dimensions, options.style).svg(options);
}

}  // namespace regarment
