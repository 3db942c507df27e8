#pragma once

#include "analysis/analysis.h"
#include "garment/find_template.h"

// An analysis made by hand: a straight column 1.7 m high stands for the person, a skirt pattern
// rolled round it for the garment. The file is in millimetres, z up, shifted.

namespace regarment {

inline Eigen::Affine3d millimetres_z_up() {
  Eigen::Matrix3d turn;
  turn << 1, 0, 0, 0, 0, -1, 0, 1, 0;  // body y (up) becomes file z
  Eigen::Affine3d file_from_body = Eigen::Affine3d::Identity();
  file_from_body.linear() = 1000.0 * turn;
  file_from_body.translation() = Vec3(100.0, 200.0, 300.0);
  return file_from_body;
}

/// A column of `rings` rings of `sides` vertices, open at both ends.
inline Mesh column(int rings, int sides, double radius, double height) {
  Mesh mesh;
  for (int r = 0; r < rings; ++r) {
    for (int s = 0; s < sides; ++s) {
      const double angle = 2.0 * M_PI * s / sides;
      const Vec3 out(std::cos(angle), 0.0, std::sin(angle));
      mesh.positions.emplace_back(radius * out + Vec3(0.0, height * r / (rings - 1), 0.0));
      mesh.normals.push_back(out);
    }
  }
  const auto at = [&](int r, int s) { return static_cast<std::uint32_t>(r * sides + s % sides); };
  for (int r = 0; r + 1 < rings; ++r) {
    for (int s = 0; s < sides; ++s) {
      mesh.triangles.push_back({at(r, s), at(r + 1, s), at(r, s + 1)});
      mesh.triangles.push_back({at(r, s + 1), at(r + 1, s), at(r + 1, s + 1)});
    }
  }
  return mesh;
}

inline Scan column_scan() {
  Scan scan;
  scan.facts.file = "column.ply";
  scan.facts.sha256 = std::string(64, '0');
  scan.facts.units = "mm";
  scan.facts.up = "+z";
  scan.facts.front = "-y";
  scan.facts.height = 1.7;
  scan.facts.noise = 0.0005;
  scan.facts.spacing = 0.02;
  scan.mesh = column(35, 24, 0.15, 1.7);
  scan.outlier.assign(scan.mesh.positions.size(), 0);
  scan.file_from_body = millimetres_z_up();
  return scan;
}

inline GarmentAnalysis rolled_skirt(const GarmentTemplate& skirt) {
  GarmentAnalysis garment;
  garment.template_name = skirt.name();
  garment.dimensions = skirt.typical();
  garment.pattern = make_pattern(skirt, garment.dimensions, 0.05);
  for (std::size_t i = 0; i < garment.pattern.flat.size(); ++i) {
    const Vec2& flat = garment.pattern.flat[i];
    const double side = garment.pattern.panel_is_front[garment.pattern.panel[i]] ? 1.0 : -1.0;
    garment.draped.emplace_back(flat.x(), 1.0 - flat.y(), 0.18 * side);
    garment.placed.emplace_back(flat.x(), 1.0 - flat.y(), 0.25 * side);
  }
  for (const Dimension& dimension : skirt.dimensions()) {
    Measurement m;
    m.name = dimension.name;
    m.code = dimension.code;
    m.flat = garment.dimensions.at(dimension.name);
    m.low = m.flat - 0.01;
    m.high = m.flat + 0.01;
    garment.measurements.push_back(m);
  }
  garment.edges = {{"hem",
                    {Vec3(0.2, 0.5, 0.0), Vec3(0.0, 0.5, 0.2), Vec3(-0.2, 0.5, 0.0)},
                    0.002,
                    0.9,
                    "step"}};
  return garment;
}

/// The labels alternate, so that an order that is not kept shows.
inline Analysis column_analysis(const GarmentTemplate& skirt) {
  Analysis analysis;
  analysis.scan = column_scan();
  analysis.method = "direct";
  analysis.garments = {rolled_skirt(skirt)};
  for (std::size_t i = 0; i < analysis.scan.mesh.positions.size(); ++i) {
    analysis.labels.push_back(i % 3 == 0 ? 1 : 0);
    analysis.label_probability.push_back(i % 2 == 0 ? 0.6F : 0.9F);
  }
  analysis.cap.assign(analysis.scan.mesh.triangles.size(), 0);
  analysis.cap.front() = 1;
  analysis.landmarks = {{"waist", 1.05}};
  analysis.warnings = {"made by hand"};
  analysis.times = {{"measure", 0.25}};
  return analysis;
}

}  // namespace regarment
