#pragma once

#include "report/page.h"
#include "report/result.h"

// Results made by hand, for tests of everything that is made from a result.

namespace regarment {

/// A skirt with truth and tolerances: length passes, width fails high, waist is not judged, hip is
/// not observable.
inline ResultGarment skirt_result() {
  ResultGarment skirt;
  skirt.template_name = "skirt";
  skirt.title = "Skirt";
  const auto add = [&](const char* name, const char* code, const char* title, bool circumference,
                       double value, double half_width) -> ResultMeasurement& {
    ResultMeasurement m;
    m.name = name;
    m.code = code;
    m.title = title;
    m.definition = std::string("What ") + title + " is, exactly.";
    m.how_to_measure = "Lay the garment flat and measure from edge to edge.";
    m.circumference = circumference;
    m.value_cm = value;
    m.low_cm = value - half_width;
    m.high_cm = value + half_width;
    skirt.measurements.push_back(m);
    return skirt.measurements.back();
  };
  auto& length = add("length", "S01", "Length", false, 54.3, 0.8);
  length.truth_cm = 54.0;
  length.tol_minus_cm = 0.5;
  length.tol_plus_cm = 0.5;
  auto& width = add("width", "S02", "Sweep", true, 112.5, 1.5);
  width.worn_cm = 112.4;
  width.truth_cm = 110.0;
  width.tol_minus_cm = 1.0;
  width.tol_plus_cm = 2.0;
  auto& waist = add("waist", "S03", "Waist", true, 78.4, 1.2);
  waist.worn_cm = 80.1;
  waist.truth_cm = 78.0;
  waist.rivals = {{{"waist"}, 74.25, 0.3}, {{"waist"}, 82.5, 0.125}};
  add("hip", "S04", "Hip", true, 96.0, 10.0).observable = false;
  skirt.silhouette = 5.25;
  skirt.edges = {{"waist", "step", 2.4, 0.93, 80.1, 101.5, {{105.75, 0.3}, {98.0, 0.125}}},
                 {"hem", "drop", 0.8, 1.0, 112.4, 47.9}};
  skirt.edges[0].flat_cm = 78.4;
  skirt.edges[0].beside_cm = 75.9;
  skirt.edges[1].flat_cm = 112.5;
  skirt.asymmetry = {{"length", "left_right", -1.5, 0.75}};
  skirt.mean_distance_m = 0.0012;
  skirt.mean_stretch = 1.004;
  skirt.vertices_labelled = 14000;
  return skirt;
}

inline Result example_result() {
  Result r;
  r.version = "0.1.0";
  r.method = "direct";
  r.command = "regarment fit skirt-1.mesh.ply --garment skirt --method direct --seed 1 --out DIR";
  r.settings = {{"method", "direct"}, {"seed", "1"}, {"units", "auto"}};
  r.fabric = "jersey";
  r.scan.file = "skirt-1.mesh.ply";
  r.scan.sha256 = std::string(64, 'a');
  r.scan.units = "mm";
  r.scan.up = "+z";
  r.scan.front = "-y";
  r.scan.front_confidence = 0.97;
  r.scan.noise_mm = 0.6;
  r.scan.spacing_mm = 4.1;
  r.scan.height_cm = 171.2;
  r.scan.vertices = 43333;
  r.scan.triangles = 86662;
  r.scan.caps = 812;
  r.garments = {skirt_result()};
  r.person = 29333;
  r.garment_counts = {14000};
  r.unsure = 700;
  r.landmarks_cm = {{"crotch", 78.2}, {"waist", 104.0}};
  r.warnings = {"the scan closes the hem with invented surface; it was left out"};
  r.timing_s = {{"read", 0.081}, {"measure", 0.402}, {"total", 0.483}};
  return r;
}

/// Parts without pictures and with an empty sketch per garment.
inline PageParts bare_parts(const Result& result) {
  PageParts parts;
  parts.evaluations.resize(result.garments.size());
  parts.sketches.assign(result.garments.size(), "<svg xmlns=\"http://www.w3.org/2000/svg\"></svg>");
  return parts;
}

/// A page without its sizes for programs: data, which runs nothing; the addresses of schema.org in
/// it are names.
inline std::string without_sizes(std::string page) {
  const auto begin = page.find("<script type=\"application/ld+json\">");
  const auto end = page.find("</script>", begin) + std::string("</script>").size();
  return page.erase(begin, end - begin);
}

}  // namespace regarment
