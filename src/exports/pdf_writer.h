#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "geometry/mesh.h"

namespace regarment {

/// Puts a PDF file of line drawings and text together. Coordinates in millimetres from the left
/// upper corner of the page, y down. Text is Helvetica, reduced to printable ASCII. The same calls
/// give the same bytes: the file carries no date.
class PdfWriter {
 public:
  enum class Line { Solid, Dashed, DashDotted };

  PdfWriter(std::string title, double page_width, double page_height)
      : title_(std::move(title)), width_(page_width), height_(page_height) {}

  /// What follows stands on a new page.
  void begin_page();
  /// Pen for what follows on this page: width in mm, grey 0 (black) to 1.
  void pen(double width, Line line = Line::Solid, double grey = 0.0);
  void polyline(const std::vector<Vec2>& points, bool closed = false);
  void fill(const std::vector<Vec2>& polygon, double grey);
  /// `anchor` 0: the text starts at `at`, 0.5: its middle, 1: it ends there. `degrees` turns it
  /// about `at`, counter-clockwise as seen. `size`: mm of a line of text.
  void text(const Vec2& at, double size, std::string_view text, double anchor = 0.0,
            double degrees = 0.0, bool bold = false);
  /// Only what lies in this rectangle shows, until end_clip.
  void begin_clip(const Vec2& low, const Vec2& high);
  void end_clip();

  int pages() const { return static_cast<int>(pages_.size()); }
  /// The whole file. Needs at least one page.
  std::string bytes() const;

 private:
  Vec2 on_page(const Vec2& p) const;
  void path(const std::vector<Vec2>& points);

  std::string title_;
  double width_, height_;
  std::vector<std::string> pages_;  // their drawing operators
};

}  // namespace regarment
