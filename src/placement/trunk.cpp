#include "placement/trunk.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"

namespace regarment {
namespace {

constexpr double kGrowth = 0.5;       // m of width a side may gain per m of height
constexpr double kSlack = 0.012;      // m a side may jump from one slice to the next
constexpr std::size_t kLookBack = 4;  // slices below that a side's reach is compared with
constexpr double kNarrowing = 0.005;  // m per slice by which the search for the trunk narrows
constexpr int kArmMemory = 8;         // slices an arm may be out of sight before it joins
constexpr double kArmAlone = 0.08;    // m that only an arm adds, whatever was seen beside the trunk
constexpr int kArmLevels = 4;         // slices an arm must stay joined
constexpr double kLongestGap = 0.10;  // m of missing slices that are bridged

/// Share of the cluster's width that lies within [x_min, x_max].
double overlap(const SliceCluster& c, double x_min, double x_max) {
  const double shared = std::min(c.x_max, x_max) - std::max(c.x_min, x_min);
  return shared / std::max(c.width(), 0.005);
}

void include(const SliceCluster& c, TrunkLevel& level) {
  if (!level.present) {
    level.x_min = c.x_min, level.x_max = c.x_max, level.z_min = c.z_min, level.z_max = c.z_max;
    level.present = true;
    return;
  }
  level.x_min = std::min(level.x_min, c.x_min), level.x_max = std::max(level.x_max, c.x_max);
  level.z_min = std::min(level.z_min, c.z_min), level.z_max = std::max(level.z_max, c.z_max);
}

/// Does the cluster lie mostly over one of those of the slice before? A fold of a skirt that hangs
/// free lower down does; a hand beside it does not.
bool continues(const SliceCluster& c, const std::vector<const SliceCluster*>& before) {
  const auto share = [](double low, double high, double other_low, double other_high) {
    const double shared = std::min(high, other_high) - std::max(low, other_low);
    return shared / std::max(high - low, 0.005);
  };
  return std::any_of(before.begin(), before.end(), [&](const SliceCluster* b) {
    return share(c.x_min, c.x_max, b->x_min - 0.005, b->x_max + 0.005) > 0.6 &&
           share(c.z_min, c.z_max, b->z_min - 0.005, b->z_max + 0.005) > 0.6;
  });
}

/// Clusters lying mostly within [x_min, x_max] or continuing those of the slice `before`, joined;
/// their number along x in `pieces`.
TrunkLevel gather(const std::vector<SliceCluster>& clusters, double x_min, double x_max, double y,
                  const std::vector<const SliceCluster*>& before,
                  std::vector<const SliceCluster*>& members) {
  TrunkLevel level;
  level.y = y;
  double total = 0;
  for (const SliceCluster& c : clusters) {
    const bool covers = c.x_min < x_min + 0.02 && c.x_max > x_max - 0.02;
    if (overlap(c, x_min, x_max) < 0.6 && !covers &&
        std::min(c.x_max, x_max) - std::max(c.x_min, x_min) < 0.5 * (x_max - x_min) &&
        !continues(c, before))
      continue;
    include(c, level);
    members.push_back(&c);
    total += c.area;
  }
  // Pieces side by side: sort by x and count the gaps between clusters that matter.
  std::vector<const SliceCluster*> by_x;
  for (const SliceCluster* c : members)
    if (c->area > 0.05 * total) by_x.push_back(c);
  std::sort(by_x.begin(), by_x.end(), [](auto* a, auto* b) { return a->x_min < b->x_min; });
  double reach = -1e9;
  for (const SliceCluster* c : by_x) {
    if (c->x_min > reach) ++level.pieces;
    reach = std::max(reach, c->x_max);
  }
  return level;
}

struct Follower {
  const Slices& slices;
  const SurfaceSamples& samples;
  Body& body;
  std::vector<bool>& in_trunk;

  /// Walks from level `from` in direction `step` (+1 up, -1 down), `previous` being its neighbour.
  void walk(int from, int step, const TrunkLevel& previous, bool find_armpits);
  void take(int index, const std::vector<const SliceCluster*>& members);
};

void Follower::take(int index, const std::vector<const SliceCluster*>& members) {
  const TrunkLevel& level = body.trunk[index];
  for (const SliceCluster* c : members)
    for (int s : c->samples) {
      const double x = samples.positions[s].x();
      if (x >= level.x_min - 1e-9 && x <= level.x_max + 1e-9) in_trunk[s] = true;
    }
}

/// Depth of the members within the trunk's width alone.
void trim_depth(const std::vector<const SliceCluster*>& members, const SurfaceSamples& samples,
                TrunkLevel& level) {
  level.z_min = 1e9, level.z_max = -1e9;
  for (const SliceCluster* c : members)
    for (int s : c->samples) {
      const Vec3& p = samples.positions[s];
      if (p.x() < level.x_min || p.x() > level.x_max) continue;
      level.z_min = std::min(level.z_min, p.z()), level.z_max = std::max(level.z_max, p.z());
    }
}

/// Widest piece of a level that lies wholly beyond the trunk on one side, m; 0 when there is none.
double beside(const std::vector<SliceCluster>& clusters, const TrunkLevel& trunk, int side) {
  double widest = 0;
  for (const SliceCluster& c : clusters) {
    const bool beyond = side == 0 ? c.x_min > trunk.x_max : c.x_max < trunk.x_min;
    if (beyond && std::max(c.width(), c.depth()) > 0.03) widest = std::max(widest, c.width());
  }
  return widest;
}

/// How far one side of the trunk reaches, level by level, since it last jumped at a hem.
struct Side {
  double sign = 1;
  std::vector<double> reach;  // sign * x, m
  int last_free = -1000;      // last level with something free beside the trunk
  int joined = 0;             // levels in a row cut off because an arm joined
  bool armpit_known = false;

  /// What the side may reach at the next level: a little more than just below, and not much more
  /// than a hand's breadth below.
  double limit(double slice_height) const {
    const double back = reach[reach.size() > kLookBack ? reach.size() - kLookBack - 1 : 0];
    const double rows = static_cast<double>(std::min<std::size_t>(reach.size(), kLookBack + 1));
    return std::min(reach.back() + kGrowth * slice_height + kSlack,
                    back + kGrowth * slice_height * rows + kSlack);
  }
};

void Follower::walk(int from, int step, const TrunkLevel& previous, bool find_armpits) {
  const double h = slices.height;
  std::array<Side, 2> sides;
  sides[1].sign = -1;
  sides[0].reach = {previous.x_max};
  sides[1].reach = {-previous.x_min};
  double x_min = previous.x_min, x_max = previous.x_max;  // where the trunk is looked for
  std::vector<const SliceCluster*>
      before;  // going down alone: arms never hang on to a skirt's folds
  int missing = 0;
  for (int i = from; i >= 0 && i < static_cast<int>(slices.levels.size()); i += step) {
    std::vector<const SliceCluster*> members;
    TrunkLevel level = gather(slices.levels[i], x_min, x_max, (i + 0.5) * h, before, members);
    if (!level.present) {
      if (++missing * h > kLongestGap) break;
      continue;
    }
    missing = 0;
    for (int s = 0; s < 2; ++s) {
      Side& side = sides[s];
      double& edge = s == 0 ? level.x_max : level.x_min;
      if (side.armpit_known) {  // the shoulder over the armpit belongs to the arm beyond its plane
        const double root = side.sign * body.armpit_x[s];
        (s == 0 ? level.left_arm_joined : level.right_arm_joined) = side.sign * edge > root;
        edge = side.sign * std::min(side.sign * edge, root);
        continue;
      }
      const double reach = side.sign * edge, limit = side.limit(h);
      const double over = reach - side.reach.back();
      const bool free = beside(slices.levels[i], level, s) > 0;
      // A hem widens the trunk while the arm still hangs free beside it or far above; an arm that
      // joins was free just below, or adds more than any hem.
      const bool arm = !free && i - side.last_free <= kArmMemory;
      if (free) side.last_free = i;
      if (reach <= limit) {
        side.reach.push_back(reach);
        side.joined = 0;
        continue;
      }
      if (over <= kArmAlone && !arm) {
        side.reach.assign(1, reach);
        side.joined = 0;
        continue;
      }
      (s == 0 ? level.left_arm_joined : level.right_arm_joined) = true;
      const std::size_t back =
          side.reach.size() > kLookBack ? side.reach.size() - kLookBack - 1 : 0;
      edge = side.sign * std::min(side.reach.back(), side.reach[back] + kSlack);
      side.reach.push_back(side.sign * edge);
      if (++side.joined < kArmLevels || side.armpit_known || !find_armpits) continue;
      side.armpit_known = true;
      body.armpit[s] = (i - kArmLevels + 1) * h;
      body.armpit_x[s] = edge;
    }
    if (level.left_arm_joined || level.right_arm_joined) trim_depth(members, samples, level);
    body.trunk[i] = level;
    take(i, members);
    if (step < 0) before = members;
    // A hole in the scan must not lose a leg: the search narrows slowly.
    x_min = std::min(level.x_min, x_min + kNarrowing);
    x_max = std::max(level.x_max, x_max - kNarrowing);
  }
}

/// The narrowest level between hips and chest: arms hang free of it in most poses.
int start_level(const Slices& slices, double height, double middle_x) {
  const int low = static_cast<int>(0.52 * height / slices.height);
  const int high = static_cast<int>(0.66 * height / slices.height);
  int best = -1;
  double best_width = 1e9;
  std::vector<const SliceCluster*> members;
  for (int i = low; i <= high && i < static_cast<int>(slices.levels.size()); ++i) {
    for (const SliceCluster& c : slices.levels[i]) {
      if (c.x_min > middle_x || c.x_max < middle_x) continue;  // an arm beside the trunk
      members.clear();
      const TrunkLevel level = gather(slices.levels[i], c.x_min, c.x_max, 0, {}, members);
      const double width = level.x_max - level.x_min, depth = level.z_max - level.z_min;
      if (width < 0.08 * height || depth < 0.05 * height || width >= best_width) continue;
      best_width = width;
      best = i;
    }
  }
  return best;
}

double weighted_middle(const SurfaceSamples& samples, double y_low, double y_high) {
  std::vector<double> x;
  for (const Vec3& p : samples.positions)
    if (p.y() > y_low && p.y() < y_high) x.push_back(p.x());
  if (x.empty()) return 0;
  std::nth_element(x.begin(), x.begin() + static_cast<std::ptrdiff_t>(x.size() / 2), x.end());
  return x[x.size() / 2];
}

}  // namespace

std::vector<bool> follow_trunk(const Slices& slices, const SurfaceSamples& samples, Body& body) {
  std::vector<bool> in_trunk(samples.size(), false);
  body.slice_height = slices.height;
  body.trunk.assign(slices.levels.size(), {});
  for (std::size_t i = 0; i < body.trunk.size(); ++i)
    body.trunk[i].y = (static_cast<double>(i) + 0.5) * slices.height;
  const double middle = weighted_middle(samples, 0.52 * body.height, 0.66 * body.height);
  const int start = start_level(slices, body.height, middle);
  if (start < 0)
    throw NoPersonError(
        "the scan shows no trunk at half its height; scan a standing person, or set --up and "
        "--units");
  double x_min = 1e9, x_max = -1e9;
  for (const SliceCluster& c : slices.levels[start])
    if (c.x_min <= middle && c.x_max >= middle)
      x_min = std::min(x_min, c.x_min), x_max = std::max(x_max, c.x_max);
  std::vector<const SliceCluster*> members;
  TrunkLevel first =
      gather(slices.levels[start], x_min, x_max, (start + 0.5) * slices.height, {}, members);
  body.trunk[start] = first;
  Follower follower{slices, samples, body, in_trunk};
  follower.take(start, members);
  follower.walk(start + 1, +1, first, true);
  follower.walk(start - 1, -1, first, false);
  return in_trunk;
}

}  // namespace regarment
