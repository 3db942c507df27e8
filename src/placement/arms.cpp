#include "placement/arms.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <queue>
#include <unordered_map>

namespace regarment {
namespace {

constexpr double kVoxel = 0.02;         // m
constexpr double kStep = 0.03;          // m along the arm between points of its axis
constexpr double kObliqueRoot = 0.06;   // m of axis next to the trunk that are not trusted
constexpr double kUpperArm = 0.12;      // m of axis beyond that are taken as straight
constexpr double kSlab = 0.015;         // m, half the thickness of a slab across the arm
constexpr double kThickestArm = 0.13;   // m from the axis
constexpr double kIntoShoulder = 0.15;  // m the axis is continued into the trunk
constexpr double kShortest = 0.15;      // m an arm must reach beyond the trunk

struct Voxels {
  std::unordered_map<std::uint64_t, int> index;
  std::vector<Vec3> centre;
  std::vector<std::vector<int>> samples;

  static std::uint64_t key(std::int64_t x, std::int64_t y, std::int64_t z) {
    constexpr std::int64_t kOffset = 1 << 20;
    return (static_cast<std::uint64_t>(x + kOffset) << 42) |
           (static_cast<std::uint64_t>(y + kOffset) << 21) |
           static_cast<std::uint64_t>(z + kOffset);
  }
  static std::array<std::int64_t, 3> cell(const Vec3& p) {
    return {static_cast<std::int64_t>(std::floor(p.x() / kVoxel)),
            static_cast<std::int64_t>(std::floor(p.y() / kVoxel)),
            static_cast<std::int64_t>(std::floor(p.z() / kVoxel))};
  }
  void add(const Vec3& p, int sample) {
    const auto c = cell(p);
    const auto [it, fresh] =
        index.try_emplace(key(c[0], c[1], c[2]), static_cast<int>(samples.size()));
    if (fresh) {
      samples.emplace_back();
      centre.push_back(kVoxel *
                       (Eigen::Matrix<std::int64_t, 3, 1>(c[0], c[1], c[2]).cast<double>() +
                        Vec3::Constant(0.5)));
    }
    samples[it->second].push_back(sample);
  }
  template <typename Visit>
  void neighbours(int v, Visit visit) const {
    const auto c = cell(centre[v]);
    for (int dx = -1; dx <= 1; ++dx)
      for (int dy = -1; dy <= 1; ++dy)
        for (int dz = -1; dz <= 1; ++dz) {
          const auto it = index.find(key(c[0] + dx, c[1] + dy, c[2] + dz));
          if (it != index.end() && it->second != v) visit(it->second);
        }
  }
};

std::vector<int> components(const Voxels& voxels, int& count) {
  std::vector<int> label(voxels.centre.size(), -1);
  count = 0;
  for (std::size_t seed = 0; seed < label.size(); ++seed) {
    if (label[seed] >= 0) continue;
    std::vector<int> stack{static_cast<int>(seed)};
    label[seed] = count;
    while (!stack.empty()) {
      const int v = stack.back();
      stack.pop_back();
      voxels.neighbours(v, [&](int n) {
        if (label[n] >= 0) return;
        label[n] = count;
        stack.push_back(n);
      });
    }
    ++count;
  }
  return label;
}

/// Shortest way over the voxels from those within `reach` of the plane x = armpit_x, m.
std::vector<double> distance_from_trunk(const Voxels& voxels, const std::vector<int>& label,
                                        int which, const Body& body, int side) {
  std::vector<double> distance(label.size(), 1e9);
  using Entry = std::pair<double, int>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  const double root_x = body.armpit_x[side], sign = side == 0 ? 1.0 : -1.0;
  double nearest = 1e9;
  for (std::size_t v = 0; v < label.size(); ++v)
    if (label[v] == which && voxels.centre[v].y() > body.armpit[side] - 0.02)
      nearest = std::min(nearest, sign * (voxels.centre[v].x() - root_x));
  for (std::size_t v = 0; v < label.size(); ++v) {
    if (label[v] != which || voxels.centre[v].y() < body.armpit[side] - 0.02) continue;
    if (sign * (voxels.centre[v].x() - root_x) > nearest + 1.5 * kVoxel) continue;
    distance[v] = 0;
    open.emplace(0, static_cast<int>(v));
  }
  while (!open.empty()) {
    const auto [d, v] = open.top();
    open.pop();
    if (d > distance[v]) continue;
    voxels.neighbours(v, [&](int n) {
      const double further = d + (voxels.centre[n] - voxels.centre[v]).norm();
      if (label[n] != which || further >= distance[n] - 1e-12) return;
      distance[n] = further;
      open.emplace(further, n);
    });
  }
  return distance;
}

/// Next to the trunk a piece of arm is cut obliquely and its middle is off; the line through the
/// upper arm beyond is a better axis there. It is continued a little into the shoulder.
void straighten_root(std::vector<Vec3>& points) {
  const std::size_t first = static_cast<std::size_t>(std::lround(kObliqueRoot / kStep));
  const std::size_t last =
      std::min(points.size(), first + static_cast<std::size_t>(std::lround(kUpperArm / kStep)));
  if (last < first + 3) return;
  Vec3 mean = Vec3::Zero();
  for (std::size_t i = first; i < last; ++i) mean += points[i];
  mean /= static_cast<double>(last - first);
  const Vec3 along =
      (points[last - 1] + points[last - 2] - points[first] - points[first + 1]).normalized();
  const double first_s = (points[first] - mean).dot(along);
  std::vector<Vec3> out;
  const int added = static_cast<int>(std::lround((kObliqueRoot + kIntoShoulder) / kStep));
  for (int k = added; k > 0; --k) out.push_back(mean + (first_s - k * kStep) * along);
  out.insert(out.end(), points.begin() + static_cast<std::ptrdiff_t>(first), points.end());
  points = std::move(out);
}

/// Middle of the bounding box across the arm of the samples between two distances.
std::vector<Vec3> middle_line(const Voxels& voxels, const std::vector<double>& distance) {
  double longest = 0;
  for (double d : distance)
    if (d < 1e8) longest = std::max(longest, d);
  const int bins = static_cast<int>(longest / kStep) + 1;
  std::vector<Vec3> low(bins, Vec3::Constant(1e9)), high(bins, Vec3::Constant(-1e9));
  for (std::size_t v = 0; v < distance.size(); ++v) {
    if (distance[v] > 1e8) continue;
    const int b = static_cast<int>(distance[v] / kStep);
    low[b] = low[b].cwiseMin(voxels.centre[v]);
    high[b] = high[b].cwiseMax(voxels.centre[v]);
  }
  std::vector<Vec3> points;
  for (int b = 0; b < bins; ++b)
    if (low[b].x() < 1e8) points.push_back((low[b] + high[b]) / 2);
  return points;
}

/// Moves each point of the axis to the middle of the samples in a thin slab across the arm.
void recentre(const SurfaceSamples& samples, const std::vector<int>& members,
              std::vector<Vec3>& points) {
  std::vector<Vec3> moved = points;
  for (std::size_t i = 1; i + 1 < points.size(); ++i) {
    const Vec3 along = (points[i + 1] - points[i - 1]).normalized();
    const Vec3 a = along.unitOrthogonal(), b = along.cross(a);
    std::vector<double> u, v;
    for (int m : members) {
      const Vec3 d = samples.positions[m] - points[i];
      if (std::abs(d.dot(along)) > kSlab || d.squaredNorm() > kThickestArm * kThickestArm) continue;
      u.push_back(d.dot(a));
      v.push_back(d.dot(b));
    }
    if (u.size() < 12) continue;
    std::sort(u.begin(), u.end());
    std::sort(v.begin(), v.end());
    const std::size_t cut = u.size() / 25;
    moved[i] +=
        0.5 * (u[cut] + u[u.size() - 1 - cut]) * a + 0.5 * (v[cut] + v[v.size() - 1 - cut]) * b;
  }
  points = moved;
}

std::vector<Vec3> smoothed(std::vector<Vec3> points, int rounds) {
  for (int round = 0; round < rounds; ++round) {
    std::vector<Vec3> next = points;
    for (std::size_t i = 1; i + 1 < points.size(); ++i)
      next[i] = 0.25 * points[i - 1] + 0.5 * points[i] + 0.25 * points[i + 1];
    points = std::move(next);
  }
  return points;
}

}  // namespace

void find_arms(const SurfaceSamples& samples, const std::vector<bool>& in_trunk, Body& body) {
  body.part.assign(samples.size(), BodyPart::Loose);
  Voxels voxels;
  for (std::size_t s = 0; s < samples.size(); ++s) {
    if (in_trunk[s])
      body.part[s] = BodyPart::Trunk;
    else
      voxels.add(samples.positions[s], static_cast<int>(s));
  }
  int count = 0;
  const std::vector<int> label = components(voxels, count);
  for (int side = 0; side < 2; ++side) {
    if (body.armpit[side] <= 0) continue;
    const double sign = side == 0 ? 1.0 : -1.0;
    std::vector<double> size(count, 0.0);
    for (std::size_t v = 0; v < label.size(); ++v)
      if (sign * (voxels.centre[v].x() - body.armpit_x[side]) > -0.01)
        size[label[v]] += static_cast<double>(voxels.samples[v].size());
    const int which = static_cast<int>(std::max_element(size.begin(), size.end()) - size.begin());
    if (size.empty() || size[which] <= 0) continue;
    const std::vector<double> distance = distance_from_trunk(voxels, label, which, body, side);
    std::vector<Vec3> line = smoothed(middle_line(voxels, distance), 3);
    std::vector<int> members;
    for (std::size_t v = 0; v < label.size(); ++v)
      if (label[v] == which)
        members.insert(members.end(), voxels.samples[v].begin(), voxels.samples[v].end());
    std::sort(members.begin(), members.end());
    for (int round = 0; round < 2; ++round) {
      recentre(samples, members, line);
      line = smoothed(line, 1);
    }
    double length = 0;
    for (std::size_t i = 1; i < line.size(); ++i) length += (line[i] - line[i - 1]).norm();
    if (length < kShortest) continue;
    straighten_root(line);
    body.arms[side].points = line;
    for (int s : members) body.part[s] = side == 0 ? BodyPart::LeftArm : BodyPart::RightArm;
  }
}

}  // namespace regarment
