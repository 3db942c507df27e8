#include "joint/bound_inside.h"

#include <algorithm>

#include "garment/particles.h"
#include "garment/worn_normals.h"

namespace regarment {

OuterGarment outer_garment(const Pattern& pattern, const std::vector<Vec3>& draped) {
  return {particle_positions(pattern, draped), particle_triangles(pattern)};
}

void bound_inside(const std::vector<ClosestPoint>& outer, const std::vector<Vec3>& x,
                  const std::vector<double>& shown, const InsideOptions& options,
                  JointModel& model) {
  model.inside.clear();
  const std::vector<Vec3> normals = worn_normals(model.pattern(), x);
  const double patch = model.scales().patch;
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (shown[i] >= 1) continue;
    const double hidden = (1 - shown[i]) * model.particle_areas()[i] / patch;
    for (const ClosestPoint& garment : outer) {
      const ClosestHit hit = garment.closest(x[i], {options.reach, normals[i], options.min_cosine});
      if (!hit.found() || hit.on_border) continue;
      const Vec3 point = hit.point - options.thickness * hit.normal;
      const double beyond = std::max(0.0, hit.normal.dot(x[i] - point)) / options.robust;
      const double trust = 1 / ((1 + beyond * beyond) * (1 + beyond * beyond));
      model.inside.push_back({static_cast<int>(i), point, hit.normal,
                              hidden * trust / (options.scale * options.scale)});
    }
  }
}

}  // namespace regarment
