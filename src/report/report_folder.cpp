#include "report/report_folder.h"

#include <utility>

#include "base/error.h"
#include "garment/pattern_svg.h"
#include "geometry/parallel.h"
#include "geometry/ply_writer.h"
#include "report/borders_json.h"
#include "report/close_holes.h"
#include "report/evaluations_csv.h"
#include "report/export_files.h"
#include "report/files.h"
#include "report/measurements_csv.h"
#include "report/output_folder.h"
#include "report/page.h"
#include "report/size_json_ld.h"
#include "report/view3d.h"

namespace regarment {
namespace {

constexpr std::size_t kMostJson = 64u << 20;     // bytes of a stored result.json
constexpr std::size_t kMostPicture = 16u << 20;  // and of a stored picture or sketch
constexpr std::size_t kMostTable = 17u << 20;    // more than a table may have, so that it is told

std::string labels_file(const std::vector<std::uint8_t>& labels) {
  return {labels.begin(), labels.end()};
}

std::string filled_ply(const Scan& scan, const FilledScan& filled) {
  PlyWriter ply(filled.mesh.positions.size());
  ply.positions(in_file(scan, filled.mesh.positions)).column("filled", filled.filled);
  if (!filled.mesh.is_cloud()) ply.triangles(filled.mesh.triangles);
  return ply.bytes();
}

std::string numbered(const std::string& name, std::size_t i, const std::string& ending) {
  return name + "-" + std::to_string(i + 1) + ending;
}

constexpr const char* kView = "pictures/view.json";
std::string sketch_name(std::size_t i) { return numbered("pictures/sketch", i, ".svg"); }
std::string evaluations_name(std::size_t i) { return numbered("evaluations", i, ".csv"); }

// The files that wait neither for pictures nor for holes to be closed.
ReportFiles early_files(const Analysis& analysis, const std::vector<GarmentTemplate>& templates,
                        const ReportOptions& options) {
  ReportFiles files;
  const std::string view = view_json(analysis);
  if (!view.empty()) files[kView] = view;
  for (std::size_t i = 0; i < analysis.garments.size(); ++i) {
    const GarmentAnalysis& garment = analysis.garments[i];
    files[sketch_name(i)] =
        pattern_svg(templates[i], garment.dimensions, {.style = PatternStyle::Sketch});
    if (garment.trace) files[evaluations_name(i)] = evaluations_csv(*garment.trace);
  }
  if (!options.state.empty()) files["state.bin"] = options.state;
  files["labels.u8"] = labels_file(analysis.labels);
  files["borders.json"] = borders_json(analysis);
  add_exports(analysis, templates, files);
  return files;
}

PageParts parts_of(const ReportFiles& files, const Pictures& pictures, std::size_t garments) {
  const auto text = [&](const std::string& name) {
    const auto found = files.find(name);
    return found == files.end() ? std::string() : found->second;
  };
  PageParts parts{pictures.bytes, {}, text(kView), {}};
  for (std::size_t i = 0; i < garments; ++i) {
    parts.sketches.push_back(text(sketch_name(i)));
    parts.evaluations.push_back(text(evaluations_name(i)));
  }
  return parts;
}

// The early files and the rest.
ReportFiles with_pages(ReportFiles files, const Analysis& analysis,
                       const std::vector<GarmentTemplate>& templates, const ReportOptions& options,
                       const FilledScan& filled, const Pictures& pictures) {
  files.insert(pictures.bytes.begin(), pictures.bytes.end());
  files["filled.ply"] = filled_ply(analysis.scan, filled);
  Result result = make_result(analysis, templates, options);
  result.figures = pictures.figures;
  files["measurements.csv"] = measurements_csv(result);
  files["result.json"] = result_json(result);
  files["sizes.jsonld"] = size_json_ld(result) + "\n";
  // By way of the file, as `regarment report` does: the page cannot know more than the file.
  files["report.html"] = report_page(parse_result(files["result.json"], "result.json"),
                                     parts_of(files, pictures, analysis.garments.size()));
  return files;
}

void write_all(const ReportFiles& files, const std::filesystem::path& place, bool replace,
               const Progress& progress) {
  OutputFolder out(place, replace);
  for (const auto& [name, bytes] : files) {
    progress.report("write", 0.5);
    out.write(name, bytes);
  }
  out.publish();
}

PageParts stored_parts(const Result& result, const std::filesystem::path& folder) {
  PageParts parts;
  for (const StoredFigure& figure : result.figures) {
    parts.pictures[figure.file] = read_file(folder / figure.file, kMostPicture);
  }
  const std::filesystem::path view = folder / kView;
  if (std::filesystem::exists(view)) parts.view = read_file(view, kMostPicture);
  for (std::size_t i = 0; i < result.garments.size(); ++i) {
    parts.sketches.push_back(read_file(folder / sketch_name(i), kMostPicture));
    parts.evaluations.emplace_back();
    if (!result.garments[i].search) continue;
    parts.evaluations.back() = read_file(folder / evaluations_name(i), kMostTable);
  }
  return parts;
}

}  // namespace

ReportFiles report_files(const Analysis& analysis, const std::vector<GarmentTemplate>& templates,
                         const ReportOptions& options, const FilledScan& filled,
                         const Pictures& pictures) {
  return with_pages(early_files(analysis, templates, options), analysis, templates, options, filled,
                    pictures);
}

std::string write_report_folder(const Analysis& analysis,
                                const std::vector<GarmentTemplate>& templates,
                                const ReportOptions& options, const std::filesystem::path& place,
                                bool replace, const Progress& progress) {
  FilledScan filled;
  ReportFiles early;
  run_together({[&] { filled = close_holes(analysis); },
                [&] { early = early_files(analysis, templates, options); }});
  const Pictures pictures =
      draw_pictures(analysis, filled, options.pixel_ratio, options.threads, progress);
  progress.report("write", 0.0);
  const ReportFiles files =
      with_pages(std::move(early), analysis, templates, options, filled, pictures);
  write_all(files, place, replace, progress);
  progress.report("write", 1.0);
  return files.at("result.json");
}

std::filesystem::path remake_report(const std::filesystem::path& folder) {
  const std::string json = read_file(folder / "result.json", kMostJson);
  const Result result = parse_result(json, "result.json");
  const std::string page = report_page(result, stored_parts(result, folder));
  std::filesystem::path place = folder / "report.html";
  const std::filesystem::path hidden = folder / ".report.html-new";
  std::error_code error;
  std::filesystem::remove(hidden, error);
  write_file(hidden, page);
  std::filesystem::rename(hidden, place, error);
  if (error) throw_write_error(place, error.value());
  return place;
}

}  // namespace regarment
