#include "exports/print_piece.h"

#include <algorithm>
#include <cctype>

namespace regarment {
namespace {

constexpr double kMm = 1000.0;     // per metre
constexpr double kNotch = 5.0;     // mm
constexpr double kBorder = 8.0;    // mm, so that no line of the piece lies on a frame
constexpr double kInside = -1e-9;  // m, x of what lies on the drawn half of a folded piece

bool is_shown(const CutPiece& piece, const Vec2& p) { return !piece.on_fold || p.x() >= kInside; }

std::string cutting(const std::vector<CutPiece>& pieces, const CutPiece& first) {
  int alike = 0, mirrored = 0;
  for (const CutPiece& piece : pieces) {
    if (piece.shape == first.shape) ++(piece.turned == first.turned ? alike : mirrored);
  }
  if (first.on_fold) return "cut " + std::to_string(alike + mirrored) + " on the fold";
  const std::string text = "cut " + std::to_string(alike);
  return mirrored == 0 ? text : text + " and " + std::to_string(mirrored) + " mirrored";
}

std::vector<std::string> words_of(const std::string& name) {
  std::vector<std::string> words(1);
  for (const char c : name) {
    if (c == '_') {
      words.emplace_back();
    } else {
      words.back() += c;
    }
  }
  return words;
}

/// The words that all of these pieces' names have, or else all their names: "Sleeve" for the halves
/// of two sleeves, "Front, back".
std::string title(const std::vector<CutPiece>& pieces, const CutPiece& first) {
  std::vector<std::string> shared = words_of(first.name);
  std::string all;
  for (const CutPiece& piece : pieces) {
    if (piece.shape != first.shape) continue;
    const std::vector<std::string> words = words_of(piece.name);
    std::erase_if(shared, [&](const std::string& word) {
      return std::find(words.begin(), words.end(), word) == words.end();
    });
    all += all.empty() ? "" : ", ";
    for (std::size_t w = 0; w < words.size(); ++w) all += (w == 0 ? "" : " ") + words[w];
  }
  std::string text;
  for (const std::string& word : shared) text += (text.empty() ? "" : " ") + word;
  if (text.empty()) text = all;
  text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  return text;
}

void draw_outline(const CutPiece& piece, PrintPiece& out) {
  const std::size_t half = piece.edges.size() / 2;
  const std::size_t count = piece.on_fold ? half : piece.edges.size();
  const bool second = piece.on_fold && piece.edges.front().points.back().x() < kInside;
  for (std::size_t e = 0; e < count; ++e) {
    const std::vector<Vec2>& points = piece.edges[second ? half + e : e].points;
    out.cut.push_back(points);
    out.outline.insert(out.outline.end(), points.begin(), points.end());
  }
  if (piece.on_fold) out.fold.push_back({out.outline.back(), out.outline.front()});
}

/// Every point of the piece through `move`.
template <typename Move>
void move_all(PrintPiece& piece, const Move& move) {
  for (auto* lines : {&piece.cut, &piece.fold, &piece.notches})
    for (std::vector<Vec2>& line : *lines) std::for_each(line.begin(), line.end(), move);
  for (CutLine& line : piece.lines) {
    move(line.from);
    move(line.to);
  }
  std::for_each(piece.grain.begin(), piece.grain.end(), move);
  std::for_each(piece.outline.begin(), piece.outline.end(), move);
}

/// From metres to millimetres, the grain line upright, the left upper corner to the origin.
void to_paper(PrintPiece& piece) {
  const Vec2 down = (piece.grain[1] - piece.grain[0]).normalized();
  const Vec2 right(down.y(), -down.x());
  move_all(piece, [&](Vec2& p) { p = kMm * Vec2(p.dot(right), p.dot(down)); });
  Vec2 low = piece.outline.front(), high = low;
  for (const Vec2& p : piece.outline) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  move_all(piece, [&](Vec2& p) { p -= low - Vec2::Constant(kBorder); });
  piece.size = high - low + Vec2::Constant(2.0 * kBorder);
}

PrintPiece print_piece(const std::vector<CutPiece>& pieces, const CutPiece& first) {
  PrintPiece out;
  out.title = title(pieces, first);
  out.cutting = cutting(pieces, first);
  draw_outline(first, out);
  for (const Notch& notch : first.notches) {
    if (is_shown(first, notch.at))
      out.notches.push_back({notch.at, notch.at + kNotch / kMm * notch.inward});
  }
  for (CutLine line : first.lines) {
    if (first.on_fold) {
      if (line.from.x() > line.to.x()) std::swap(line.from, line.to);
      if (line.to.x() <= 0.0) continue;
      if (line.from.x() < 0.0) line.from.x() = 0.0;
    }
    out.lines.push_back(line);
  }
  out.grain = first.grain;
  to_paper(out);
  return out;
}

}  // namespace

std::vector<PrintPiece> print_pieces(const std::vector<CutPiece>& pieces) {
  std::vector<PrintPiece> out;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const bool seen = std::any_of(pieces.begin(), pieces.begin() + static_cast<std::ptrdiff_t>(i),
                                  [&](const CutPiece& p) { return p.shape == pieces[i].shape; });
    if (!seen) out.push_back(print_piece(pieces, pieces[i]));
  }
  return out;
}

}  // namespace regarment
