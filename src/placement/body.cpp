#include "placement/body.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "placement/arms.h"
#include "placement/trunk.h"

namespace regarment {
namespace {

constexpr double kLowestCrotch = 0.42;  // of the height: legs that join lower down are in a skirt

double width_of(const TrunkLevel& level) { return level.x_max - level.x_min; }

/// First level, going up, from which the trunk is one piece or suddenly much deeper than the legs.
double find_fork(const Body& body) {
  const int top = std::min(static_cast<int>(0.6 * body.height / body.slice_height),
                           static_cast<int>(body.trunk.size()) - 6);
  const int bottom = static_cast<int>(0.08 * body.height / body.slice_height);
  const auto depth_of = [](const TrunkLevel& level) { return level.z_max - level.z_min; };
  std::vector<double> below;  // depths seen so far
  for (int i = bottom; i < top; ++i) {
    int single = 0, seen = 0, deep = 0;
    double deepest = 1e9;  // of the 10 cm below
    if (below.size() >= 10) deepest = *std::max_element(below.end() - 10, below.end());
    for (int k = 0; k < 5; ++k) {
      const TrunkLevel& level = body.trunk[i + k];
      if (!level.present) continue;
      ++seen;
      single += level.pieces == 1;
      deep += depth_of(level) > 1.5 * deepest;
    }
    if (seen >= 3 && (single >= seen - 1 || deep >= seen - 1)) return i * body.slice_height;
    if (body.trunk[i].present) below.push_back(depth_of(body.trunk[i]));
  }
  return top * body.slice_height;
}

void find_neck(Body& body) {
  const auto index = [&](double share) {
    return std::min(static_cast<int>(share * body.height / body.slice_height),
                    static_cast<int>(body.trunk.size()) - 1);
  };
  int narrowest = -1;
  for (int i = index(0.92); i >= index(0.76); --i)
    if (body.trunk[i].present &&
        (narrowest < 0 || width_of(body.trunk[i]) < width_of(body.trunk[narrowest])))
      narrowest = i;
  if (narrowest < 0) return;
  body.neck = body.trunk[narrowest].y;
  body.shoulder = body.neck;
  for (int i = narrowest; i > index(0.6); --i) {
    body.shoulder = body.trunk[i].y;
    if (body.trunk[i].present && width_of(body.trunk[i]) > 1.6 * width_of(body.trunk[narrowest]))
      break;
  }
}

}  // namespace

const TrunkLevel& Body::level(double y) const {
  const auto i = static_cast<std::ptrdiff_t>(std::floor(y / slice_height));
  return trunk[static_cast<std::size_t>(
      std::clamp<std::ptrdiff_t>(i, 0, static_cast<std::ptrdiff_t>(trunk.size()) - 1))];
}

std::map<std::string, double> Body::landmarks() const {
  std::map<std::string, double> out{{"height", height}};
  const auto add = [&](const char* name, double value) {
    if (value > 0) out[name] = value;
  };
  add(fork_is_garment ? "leg_hem" : "crotch", fork);
  add("left_armpit", armpit[0]);
  add("right_armpit", armpit[1]);
  add("shoulder", shoulder);
  add("neck", neck);
  return out;
}

Body find_body(const SurfaceSamples& samples, double height) {
  Body body;
  body.height = height;
  // Thin scans need thicker slices, or their outlines fall apart.
  const Slices slices = slice_body(samples, std::max(0.01, 1.2 * samples.spacing),
                                   std::max(0.012, 2.2 * samples.spacing));
  const std::vector<bool> in_trunk = follow_trunk(slices, samples, body);
  find_arms(samples, in_trunk, body);
  body.fork = find_fork(body);
  body.fork_is_garment = body.fork < kLowestCrotch * height;
  find_neck(body);
  return body;
}

}  // namespace regarment
