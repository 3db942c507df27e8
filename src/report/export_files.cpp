#include "report/export_files.h"

#include "exports/garment_glb.h"
#include "exports/garment_obj.h"
#include "exports/pattern_dxf.h"
#include "exports/pattern_tiles.h"
#include "exports/pattern_val.h"
#include "exports/scan_glb.h"
#include "garment/pattern_json.h"
#include "garment/pattern_svg.h"
#include "geometry/ply_writer.h"
#include "render/heat_map.h"

namespace regarment {
namespace {

// The colours of the labels in the pictures, shaded where the label is unsure.
std::vector<Colour> label_colours(const Analysis& analysis) {
  std::vector<Colour> out;
  out.reserve(analysis.labels.size());
  const std::vector<float>& sure = analysis.label_probability;
  for (std::size_t v = 0; v < analysis.labels.size(); ++v) {
    out.push_back(label_colour(analysis.labels[v], sure.empty() ? 1.0F : sure[v]));
  }
  return out;
}

std::string segmented_ply(const Analysis& analysis, const std::vector<Colour>& colours) {
  const Mesh& mesh = analysis.scan.mesh;
  PlyWriter ply(mesh.positions.size());
  ply.positions(in_file(analysis.scan, mesh.positions))
      .column("label", analysis.labels)
      .column("probability", analysis.label_probability)
      .colours(colours);
  if (!mesh.is_cloud()) ply.triangles(mesh.triangles);
  return ply.bytes();
}

std::string garment_ply(const Analysis& analysis, const GarmentAnalysis& garment) {
  return PlyWriter(garment.draped.size())
      .positions(in_file(analysis.scan, garment.draped))
      .coordinates(garment.pattern.flat)
      .triangles(garment.pattern.triangles)
      .bytes();
}

}  // namespace

std::vector<Vec3> in_file(const Scan& scan, const std::vector<Vec3>& p_in_body) {
  std::vector<Vec3> out;
  out.reserve(p_in_body.size());
  for (const Vec3& p : p_in_body) out.emplace_back(scan.file_from_body * p);
  return out;
}

void add_exports(const Analysis& analysis, const std::vector<GarmentTemplate>& templates,
                 std::map<std::string, std::string>& files) {
  const std::vector<Colour> colours = label_colours(analysis);
  files["segmented.ply"] = segmented_ply(analysis, colours);
  files["segmented.glb"] =
      scan_glb({analysis.scan.mesh, analysis.labels, analysis.label_probability, colours,
                analysis.scan.file_from_body});
  for (std::size_t i = 0; i < analysis.garments.size(); ++i) {
    const GarmentAnalysis& garment = analysis.garments[i];
    const std::string number = "-" + std::to_string(i + 1);
    const std::string name = "garment" + number, pattern = "pattern" + number;
    const DressedGarment dressed{garment.template_name, garment.pattern, garment.draped};
    files[name + ".ply"] = garment_ply(analysis, garment);
    files[name + ".glb"] = garment_glb(dressed);
    files[name + ".obj"] = garment_obj(dressed);
    files[pattern + ".json"] = pattern_json(templates[i], garment.dimensions);
    files[pattern + ".svg"] = pattern_svg(templates[i], garment.dimensions);
    files[pattern + ".pdf"] = pattern_tiles(templates[i], garment.dimensions);
    files[pattern + ".dxf"] = pattern_dxf(templates[i], garment.dimensions);
    files[pattern + ".val"] = pattern_val(templates[i], garment.dimensions);
  }
}

}  // namespace regarment
