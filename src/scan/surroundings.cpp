#include "scan/surroundings.h"

#include <array>
#include <cmath>

namespace regarment {
namespace {

constexpr double kLevel = 0.94;         // cosine, 20 degrees: steeper sheets are walls
constexpr double kManyOutliers = 0.01;  // share of vertices: a scanner in trouble

double up_part(const OuterSheet& sheet, const Eigen::Matrix3d& turn) {
  return turn.row(1).dot(sheet.normal);
}

void note(const char* code, Severity severity, std::string found, const char* advice, Scan& scan) {
  scan.facts.findings.push_back(
      {code, severity, std::move(found), "Left out of every measurement", advice});
}

std::string vertices(std::size_t count, std::size_t of) {
  return counted(count, "vertex", "vertices") + ", " +
         percent(static_cast<double>(count) / static_cast<double>(of));
}

/// What the sheets are called, by which way they face.
const char* sheet_words(std::span<const OuterSheet> sheets, const Eigen::Matrix3d& turn) {
  std::size_t floors = 0;
  for (const OuterSheet& sheet : sheets) floors += up_part(sheet, turn) > kLevel ? 1 : 0;
  if (floors == sheets.size()) return "A floor is";
  return floors > 0 ? "A floor and a wall are" : "A wall is";
}

}  // namespace

std::optional<double> sheet_floor(std::span<const OuterSheet> sheets, const BodyFrame& frame) {
  std::optional<double> floor;
  double most = kLevel;
  for (const OuterSheet& sheet : sheets) {
    const double up = up_part(sheet, frame.turn);
    if (up <= most) continue;
    most = up;
    floor = -sheet.above(frame.origin) / up * frame.metres;
  }
  return floor;
}

std::vector<Belongs> belongs_of_vertices(const SeparatedBody& separated, const Welded& welded) {
  std::vector<Belongs> belongs(welded.of_vertex.size(), Belongs::Nowhere);
  for (std::size_t v = 0; v < belongs.size(); ++v) {
    const std::uint32_t at = welded.of_vertex[v];
    if (at != Welded::kNone) belongs[v] = separated.belongs[at];
  }
  return belongs;
}

void note_surroundings(std::span<const Belongs> belongs, std::span<const OuterSheet> sheets,
                       Scan& scan) {
  std::array<std::size_t, 6> counts{};  // by what vertices belong to
  const std::size_t all = scan.outlier.size();
  for (std::size_t v = 0; v < all; ++v) {
    if (scan.outlier[v] == 0) continue;
    // What lies lonely beside the body's surface is stray too.
    const Belongs to = belongs[v] == Belongs::Body ? Belongs::Stray : belongs[v];
    ++counts[static_cast<std::size_t>(to)];
  }
  const auto count = [&](Belongs what) { return counts[static_cast<std::size_t>(what)]; };
  if (const std::size_t n = count(Belongs::Sheet); n > 0) {
    const Eigen::Matrix3d turn = scan.file_from_body.linear().transpose().rowwise().normalized();
    const std::string words = sheet_words(sheets, turn);
    note(words == "A wall is" ? "wall" : "floor", Severity::Note,
         words + " in the scan (" + vertices(n, all) + ")", "", scan);
  }
  if (const std::size_t n = count(Belongs::Post); n > 0) {
    note("post", Severity::Note, "Columns stand beside the person (" + vertices(n, all) + ")", "",
         scan);
  }
  if (const std::size_t n = count(Belongs::Island); n > 0) {
    note("island", Severity::Note, "Pieces float apart from the person (" + vertices(n, all) + ")",
         "", scan);
  }
  if (const std::size_t n = count(Belongs::Stray); n > 0) {
    const bool many = static_cast<double>(n) > kManyOutliers * static_cast<double>(all);
    note("outliers", many ? Severity::Advice : Severity::Note,
         counted(n, "vertex lies", "vertices lie") + " far from any surface (" +
             percent(static_cast<double>(n) / static_cast<double>(all)) + ")",
         many ? "Clean the scan, or look what the scanner is troubled by" : "", scan);
  }
}

}  // namespace regarment
