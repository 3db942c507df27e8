#include "scan/find_front.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "scan/mirror_plane.h"
#include "scan/robust.h"

namespace regarment {
namespace {

/// A point seen from the mirror plane, in body heights.
struct Seen {
  double height, side, ahead;  // side: from the plane; ahead: along the direction to be judged
};

constexpr std::size_t kFewest = 6;  // points a part needs to count

template <typename Wanted>
std::vector<double> ahead_of(const std::vector<Seen>& points, Wanted wanted) {
  std::vector<double> ahead;
  for (const Seen& p : points) {
    if (wanted(p)) ahead.push_back(p.ahead);
  }
  return ahead;
}

std::optional<double> mean(const std::vector<double>& values) {
  if (values.size() < kFewest) return std::nullopt;
  double sum = 0;
  for (const double v : values) sum += v;
  return sum / static_cast<double>(values.size());
}

std::optional<double> median(const std::vector<double>& values) {
  if (values.size() < kFewest) return std::nullopt;
  return quantile(values, 0.5);
}

bool between(double value, double low, double high) { return value > low && value < high; }

double difference(const std::optional<double>& a, const std::optional<double>& b) {
  return a && b ? *a - *b : 0.0;
}

/// A straight line through points (height, ahead): the axis of a lower leg.
struct Axis {
  double height = 0.0, ahead = 0.0, slope = 0.0;

  double at(double h) const { return ahead + slope * (h - height); }
};

Axis axis_of(const std::vector<Seen>& points) {
  Axis axis;
  for (const Seen& p : points) {
    axis.height += p.height / static_cast<double>(points.size());
    axis.ahead += p.ahead / static_cast<double>(points.size());
  }
  double product = 0, square = 0;
  for (const Seen& p : points) {
    product += (p.height - axis.height) * (p.ahead - axis.ahead);
    square += (p.height - axis.height) * (p.height - axis.height);
  }
  if (square > 0) axis.slope = product / square;
  return axis;
}

/// How far the middle of a foot lies before the axis of its lower leg; nothing where there is no
/// foot: under a long skirt, or cut off.
std::optional<double> foot_cue(const std::vector<Seen>& points, double side) {
  double lowest = 1;
  std::vector<Seen> leg;
  for (const Seen& p : points) {
    if (!between(side * p.side, 0.003, 0.35) || p.height > 0.5) continue;
    leg.push_back(p);
    lowest = std::min(lowest, p.height);
  }
  const auto part = [&](double low, double high) {
    std::vector<Seen> inside;
    for (const Seen& p : leg) {
      if (between(p.height - lowest, low, high)) inside.push_back(p);
    }
    return inside;
  };
  const auto length_of = [](const std::vector<double>& ahead) {
    return quantile(ahead, 0.95) - quantile(ahead, 0.05);
  };
  const std::vector<Seen> foot = part(-1, 0.04), shin = part(0.10, 0.24);
  if (lowest > 0.25 || foot.size() < kFewest || shin.size() < kFewest) return std::nullopt;
  const auto foot_ahead = ahead_of(foot, [](const Seen&) { return true; });
  const auto ankle_ahead = ahead_of(part(0.06, 0.10), [](const Seen&) { return true; });
  const double length = length_of(foot_ahead);
  if (!between(length, 0.06, 0.26) || length < 1.25 * length_of(ankle_ahead)) return std::nullopt;
  double height = 0;
  for (const Seen& p : foot) height += p.height / static_cast<double>(foot.size());
  return (quantile(foot_ahead, 0.95) + quantile(foot_ahead, 0.05)) / 2 - axis_of(shin).at(height);
}

double feet_cue(const std::vector<Seen>& points) {
  const auto left = foot_cue(points, 1.0), right = foot_cue(points, -1.0);
  if (left && right) return (*left + *right) / 2;
  return left.value_or(right.value_or(0.0));
}

/// How far the middle of the head lies before the neck: jaw and nose lie ahead of it.
double face_cue(const std::vector<Seen>& points, const PersonLikeness& likeness) {
  if (likeness.head < 0.2) return 0;
  const double half = std::max(0.07, 0.7 * likeness.head_width);
  const auto head = ahead_of(points, [&](const Seen& p) {
    return between(p.height, likeness.neck_t, likeness.head_top_t + 0.03) &&
           std::abs(p.side) < half;
  });
  const auto neck = ahead_of(points, [&](const Seen& p) {
    return between(p.height, likeness.neck_t - 0.045, likeness.neck_t - 0.005) &&
           std::abs(p.side) < half;
  });
  return difference(mean(head), mean(neck));
}

/// How far arms and hands lie before the upper trunk.
double arms_cue(const std::vector<Seen>& points) {
  const auto arms = ahead_of(points, [](const Seen& p) {
    return p.height > 0.35 && between(std::abs(p.side), 0.16, 0.6);
  });
  const auto trunk = ahead_of(points, [](const Seen& p) {
    return between(p.height, 0.72, 0.82) && std::abs(p.side) < 0.12;
  });
  return difference(mean(arms), median(trunk));
}

/// How far the seat stands out behind the waist, beyond what the belly does in front.
double seat_cue(const std::vector<Seen>& points) {
  const auto middle_at = [&](double low, double high) -> std::optional<double> {
    const auto part = ahead_of(points, [&](const Seen& p) {
      return between(p.height, low, high) && std::abs(p.side) < 0.06;
    });
    if (part.size() < kFewest) return std::nullopt;
    return quantile(part, 0.03) + quantile(part, 0.97);
  };
  return difference(middle_at(0.58, 0.64), middle_at(0.47, 0.53));
}

/// How far thighs lie before calves; nothing under a long skirt.
double legs_cue(const std::vector<Seen>& points, const PersonLikeness& likeness) {
  if (likeness.legs < 0.5) return 0;
  const auto part = [&](double low, double high) {
    return median(ahead_of(points, [&](const Seen& p) {
      return between(p.height, low, high) && std::abs(p.side) < 0.2;
    }));
  };
  return difference(part(0.30, 0.40), part(0.12, 0.20));
}

/// -1..1, reached at `full`; a cue far beyond is a part mistaken for another and says nothing.
double share_of(double cue, double full) {
  return std::abs(cue) > 5 * full ? 0.0 : std::clamp(cue / full, -1.0, 1.0);
}

}  // namespace

Front find_front(std::span<const Vec3> upright, const PersonLikeness& likeness) {
  const MirrorPlane plane = find_mirror_plane(upright);
  const Vec2 ahead(-plane.normal.y(), plane.normal.x());
  std::vector<Seen> points;
  points.reserve(upright.size());
  for (const Vec3& p : upright) {
    const Vec2 at(p.x(), p.z());
    points.push_back({p.y(), plane.normal.dot(at) - plane.offset, ahead.dot(at)});
  }
  // The weights say how often each cue is right: feet nearly always, a seat under a skirt less so.
  const double evidence =
      3.0 * share_of(feet_cue(points), 0.025) + 1.5 * share_of(face_cue(points, likeness), 0.020) +
      1.0 * share_of(arms_cue(points), 0.050) + 0.6 * share_of(seat_cue(points), 0.030) +
      0.6 * share_of(legs_cue(points, likeness), 0.020);
  const double sign = evidence < 0 ? -1.0 : 1.0;
  Front front;
  front.direction = Vec3(sign * ahead.x(), 0, sign * ahead.y()).normalized();
  front.confidence = 1 / (1 + std::exp(-1.5 * std::abs(evidence)));
  front.mismatch = plane.mismatch;
  return front;
}

}  // namespace regarment
