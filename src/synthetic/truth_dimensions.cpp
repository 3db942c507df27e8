#include "synthetic/truth_dimensions.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "synthetic/truth_lines.h"

namespace regarment {
namespace {

constexpr double kBeside = 0.012;   // m from a line within which particles stand for it
constexpr double kSeenShare = 0.5;  // of an edge that has to be seen

double mean_stretch(const GarmentTemplate& garment, const WornGarment& worn,
                    const std::string& name) {
  const std::vector<PanelLine> lines =
      dimension_lines(garment, worn.pattern, worn.dimensions, name);
  double sum = 0;
  for (const PanelLine& line : lines) sum += stretch_along(worn.pattern, worn.particles, line);
  return sum / static_cast<double>(lines.size());
}

// Seen, or next to a particle that is: along an edge a scanner loses a thin strip.
std::vector<std::uint8_t> grown(const Pattern& pattern, std::span<const std::uint8_t> seen) {
  std::vector<std::uint8_t> out(seen.begin(), seen.end());
  for (const Triangle& t : pattern.triangles) {
    bool any = false;
    for (const auto v : t) any |= seen[static_cast<std::size_t>(pattern.particle[v])] != 0;
    for (const auto v : t) {
      if (any) out[static_cast<std::size_t>(pattern.particle[v])] = 1;
    }
  }
  return out;
}

bool half_seen(const std::vector<int>& particles, const std::vector<std::uint8_t>& seen) {
  const auto count = std::count_if(particles.begin(), particles.end(),
                                   [&](int p) { return seen[static_cast<std::size_t>(p)] != 0; });
  return static_cast<double>(count) >= kSeenShare * static_cast<double>(particles.size());
}

std::vector<int> edge_particles(const Pattern& pattern, const std::string& name) {
  std::vector<int> out;
  for (const int v : edge_named(pattern, name).vertices) {
    out.push_back(pattern.particle[static_cast<std::size_t>(v)]);
  }
  return out;
}

// The pieces of cloth that have to be seen for an observation of a dimension.
std::vector<std::vector<int>> needed(const GarmentTemplate& garment, const WornGarment& worn,
                                     const Observation& observation, const std::string& name) {
  if (observation.kind == Observation::Kind::Girth) {
    return {edge_particles(worn.pattern, observation.edge)};
  }
  if (observation.kind == Observation::Kind::Path) {
    return {edge_particles(worn.pattern, observation.edge),
            edge_particles(worn.pattern, observation.to_edge)};
  }
  std::vector<int> all;
  for (const PanelLine& line : dimension_lines(garment, worn.pattern, worn.dimensions, name)) {
    const std::vector<int> some = particles_beside(worn.pattern, line, kBeside);
    all.insert(all.end(), some.begin(), some.end());
  }
  return {all};
}

bool is_seen(const GarmentTemplate& garment, const WornGarment& worn, const std::string& name,
             const std::vector<std::uint8_t>& seen) {
  for (const Observation& observation : garment.observations()) {
    if (!garment.gives(observation.equals, name, worn.dimensions)) continue;
    const auto pieces = needed(garment, worn, observation, name);
    const bool all = std::all_of(pieces.begin(), pieces.end(),
                                 [&](const auto& piece) { return half_seen(piece, seen); });
    if (all) return true;
  }
  return false;
}

}  // namespace

Dimensions worn_dimensions(const GarmentTemplate& garment, const WornGarment& worn) {
  Dimensions out;
  for (const Dimension& dimension : garment.dimensions()) {
    const std::string& name = dimension.name;
    out[name] = worn.dimensions.at(name) * mean_stretch(garment, worn, name);
  }
  return out;
}

std::vector<std::string> hidden_dimensions(const GarmentTemplate& garment, const WornGarment& worn,
                                           std::span<const std::uint8_t> seen) {
  if (seen.size() != static_cast<std::size_t>(worn.pattern.particle_count)) {
    throw InvalidInput("hidden_dimensions: " + std::to_string(seen.size()) + " flags for " +
                       std::to_string(worn.pattern.particle_count) + " particles");
  }
  const std::vector<std::uint8_t> near = grown(worn.pattern, seen);
  std::vector<std::string> out;
  for (const Dimension& dimension : garment.dimensions()) {
    if (!is_seen(garment, worn, dimension.name, near)) out.push_back(dimension.name);
  }
  return out;
}

}  // namespace regarment
