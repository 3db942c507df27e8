#include "exports/garment_glb.h"

#include <algorithm>
#include <cmath>

#include <nlohmann/json.hpp>

#include "base/error.h"
#include "exports/glb_writer.h"
#include "garment/particles.h"
#include "garment/springs.h"

namespace regarment {
namespace {

using Json = nlohmann::ordered_json;

/// Of the sewn surface, the same for all vertices of a particle.
std::vector<Vec3> normals_of(const DressedGarment& garment) {
  const Pattern& pattern = garment.pattern;
  std::vector<Vec3> of_particle(static_cast<std::size_t>(pattern.particle_count), Vec3::Zero());
  const auto particle = [&](std::uint32_t v) {
    return static_cast<std::size_t>(pattern.particle[v]);
  };
  for (const auto& [a, b, c] : pattern.triangles) {
    const std::vector<Vec3>& p = garment.draped;
    const Vec3 area = (p[b] - p[a]).cross(p[c] - p[a]);
    for (const std::uint32_t v : {a, b, c}) of_particle[particle(v)] += area;
  }
  std::vector<Vec3> out;
  out.reserve(pattern.flat.size());
  for (std::uint32_t v = 0; v < pattern.flat.size(); ++v) {
    const Vec3& sum = of_particle[particle(v)];
    out.push_back(sum.norm() > 1e-15 ? Vec3(sum.normalized()) : Vec3::UnitY());
  }
  return out;
}

std::vector<float> masses_of(const Pattern& pattern) {
  const std::vector<double> areas = triangle_areas(pattern);
  std::vector<double> masses(pattern.flat.size(), 0.0);
  for (std::size_t t = 0; t < areas.size(); ++t)
    for (const std::uint32_t v : pattern.triangles[t]) masses[v] += kExportDensity * areas[t] / 3.0;
  return {masses.begin(), masses.end()};
}

Json spring_json(const Pattern& pattern, GlbWriter& glb) {
  std::vector<std::uint32_t> pairs;
  std::vector<float> lengths;
  for (const Spring& spring : springs(pattern)) {
    pairs.push_back(static_cast<std::uint32_t>(spring.particle_a));
    pairs.push_back(static_cast<std::uint32_t>(spring.particle_b));
    lengths.push_back(static_cast<float>(spring.rest_length));
  }
  const int of_pairs = glb.indices(pairs), of_lengths = glb.scalars(lengths);
  return {{"count", lengths.size()},
          {"particles_accessor", of_pairs},
          {"rest_lengths_m_accessor", of_lengths}};
}

Json material(const std::string& name) {
  return {{"name", name},
          {"doubleSided", true},
          {"pbrMetallicRoughness",
           {{"baseColorFactor", {0.55, 0.62, 0.72, 1.0}},
            {"metallicFactor", 0.0},
            {"roughnessFactor", 0.9}}}};
}

std::vector<std::uint32_t> triangles_of(const Pattern& pattern, int panel) {
  std::vector<std::uint32_t> out;
  for (const Triangle& t : pattern.triangles)
    if (pattern.panel[t[0]] == panel) out.insert(out.end(), t.begin(), t.end());
  return out;
}

}  // namespace

std::string garment_glb(const DressedGarment& garment) {
  const Pattern& pattern = garment.pattern;
  if (garment.draped.size() != pattern.flat.size() || pattern.flat.empty())
    throw InvalidInput("a garment needs one draped position per vertex of its pattern");
  GlbWriter glb;
  Json attributes = {{"POSITION", glb.positions(garment.draped)},
                     {"NORMAL", glb.vectors(normals_of(garment))},
                     {"TEXCOORD_0", glb.coordinates(pattern.flat)}};
  attributes["_PARTICLE"] =
      glb.scalars(std::vector<float>(pattern.particle.begin(), pattern.particle.end()));
  attributes["_MASS"] = glb.scalars(masses_of(pattern));
  Json primitives = Json::array(), materials = Json::array();
  for (std::size_t p = 0; p < pattern.panel_names.size(); ++p) {
    primitives.push_back({{"attributes", attributes},
                          {"indices", glb.indices(triangles_of(pattern, static_cast<int>(p)))},
                          {"material", p}});
    materials.push_back(material(pattern.panel_names[p]));
  }
  const Json cloth = {{"particles", pattern.particle_count},
                      {"area_density_kg_m2", kExportDensity},
                      {"springs", spring_json(pattern, glb)}};
  const Json document = {
      {"asset", {{"version", "2.0"}, {"generator", "regarment"}}},
      {"scene", 0},
      {"scenes", {{{"nodes", {0}}}}},
      {"nodes", {{{"mesh", 0}, {"name", garment.name}}}},
      {"meshes",
       {{{"name", garment.name}, {"primitives", primitives}, {"extras", {{"cloth", cloth}}}}}},
      {"materials", materials}};
  return glb.bytes(document.dump());
}

}  // namespace regarment
