#include "report/pictures.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>

#include "render/render_figures.h"
#include "report/close_holes.h"
#include "report/deviation.h"

namespace regarment {
namespace {

// Twenty pictures of this size and quality come to about 500 KB. JPEG, because WebP takes fifteen
// times as long to write.
constexpr int kWidth = 420, kHeight = 760, kQuality = 85;
constexpr int kFineQuality = 78;  // of two pixels for each, where less is seen of single ones

// A neutral ground on which both the light and the dark page can show them.
constexpr Rgba kGround = {236, 238, 239, 255};

Scene scene_of(const Analysis& analysis, const std::vector<float>& deviation) {
  Scene scene{.scan = analysis.scan.mesh,
              .labels = analysis.labels,
              .values = deviation,
              .cap = analysis.cap,
              .outlier = analysis.scan.outlier,
              .garments = {},
              .probability = analysis.label_probability,
              .border_lines = {}};
  for (const GarmentAnalysis& garment : analysis.garments) {
    scene.garments.push_back(
        {garment.pattern.triangles, garment.placed, garment.draped, garment.layer});
    for (const BorderLine& line : garment.borders) scene.border_lines.emplace_back(line.points);
  }
  return scene;
}

// What was added has a colour of its own, as a garment more would have.
std::vector<Figure> draw_filled(const Analysis& analysis, const FilledScan& filled,
                                const FigureOptions& options) {
  const std::size_t garments = analysis.garments.size();
  std::vector<std::uint8_t> labels = analysis.labels;
  labels.resize(filled.filled.size(), static_cast<std::uint8_t>(garments + 1));
  std::vector<std::uint8_t> outlier = analysis.scan.outlier;
  if (!outlier.empty()) outlier.resize(filled.filled.size(), 0);
  Scene scene{.scan = filled.mesh,
              .labels = labels,
              .values = {},
              .cap = {},
              .outlier = outlier,
              .garments = {}};
  for (std::size_t g = 0; g <= garments; ++g)
    scene.garments.push_back({{}, {}, {}, static_cast<int>(g + 1)});
  const std::array<Look, 1> looks = {Look::Segmentation};
  return render_figures(scene, looks, options);
}

std::string encoded(const Image& image, int quality) {
  const std::vector<std::byte> bytes =
      encode_image(flatten(image, kGround), ImageFormat::Jpeg, quality);
  std::string out(bytes.size(), '\0');
  std::transform(bytes.begin(), bytes.end(), out.begin(),
                 [](std::byte b) { return static_cast<char>(b); });
  return out;
}

// Each picture by itself, so the bytes are the same however many threads share the work.
std::vector<std::string> encode_all(const std::vector<Figure>& figures, int quality, int threads) {
  std::vector<std::string> out(figures.size());
  std::atomic<std::size_t> next{0};
  std::exception_ptr failure;
  std::mutex guard;
  const auto work = [&] {
    try {
      for (std::size_t i = next++; i < figures.size(); i = next++) {
        out[i] = encoded(figures[i].image, quality);
      }
    } catch (...) {
      const std::lock_guard lock(guard);
      failure = std::current_exception();
    }
  };
  {
    std::vector<std::jthread> helpers;
    for (int i = 1; i < threads; ++i) helpers.emplace_back(work);
    work();
  }
  if (failure) std::rethrow_exception(failure);
  return out;
}

}  // namespace

Pictures draw_pictures(const Analysis& analysis, const FilledScan& filled, int pixel_ratio,
                       int threads, const Progress& progress) {
  progress.report("draw", 0.0);
  FigureOptions options;
  options.framing.width = pixel_ratio * kWidth;
  options.framing.height = pixel_ratio * kHeight;
  options.pixel_ratio = pixel_ratio;
  options.scale_bar = true;
  std::vector<Look> looks = {Look::Scan, Look::Segmentation, Look::Placement, Look::Drape};
  const std::vector<float> deviation = merged_deviation(analysis);
  if (!deviation.empty()) {
    looks.push_back(Look::Deviation);
    options.scale = symmetric_scale(deviation_range(deviation));
  }
  std::vector<Figure> figures = render_figures(scene_of(analysis, deviation), looks, options);
  const std::size_t of_scan = figures.size();
  if (count_filled(filled) > 0)
    for (Figure& figure : draw_filled(analysis, filled, options))
      figures.push_back(std::move(figure));
  progress.report("draw", 0.5);
  std::vector<std::string> bytes =
      encode_all(figures, pixel_ratio > 1 ? kFineQuality : kQuality, threads);
  Pictures out;
  for (std::size_t i = 0; i < figures.size(); ++i) {
    const std::string kind(i < of_scan ? look_name(figures[i].look) : "filled");
    const std::string side(view_name(figures[i].view));
    std::string file = "pictures/";
    file.append(kind).append("-").append(side).append(".jpg");
    out.figures.push_back({kind, side, file, figures[i].image.width, figures[i].image.height});
    out.bytes[file] = std::move(bytes[i]);
  }
  progress.report("draw", 1.0);
  return out;
}

}  // namespace regarment
