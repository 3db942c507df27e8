#include "report/view3d.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "render/camera.h"
#include "render/display_mesh.h"
#include "render/heat_map.h"
#include "report/deviation.h"
#include "report/text.h"

namespace regarment {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kSteps = 65535.0;  // of a 16-bit coordinate
constexpr std::size_t kMostPoints = 65'536;
constexpr int kColours = 255;  // of the scale; 255 itself says that there is no value

void add_16(std::string& out, std::uint32_t value) {
  out += static_cast<char>(value & 0xffu);
  out += static_cast<char>(value >> 8u & 0xffu);
}

std::string points_of(const DisplayMesh& mesh, const Box& box) {
  const Vec3 size = (box.high - box.low).cwiseMax(1e-9);
  std::string bytes;
  for (const Eigen::Vector3f& p : mesh.positions) {
    for (int k = 0; k < 3; ++k) {
      const double share = std::clamp((double(p[k]) - box.low[k]) / size[k], 0.0, 1.0);
      add_16(bytes, static_cast<std::uint32_t>(std::lround(share * kSteps)));
    }
  }
  return base64(bytes);
}

std::string normals_of(const DisplayMesh& mesh) {
  std::string bytes;
  for (const Eigen::Vector3f& n : mesh.normals) {
    for (int k = 0; k < 3; ++k) {
      const long value = std::lround(127.0 * std::clamp(double(n[k]), -1.0, 1.0));
      bytes += static_cast<char>(static_cast<signed char>(value));
    }
  }
  return base64(bytes);
}

std::string triangles_of(const DisplayMesh& mesh) {
  std::string bytes;
  for (const Triangle& triangle : mesh.triangles) {
    for (const std::uint32_t corner : triangle) add_16(bytes, corner);
  }
  return base64(bytes);
}

Json mesh_json(const DisplayMesh& mesh, const Box& box) {
  return {{"points", points_of(mesh, box)},
          {"normals", normals_of(mesh)},
          {"triangles", triangles_of(mesh)}};
}

std::string labels_of(const DisplayMesh& mesh, const std::vector<std::uint8_t>& labels) {
  std::string bytes;
  for (const std::uint32_t from : mesh.source_vertex) bytes += static_cast<char>(labels[from]);
  return base64(bytes);
}

std::string values_of(const DisplayMesh& mesh, const std::vector<float>& values, double range) {
  std::string bytes;
  for (const std::uint32_t from : mesh.source_vertex) {
    const double value = double(values[from]);
    const double share = std::clamp((value / range + 1.0) / 2.0, 0.0, 1.0);
    bytes += static_cast<char>(
        std::isnan(value) ? kColours : static_cast<int>(std::lround(share * (kColours - 1))));
  }
  return base64(bytes);
}

std::string scale_of() {
  const ColourScale scale = symmetric_scale(1.0);
  std::string bytes;
  for (int i = 0; i < kColours; ++i) {
    const Colour c = scale.colour(2.0 * i / (kColours - 1) - 1.0);
    for (const auto part : c) bytes += static_cast<char>(part);
  }
  return base64(bytes);
}

Json colour_json(Colour colour) {
  Json out = Json::array();
  for (const auto part : colour) out.push_back(int(part));
  return out;
}

Json vector_json(const Vec3& v) {
  return {rounded(v.x(), 5), rounded(v.y(), 5), rounded(v.z(), 5)};
}

Box box_of(const std::vector<DisplayMesh>& meshes) {
  Box box;
  for (const DisplayMesh& mesh : meshes) {
    for (const Eigen::Vector3f& p : mesh.positions) box.add(p.cast<double>());
  }
  return box;
}

// The scan first, then the garments; everything relative to the body's origin.
std::vector<DisplayMesh> display_meshes(const Analysis& analysis) {
  std::vector<DisplayMesh> out = {make_display_mesh(
      analysis.scan.mesh, analysis.labels, analysis.scan.outlier, Vec3::Zero(), kViewElements)};
  for (const GarmentAnalysis& garment : analysis.garments) {
    out.push_back(make_display_mesh(garment.draped, garment.pattern.triangles, Vec3::Zero()));
  }
  return out;
}

}  // namespace

std::string view_json(const Analysis& analysis) {
  const std::vector<DisplayMesh> meshes = display_meshes(analysis);
  for (const DisplayMesh& mesh : meshes) {
    if (mesh.positions.size() > kMostPoints) return {};
  }
  const Box box = box_of(meshes);
  if (meshes.front().positions.empty() || box.empty()) return {};
  const std::vector<float> values = merged_deviation(analysis);
  const double range = deviation_range(values);
  Json palette = Json::array({colour_json(garment_colour(0))}), garments = Json::array();
  for (std::size_t i = 0; i < analysis.garments.size(); ++i) {
    palette.push_back(colour_json(garment_colour(analysis.garments[i].layer)));
    if (meshes[i + 1].positions.empty()) continue;
    garments.push_back(mesh_json(meshes[i + 1], box));
    garments.back()["label"] = i + 1;
  }
  Json scan = mesh_json(meshes.front(), box);
  scan["labels"] = labels_of(meshes.front(), analysis.labels);
  scan["values"] = values.empty() ? "" : values_of(meshes.front(), values, range);
  return Json{{"low", vector_json(box.low)},
              {"size", vector_json(box.high - box.low)},
              {"palette", palette},
              {"scale", values.empty() ? "" : scale_of()},
              {"scale_mm", rounded_significant(range * 1000.0, 6)},
              {"scan", scan},
              {"garments", garments}}
      .dump();
}

void check_view(const std::string& json) {
  const auto fits = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
           std::string_view("+/={}[]:,\"._-").find(c) != std::string_view::npos;
  };
  if (std::all_of(json.begin(), json.end(), fits) && (json.empty() || Json::accept(json))) return;
  throw ReadError("pictures/view.json: is not what 'regarment fit' writes; run it again");
}

}  // namespace regarment
