#include "synthetic/reconstruct.h"

#include <algorithm>

#include "geometry/parallel.h"
#include "geometry/point_tree.h"
#include "synthetic/reconstruct_field.h"
#include "synthetic/reconstruct_surface.h"
#include "synthetic/scanner_options.h"

namespace regarment {
namespace {

constexpr std::size_t kVoters = 8;
constexpr std::size_t kGrain = 4096;  // vertices a thread takes at once

// Gives the vertices of a surface what the points near them say.
class Labelling {
 public:
  Labelling(const ScannedPerson& scan, double reach, SurfacedPerson& person)
      : scan_(scan), reach_(reach), tree_(scan.cloud.positions), person_(person) {}

  void run() {
    const std::size_t count = person_.mesh.positions.size();
    person_.labels.assign(count, ScannedPerson::kOutlier);
    if (!scan_.cloud.colours.empty()) person_.mesh.colours.assign(count, {});
    parallel_for(count, kGrain, [&](std::size_t begin, std::size_t end) {
      for (std::size_t v = begin; v < end; ++v) label(v);
    });
  }

 private:
  void label(std::size_t v) {
    Mesh& mesh = person_.mesh;
    std::array<PointNeighbour, kVoters> near;
    std::size_t count = tree_.nearest(mesh.positions[v], near, reach_);
    if (count > 0)
      person_.labels[v] = vote({near.data(), count});
    else
      count = tree_.nearest(mesh.positions[v], {near.data(), 1});
    if (!mesh.colours.empty()) mesh.colours[v] = mean_colour({near.data(), count});
  }

  std::uint8_t vote(std::span<const PointNeighbour> near) const {
    std::array<int, 256> votes{};
    for (const PointNeighbour& n : near) ++votes[scan_.labels[n.index]];
    return static_cast<std::uint8_t>(std::max_element(votes.begin(), votes.end()) - votes.begin());
  }

  Colour mean_colour(std::span<const PointNeighbour> near) const {
    Colour mean{};
    for (std::size_t c = 0; c < mean.size(); ++c) {
      std::size_t sum = 0;
      for (const PointNeighbour& n : near) sum += scan_.cloud.colours[n.index][c];
      mean[c] = static_cast<std::uint8_t>(sum / near.size());
    }
    return mean;
  }

  const ScannedPerson& scan_;
  double reach_;
  PointTree tree_;
  SurfacedPerson& person_;
};

Mesh surface_of(const ScannedPerson& scan, const ReconstructOptions& options) {
  options.check();
  return zero_surface(distance_field(scan.cloud.positions, scan.cloud.normals, options.cell));
}

SurfacedPerson labelled(Mesh mesh, const ScannedPerson& scan, const ReconstructOptions& options) {
  SurfacedPerson person;
  person.mesh = std::move(mesh);
  drop_small_pieces(options.least_piece, person.mesh);
  Labelling(scan, options.invented, person).run();
  return person;
}

}  // namespace

void ReconstructOptions::check() const {
  check_scanner_value("cell", cell, 0.002, 0.05);
  check_scanner_value("invented", invented, 0.001, 0.2);
  check_scanner_value("open_reach", open_reach, 0.001, 0.2);
  check_scanner_value("least_piece", least_piece, 0, 1e6);
}

SurfacedPerson reconstruct_closed(const ScannedPerson& scan, const ReconstructOptions& options) {
  return labelled(surface_of(scan, options), scan, options);
}

SurfacedPerson reconstruct_open(const ScannedPerson& scan, const ReconstructOptions& options) {
  Mesh mesh = surface_of(scan, options);
  drop_far_triangles(scan.cloud.positions, options.open_reach, mesh);
  for (const FlatCut& cut : options.cuts) cut_flat(cut, mesh);
  return labelled(std::move(mesh), scan, options);
}

}  // namespace regarment
