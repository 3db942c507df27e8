#include "exports/pattern_tiles.h"

#include <cmath>
#include <cstdio>
#include <numbers>

#include "exports/pdf_writer.h"
#include "exports/print_piece.h"
#include "garment/plane.h"

namespace regarment {
namespace {

const Vec2 kPage(210.0, 297.0);      // mm, A4
const Vec2 kTile(180.0, 250.0);      // mm; with it a page fits on US Letter (215.9 x 279.4) too
const Vec2 kCorner(15.0, 23.5);      // mm, of the tile on the page
constexpr double kMark = 5.0;        // mm, half of a mark that two or four pages share
constexpr double kText = 4.0;        // mm
constexpr double kArrow = 4.0;       // mm
constexpr double kMapHeight = 85.0;  // mm

/// Place of a tile among a piece's.
struct Tile {
  int column = 0, row = 0;
};

/// "2-B3": piece 2, second row, third column.
std::string name_of(std::size_t piece, const Tile& tile) {
  const std::string row = tile.row < 26 ? std::string(1, static_cast<char>('A' + tile.row))
                                        : "R" + std::to_string(tile.row + 1) + ".";
  return std::to_string(piece + 1) + "-" + row + std::to_string(tile.column + 1);
}

Vec2 corner_of(const Tile& tile) { return {tile.column * kTile.x(), tile.row * kTile.y()}; }

bool crosses(const Vec2& low, const Vec2& high, const Vec2& a, const Vec2& b) {
  // Clips the segment by one side after the other.
  double from = 0.0, to = 1.0;
  for (int k = 0; k < 2; ++k) {
    const double along = b[k] - a[k];
    if (std::abs(along) < 1e-12) {
      if (a[k] < low[k] || a[k] > high[k]) return false;
      continue;
    }
    const double one = (low[k] - a[k]) / along, two = (high[k] - a[k]) / along;
    from = std::max(from, std::min(one, two));
    to = std::min(to, std::max(one, two));
  }
  return from <= to;
}

/// Tiles that show a part of the piece, row by row.
std::vector<Tile> tiles_of(const PrintPiece& piece) {
  std::vector<Tile> tiles;
  const int columns = static_cast<int>(std::ceil(piece.size.x() / kTile.x() - 1e-9));
  const int rows = static_cast<int>(std::ceil(piece.size.y() / kTile.y() - 1e-9));
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const Vec2 low = corner_of({column, row}), high = low + kTile;
      bool shown = is_inside(piece.outline, (low + high) / 2.0);
      for (std::size_t i = 0; i < piece.outline.size() && !shown; ++i)
        shown = crosses(low, high, piece.outline[i], piece.outline[(i + 1) % piece.outline.size()]);
      if (shown) tiles.push_back({column, row});
    }
  }
  return tiles;
}

class TilePages {
 public:
  TilePages(const GarmentTemplate& garment, const Dimensions& dimensions)
      : garment_(garment),
        dimensions_(dimensions),
        pieces_(print_pieces(cut_pieces(garment, dimensions))),
        pdf_(garment.title() + ", pattern in real size", kPage.x(), kPage.y()) {
    for (const PrintPiece& piece : pieces_) tiles_.push_back(tiles_of(piece));
  }

  std::string bytes() {
    draw_cover();
    for (std::size_t p = 0; p < pieces_.size(); ++p)
      for (const Tile& tile : tiles_[p]) draw_tile(p, tile);
    return pdf_.bytes();
  }

 private:
  void draw_cover() {
    pdf_.begin_page();
    const double left = 20.0;
    double y = 30.0;
    pdf_.text(Vec2(left, y), 9.0, garment_.title(), 0.0, 0.0, true);
    y += 10.0;
    std::size_t sheets = 0;
    for (const auto& tiles : tiles_) sheets += tiles.size();
    for (const std::string& line :
         {std::string(
              "Flat pattern in real size, without seam allowance: the outline is the sewing line."),
          "Print all " + std::to_string(sheets + 1) +
              " pages at 100 % (no scaling), on A4 or US Letter, and measure the square below.",
          std::string(
              "Cut two sides of each frame and join the pages so that marks and lines meet.")}) {
      pdf_.text(Vec2(left, y), kText, line);
      y += 6.0;
    }
    draw_square(Vec2(left, y + 4.0));
    draw_measurements(Vec2(135.0, y + 8.0));
    draw_maps(Vec2(left, y + 120.0));
  }

  void draw_square(const Vec2& at) {
    pdf_.pen(0.3);
    pdf_.polyline({at, at + Vec2(100.0, 0.0), at + Vec2(100.0, 100.0), at + Vec2(0.0, 100.0)},
                  true);
    for (int cm = 1; cm < 10; ++cm) {
      const Vec2 tick = at + Vec2(10.0 * cm, 0.0);
      pdf_.polyline({tick, tick + Vec2(0.0, cm == 5 ? 4.0 : 2.0)});
    }
    pdf_.text(at + Vec2(50.0, 52.0), kText, "Test square, 10 cm x 10 cm", 0.5);
  }

  void draw_measurements(Vec2 at) {
    pdf_.text(at, kText, "Flat garment", 0.0, 0.0, true);
    pdf_.text(at + Vec2(60.0, 0.0), kText, "cm", 1.0);
    for (const Dimension& d : garment_.dimensions()) {
      at.y() += 6.0;
      char length[32];
      std::snprintf(length, sizeof length, "%.1f", 100.0 * dimensions_.at(d.name));
      pdf_.text(at, kText, d.code + "  " + d.title);
      pdf_.text(at + Vec2(60.0, 0.0), kText, length, 1.0);
    }
  }

  /// How large the maps of the pages are drawn, so that they stand side by side on the cover.
  double map_scale() const {
    double tallest = 1.0;
    for (const auto& tiles : tiles_)
      for (const Tile& tile : tiles) tallest = std::max(tallest, (tile.row + 1) * kTile.y());
    return std::min(0.1, kMapHeight / tallest);
  }

  /// Each piece small over the frames of its pages.
  void draw_maps(Vec2 at) {
    const double scale = map_scale(), left = at.x();
    for (std::size_t p = 0; p < pieces_.size(); ++p) {
      int columns = 1;
      for (const Tile& tile : tiles_[p]) columns = std::max(columns, tile.column + 1);
      const double width = std::max(55.0, columns * scale * kTile.x());
      if (at.x() > left && at.x() + width > kPage.x() - 15.0) {
        pdf_.begin_page();
        at = Vec2(left, 30.0);
      }
      draw_map(p, at, scale);
      at.x() += width + 8.0;
    }
  }

  void draw_map(std::size_t p, const Vec2& at, double scale) {
    const PrintPiece& piece = pieces_[p];
    pdf_.text(at, kText, std::to_string(p + 1) + "  " + piece.title, 0.0, 0.0, true);
    pdf_.text(at + Vec2(0.0, 5.5), kText, piece.cutting);
    const Vec2 corner = at + Vec2(0.0, 10.0);
    for (const Tile& tile : tiles_[p]) {
      const Vec2 low = corner + scale * corner_of(tile), size = scale * kTile;
      pdf_.pen(0.15, PdfWriter::Line::Solid, 0.6);
      pdf_.polyline({low, low + Vec2(size.x(), 0.0), low + size, low + Vec2(0.0, size.y())}, true);
      pdf_.text(low + size / 2.0 + Vec2(0.0, 1.0), 2.6, name_of(p, tile), 0.5);
    }
    for (const auto* lines : {&piece.cut, &piece.fold}) {
      pdf_.pen(0.35, lines == &piece.cut ? PdfWriter::Line::Solid : PdfWriter::Line::DashDotted);
      for (std::vector<Vec2> line : *lines) {
        for (Vec2& point : line) point = corner + scale * point;
        pdf_.polyline(line);
      }
    }
  }

  void draw_tile(std::size_t p, const Tile& tile) {
    const PrintPiece& piece = pieces_[p];
    pdf_.begin_page();
    shift_ = kCorner - corner_of(tile);
    draw_frame(p, tile);
    pdf_.begin_clip(kCorner, kCorner + kTile);
    pdf_.pen(0.2, PdfWriter::Line::Dashed, 0.3);
    for (const CutLine& line : piece.lines) {
      pdf_.polyline({on_page(line.from), on_page(line.to)});
      pdf_.text(on_page(line.to) + Vec2(-4.0, -2.0), kText, line.title, 1.0);
    }
    pdf_.pen(0.35, PdfWriter::Line::DashDotted);
    for (const auto& line : piece.fold) draw_fold(line);
    pdf_.pen(0.5);
    for (const auto& line : piece.cut) draw_line(line);
    for (const auto& line : piece.notches) draw_line(line);
    draw_grain(piece);
    pdf_.end_clip();
  }

  void draw_line(const std::vector<Vec2>& line) {
    std::vector<Vec2> points;
    points.reserve(line.size());
    for (const Vec2& p : line) points.push_back(on_page(p));
    pdf_.polyline(points);
  }

  void draw_fold(const std::vector<Vec2>& line) {
    draw_line(line);
    const Vec2 a = on_page(line.front()), b = on_page(line.back());
    const bool upwards = a.y() > b.y();
    pdf_.text((a + b) / 2.0 + Vec2(6.0, 0.0), kText, "place on the fold", 0.5,
              upwards ? 90.0 : -90.0);
  }

  void draw_grain(const PrintPiece& piece) {
    const Vec2 a = on_page(piece.grain[0]), b = on_page(piece.grain[1]);
    const Vec2 along = (b - a).normalized(), across(-along.y(), along.x());
    pdf_.pen(0.3);
    pdf_.polyline({a, b});
    for (const auto& [tip, back] : {std::pair(a, along), std::pair(b, Vec2(-along))})
      pdf_.fill({tip, tip + kArrow * back + 0.3 * kArrow * across,
                 tip + kArrow * back - 0.3 * kArrow * across},
                0.0);
    double degrees = std::atan2(-along.y(), along.x()) * 180.0 / std::numbers::pi;
    if (degrees < -89.9 || degrees > 90.1) degrees += 180.0;
    const Vec2 third = a + (b - a) / 3.0;
    pdf_.text(third + 3.0 * across, kText, "grain line", 0.5, degrees);
    pdf_.text((a + b) / 2.0 - 5.0 * across, kText, piece.title + ": " + piece.cutting, 0.5, degrees,
              true);
    pdf_.text((a + b) / 2.0 - 10.0 * across, kText, garment_.title() + ", no seam allowance", 0.5,
              degrees);
  }

  /// The frame, the marks half on this page and half on the next one, and the page's name.
  void draw_frame(std::size_t p, const Tile& tile) {
    const Vec2 low = kCorner, high = kCorner + kTile, middle = (low + high) / 2.0;
    pdf_.pen(0.15, PdfWriter::Line::Solid, 0.5);
    pdf_.polyline({low, Vec2(high.x(), low.y()), high, Vec2(low.x(), high.y())}, true);
    const Vec2 x(kMark, 0.0), y(0.0, kMark);
    const auto mark = [&](const Vec2& at, const Vec2& along, const Vec2& inward) {
      pdf_.fill({at - along, at + along, at + inward}, 0.6);
    };
    mark(Vec2(low.x(), middle.y()), y, x);
    mark(Vec2(high.x(), middle.y()), y, -x);
    mark(Vec2(middle.x(), low.y()), x, y);
    mark(Vec2(middle.x(), high.y()), x, -y);
    const std::string foot = garment_.title() + ", " + pieces_[p].title + " (" +
                             pieces_[p].cutting + "). No seam allowance. Print at 100 %.";
    pdf_.text(Vec2(low.x(), high.y() + 6.0), 3.5, foot);
    pdf_.text(Vec2(high.x(), high.y() + 6.0), kText + 1.0, name_of(p, tile), 1.0, 0.0, true);
  }

  Vec2 on_page(const Vec2& on_piece) const { return on_piece + shift_; }

  const GarmentTemplate& garment_;
  const Dimensions& dimensions_;
  std::vector<PrintPiece> pieces_;
  std::vector<std::vector<Tile>> tiles_;
  PdfWriter pdf_;
  Vec2 shift_ = Vec2::Zero();
};

}  // namespace

std::string pattern_tiles(const GarmentTemplate& garment, const Dimensions& dimensions) {
  return TilePages(garment, dimensions).bytes();
}

}  // namespace regarment
