#include "exports/pdf_writer.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>

namespace regarment {
namespace {

constexpr double kPoints = 72.0 / 25.4;  // of PDF, per mm

// Widths of Helvetica's characters from the space to '~', in thousandths of the size.
constexpr std::array<int, 95> kWidths = {
    278, 278, 355, 556, 556, 889, 667, 191, 333, 333, 389, 584, 278, 333,  278, 278, 556, 556, 556,
    556, 556, 556, 556, 556, 556, 556, 278, 278, 584, 584, 584, 556, 1015, 667, 667, 722, 722, 667,
    611, 778, 722, 278, 500, 667, 556, 833, 722, 778, 667, 778, 722, 667,  611, 722, 667, 944, 667,
    667, 611, 278, 278, 278, 469, 556, 333, 556, 556, 500, 556, 556, 278,  556, 556, 222, 222, 500,
    222, 833, 556, 556, 556, 556, 333, 500, 278, 556, 500, 722, 500, 500,  500, 334, 260, 334, 584};

std::string number(double value) {
  char buffer[64];
  std::snprintf(buffer, sizeof buffer, "%.4f", value);
  const std::string text = buffer;
  return text == "-0.0000" ? "0.0000" : text;
}

std::string point(const Vec2& p) { return number(p.x()) + ' ' + number(p.y()) + ' '; }

std::string ascii(std::string_view text) {
  std::string out;
  for (const char c : text) out += c >= ' ' && c <= '~' ? c : '?';
  return out;
}

double width_of(const std::string& text, double size) {
  double width = 0.0;
  for (const char c : text) width += kWidths[static_cast<std::size_t>(c - ' ')];
  return width / 1000.0 * size;
}

/// A PDF string: brackets and backslashes escaped.
std::string literal(const std::string& text) {
  std::string out = "(";
  for (const char c : text) {
    if (c == '(' || c == ')' || c == '\\') out += '\\';
    out += c;
  }
  return out + ')';
}

/// Objects of a file, numbered from 1 on, with their offsets.
class Objects {
 public:
  void add(const std::string& content) {
    offsets_.push_back(file_.size());
    file_ += std::to_string(offsets_.size()) + " 0 obj\n" + content + "\nendobj\n";
  }

  std::string finished() {
    const std::size_t table = file_.size();
    const std::string count = std::to_string(offsets_.size() + 1);
    file_ += "xref\n0 " + count + "\n0000000000 65535 f \n";
    for (const std::size_t offset : offsets_) {
      char row[32];
      std::snprintf(row, sizeof row, "%010zu 00000 n \n", offset);
      file_ += row;
    }
    return file_ + "trailer\n<< /Size " + count + " /Root 1 0 R /Info 3 0 R >>\nstartxref\n" +
           std::to_string(table) + "\n%%EOF\n";
  }

 private:
  std::string file_ = "%PDF-1.4\n%\xE2\xE3\xCF\xD3\n";
  std::vector<std::size_t> offsets_;
};

constexpr int kFirstPage = 6;  // catalogue, pages, info and two fonts come before

}  // namespace

Vec2 PdfWriter::on_page(const Vec2& p) const {
  return {kPoints * p.x(), kPoints * (height_ - p.y())};
}

void PdfWriter::begin_page() { pages_.emplace_back("1 J 1 j\n"); }

void PdfWriter::pen(double width, Line line, double grey) {
  pages_.back() += number(kPoints * width) + " w " + number(grey) + " G " +
                   (line == Line::Solid    ? "[] 0 d\n"
                    : line == Line::Dashed ? "[7 5] 0 d\n"
                                           : "[16 4 2 4] 0 d\n");
}

void PdfWriter::path(const std::vector<Vec2>& points) {
  for (std::size_t i = 0; i < points.size(); ++i)
    pages_.back() += point(on_page(points[i])) + (i == 0 ? "m\n" : "l\n");
}

void PdfWriter::polyline(const std::vector<Vec2>& points, bool closed) {
  path(points);
  pages_.back() += closed ? "s\n" : "S\n";
}

void PdfWriter::fill(const std::vector<Vec2>& polygon, double grey) {
  pages_.back() += number(grey) + " g\n";
  path(polygon);
  pages_.back() += "h f\n";
}

void PdfWriter::text(const Vec2& at, double size, std::string_view text, double anchor,
                     double degrees, bool bold) {
  const std::string plain = ascii(text);
  const double angle = degrees * std::numbers::pi / 180.0;
  const double c = std::cos(angle), s = std::sin(angle);
  const Vec2 start = at - anchor * width_of(plain, size) * Vec2(c, -s);
  pages_.back() += std::string("BT 0 g ") + (bold ? "/F2 " : "/F1 ") + number(kPoints * size) +
                   " Tf " + number(c) + ' ' + number(s) + ' ' + number(-s) + ' ' + number(c) + ' ' +
                   point(on_page(start)) + "Tm " + literal(plain) + " Tj ET\n";
}

void PdfWriter::begin_clip(const Vec2& low, const Vec2& high) {
  const Vec2 corner = on_page(Vec2(low.x(), high.y())), size = kPoints * (high - low);
  pages_.back() += "q " + point(corner) + point(size) + "re W n\n";
}

void PdfWriter::end_clip() { pages_.back() += "Q\n"; }

std::string PdfWriter::bytes() const {
  Objects objects;
  std::string kids;
  for (std::size_t i = 0; i < pages_.size(); ++i)
    kids += std::to_string(kFirstPage + 2 * static_cast<int>(i)) + " 0 R ";
  objects.add("<< /Type /Catalog /Pages 2 0 R /ViewerPreferences << /PrintScaling /None >> >>");
  objects.add("<< /Type /Pages /Count " + std::to_string(pages_.size()) + " /Kids [ " + kids +
              "] >>");
  objects.add("<< /Title " + literal(ascii(title_)) + " /Producer (regarment) >>");
  for (const char* font : {"Helvetica", "Helvetica-Bold"})
    objects.add(std::string("<< /Type /Font /Subtype /Type1 /BaseFont /") + font +
                " /Encoding /WinAnsiEncoding >>");
  for (std::size_t i = 0; i < pages_.size(); ++i) {
    objects.add("<< /Type /Page /Parent 2 0 R /MediaBox [0 0 " + number(kPoints * width_) + ' ' +
                number(kPoints * height_) + "] /Resources << /Font << /F1 4 0 R /F2 5 0 R >> >> " +
                "/Contents " + std::to_string(kFirstPage + 2 * static_cast<int>(i) + 1) +
                " 0 R >>");
    objects.add("<< /Length " + std::to_string(pages_[i].size()) + " >>\nstream\n" + pages_[i] +
                "endstream");
  }
  return objects.finished();
}

}  // namespace regarment
