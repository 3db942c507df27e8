#include "evaluation/confusion_picture.h"

#include <algorithm>
#include <array>

#include "base/error.h"
#include "render/render_figures.h"
#include "report/files.h"
#include "report/label_score.h"
#include "report/result.h"
#include "scan/make_scan.h"
#include "scan/read_sandboxed.h"

namespace regarment {
namespace {

constexpr std::size_t kMostResultBytes = 64U << 20U;
constexpr std::uint8_t kNotScored = 255;
constexpr int kWidth = 230, kHeight = 400, kGap = 10, kQuality = 80;
constexpr Rgba kGround = {236, 238, 239, 255};  // that of the reports' pictures

// The scan as the fit saw it.
Scan standing(const EvaluationCase& about, const ResultScan& seen) {
  ScanOptions options;
  options.units = seen.units;
  if (seen.up != "free") options.up = seen.up;
  if (!seen.front_guessed) options.front = seen.front;
  return make_scan(read_mesh_sandboxed(about.scan).mesh, options);
}

std::string text_of(const std::vector<std::byte>& bytes) {
  std::string out(bytes.size(), '\0');
  std::transform(bytes.begin(), bytes.end(), out.begin(),
                 [](std::byte b) { return static_cast<char>(b); });
  return out;
}

}  // namespace

Confusion confusion_of(std::uint8_t label, std::uint8_t truth) {
  if (truth == kNotScored) return Confusion::NotScored;
  if (label == truth) return truth == 0 ? Confusion::RightPerson : Confusion::RightGarment;
  return label == 0 ? Confusion::Missed : Confusion::Wrong;
}

Colour confusion_colour(Confusion confusion) {
  switch (confusion) {
    case Confusion::RightPerson:
      return {222, 222, 218};
    case Confusion::RightGarment:
      return {98, 170, 222};
    case Confusion::Missed:
      return {240, 160, 20};
    case Confusion::Wrong:
      return {122, 28, 130};
    case Confusion::NotScored:
      return {150, 152, 154};
  }
  throw InvalidInput("unknown confusion " + std::to_string(static_cast<int>(confusion)));
}

DrawnConfusion draw_confusion(const EvaluationCase& about, const std::filesystem::path& folder) {
  const Result result =
      parse_result(read_file(folder / "result.json", kMostResultBytes), "result.json");
  Scan scan = standing(about, result.scan);
  const std::size_t vertices = scan.mesh.positions.size();
  const auto labels = read_labels(folder / "labels.u8", vertices);
  const auto truth = read_labels(*about.labels, vertices);
  scan.mesh.colours.resize(vertices);
  for (std::size_t i = 0; i < vertices; ++i) {
    scan.mesh.colours[i] = confusion_colour(confusion_of(labels[i], truth[i]));
  }
  FigureOptions options;
  options.framing.width = kWidth;
  options.framing.height = kHeight;
  options.views = {View::Front, View::Back};
  options.background = kGround;
  const Scene scene{.scan = scan.mesh,
                    .labels = {},
                    .values = {},
                    .cap = {},
                    .outlier = scan.outlier,
                    .garments = {}};
  const std::array<Look, 1> looks = {Look::Scan};
  const std::vector<Figure> figures = render_figures(scene, looks, options);
  const std::array<Image, 2> sides = {figures.at(0).image, figures.at(1).image};
  const Image both = flatten(side_by_side(sides, kGap), kGround);
  return {text_of(encode_image(both, ImageFormat::WebP, kQuality)), both.width, both.height};
}

}  // namespace regarment
