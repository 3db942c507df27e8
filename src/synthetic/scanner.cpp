#include "synthetic/scanner.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "base/error.h"
#include "geometry/parallel.h"
#include "synthetic/scanner_scene.h"

namespace regarment {
namespace {

Vec3 top_of(const Mesh& body) {
  Vec3 top = Vec3::Zero();
  for (const Vec3& p : body.positions)
    if (p.y() > top.y()) top = p;
  return top;
}

// Weights of the corners that give the point, or its foot in their plane.
Vec3 weights_in(const std::array<Vec3, 3>& corner, const Vec3& point) {
  const Vec3 along = corner[1] - corner[0], across = corner[2] - corner[0], p = point - corner[0];
  const Vec3 normal = along.cross(across);
  const double squared = normal.squaredNorm();
  if (squared == 0) return {1, 0, 0};
  const double v = p.cross(across).dot(normal) / squared;
  const double w = along.cross(p).dot(normal) / squared;
  return {1 - v - w, v, w};
}

// Adds the points of one sensor with their truth.
class Merging {
 public:
  Merging(const DressedPerson& person, const ScannerScene& scene, const ScannerOptions& options)
      : person_(person), scene_(scene), options_(options), top_(top_of(person.body)) {}

  void add(const SensedPoint& point, Random& random, ScannedPerson& scan) const {
    ColouredPlace place{scene_.owner[point.triangle], point.true_position};
    std::uint32_t particle = ScannedPerson::kNone;
    if (scene_.source[point.triangle] != ScannerScene::kNone) {
      particle = look_up(point, place);
      if (scene_.inner[point.triangle] != 0 || point.flying) particle = ScannedPerson::kNone;
    }
    scan.cloud.positions.push_back(point.position);
    scan.cloud.normals.push_back(point.normal);
    scan.labels.push_back(point.flying ? ScannedPerson::kOutlier : place.owner);
    scan.particle.push_back(particle);
    if (options_.colours.coloured)
      scan.cloud.colours.push_back(colour_of(place, top_, options_.colours, random));
  }

 private:
  // The nearest particle; fills in where on the panel the place lies.
  std::uint32_t look_up(const SensedPoint& point, ColouredPlace& place) const {
    const WornGarment& garment = person_.garments[place.owner - 1U];
    const Pattern& pattern = garment.pattern;
    const Triangle& source = pattern.triangles[scene_.source[point.triangle]];
    std::array<Vec3, 3> corner;
    for (std::size_t k = 0; k < 3; ++k)
      corner[k] = garment.particles[static_cast<std::size_t>(pattern.particle[source[k]])];
    const Vec3 weights = weights_in(corner, point.true_position);
    std::size_t nearest = 0;
    place.down_panel = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      place.down_panel += weights[static_cast<int>(k)] * pattern.flat[source[k]].y();
      if ((corner[k] - point.true_position).squaredNorm() <
          (corner[nearest] - point.true_position).squaredNorm())
        nearest = k;
    }
    return static_cast<std::uint32_t>(pattern.particle[source[nearest]]);
  }

  const DressedPerson& person_;
  const ScannerScene& scene_;
  const ScannerOptions& options_;
  Vec3 top_;
};

std::uint64_t draw_seed(Random& random) {
  return static_cast<std::uint64_t>(random.uniform() * 0x1p53);
}

}  // namespace

void ScannerOptions::check() const {
  rig.check();
  sensing.check();
  colours.check();
  props.check();
}

ScannedPerson scan_person(const DressedPerson& person, const ScannerOptions& options,
                          Random& random) {
  options.check();
  if (person.body.triangles.empty())
    throw InvalidInput("the person to be scanned has no triangles: give a closed surface");
  const double height = top_of(person.body).y();
  ScannerScene scene = make_scene(person);
  add_props(options.props, height, options.rig.columns, options.rig.yaw, random, scene);
  const std::vector<DepthSensor> sensors = make_rig(options.rig, height, scene.positions);
  const std::uint64_t seed = draw_seed(random);
  const Merging merging(person, scene, options);
  std::vector<ScannedPerson> seen(sensors.size());
  parallel_for(sensors.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      Random dice(seed, sensors[i].number);
      for (const SensedPoint& point : sense(scene, sensors[i], options.sensing, dice))
        merging.add(point, dice, seen[i]);
    }
  });
  ScannedPerson scan;
  const auto append = [](auto& to, const auto& from) {
    to.insert(to.end(), from.begin(), from.end());
  };
  for (const ScannedPerson& part : seen) {
    append(scan.cloud.positions, part.cloud.positions);
    append(scan.cloud.normals, part.cloud.normals);
    append(scan.cloud.colours, part.cloud.colours);
    append(scan.labels, part.labels);
    append(scan.particle, part.particle);
  }
  return scan;
}

}  // namespace regarment
