#include "measure/outline_field.h"

#include <algorithm>
#include <array>
#include <map>

namespace regarment {
namespace {

constexpr double kCell = 0.002;  // m
constexpr double kHeart = 0.03;  // m round the centre that the outside must not hold

/// Crossings of a contour with the grid's edges, each joined to at most two others.
class Crossings {
 public:
  void join(std::size_t a, const Vec2& at_a, std::size_t b, const Vec2& at_b) {
    nodes_[a].add(at_a, b), nodes_[b].add(at_b, a);
  }
  /// The closed chain with the largest number of crossings.
  std::vector<Vec2> longest() {
    std::vector<Vec2> best;
    for (auto& [start, first] : nodes_) {
      if (first.done) continue;
      std::vector<Vec2> chain;
      for (std::size_t at = start; at != kNone;) {
        Node& node = nodes_.at(at);
        node.done = true;
        chain.push_back(node.p);
        at = kNone;
        for (const std::size_t next : node.joined)
          if (at == kNone && next != kNone && !nodes_.at(next).done) at = next;
      }
      if (chain.size() > best.size()) best = std::move(chain);
    }
    return best;
  }

 private:
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);
  struct Node {
    Vec2 p = Vec2::Zero();
    std::array<std::size_t, 2> joined{kNone, kNone};
    bool done = false;
    void add(const Vec2& at, std::size_t other) {
      p = at;
      joined[joined[0] == kNone ? 0 : 1] = other;
    }
  };
  std::map<std::size_t, Node> nodes_;  // by grid edge
};

}  // namespace

OutlineField::OutlineField(const std::vector<Vec2>& points, double reach) : reach_(reach) {
  measure(points);
  flood();
}

void OutlineField::measure(const std::vector<Vec2>& points) {
  const double far = 2 * reach_;
  Vec2 low = Vec2::Constant(1e9), high = Vec2::Constant(-1e9);
  for (const Vec2& p : points) low = low.cwiseMin(p), high = high.cwiseMax(p);
  low_ = low.array() - (far + kCell);
  nx_ = static_cast<int>((high.x() - low_.x() + far + kCell) / kCell) + 2;
  ny_ = static_cast<int>((high.y() - low_.y() + far + kCell) / kCell) + 2;
  distance_.assign(static_cast<std::size_t>(nx_) * static_cast<std::size_t>(ny_),
                   static_cast<float>(far));
  const int r = static_cast<int>(far / kCell);
  for (const Vec2& p : points) {
    const int cx = static_cast<int>((p.x() - low_.x()) / kCell);
    const int cy = static_cast<int>((p.y() - low_.y()) / kCell);
    for (int y = std::max(0, cy - r); y <= std::min(ny_ - 1, cy + r + 1); ++y)
      for (int x = std::max(0, cx - r); x <= std::min(nx_ - 1, cx + r + 1); ++x) {
        float& d = distance_[at(x, y)];
        d = std::min(d, static_cast<float>((low_ + kCell * Vec2(x, y) - p).norm()));
      }
  }
}

void OutlineField::flood() {
  outside_.assign(distance_.size(), 0);
  std::vector<std::pair<int, int>> stack{{0, 0}};
  outside_[0] = 1;
  while (!stack.empty()) {
    const auto [x, y] = stack.back();
    stack.pop_back();
    constexpr int kSteps[4][2] = {{1, 0}, {-1, 0}, {0, 1}, {0, -1}};
    for (const auto& s : kSteps) {
      const int u = x + s[0], v = y + s[1];
      if (u < 0 || v < 0 || u >= nx_ || v >= ny_ || outside_[at(u, v)]) continue;
      if (distance_[at(u, v)] <= static_cast<float>(reach_)) continue;
      outside_[at(u, v)] = 1;
      stack.emplace_back(u, v);
    }
  }
}

std::vector<std::pair<int, int>> OutlineField::heart(const Vec2& centre) const {
  const int cx = static_cast<int>((centre.x() - low_.x()) / kCell);
  const int cy = static_cast<int>((centre.y() - low_.y()) / kCell);
  const int r = static_cast<int>(kHeart / kCell);
  std::vector<std::pair<int, int>> out;
  for (int y = std::max(0, cy - r); y <= std::min(ny_ - 1, cy + r); ++y)
    for (int x = std::max(0, cx - r); x <= std::min(nx_ - 1, cx + r); ++x) out.emplace_back(x, y);
  return out;
}

bool OutlineField::leaks(const Vec2& centre) const {
  const auto points = heart(centre);
  const auto outside = std::count_if(points.begin(), points.end(), [&](const auto& p) {
    return outside_[at(p.first, p.second)] != 0;
  });
  return 2 * static_cast<std::size_t>(outside) > points.size();
}

void OutlineField::mark_own(const Vec2& centre) {
  own_.assign(outside_.size(), 0);
  std::vector<std::pair<int, int>> stack;
  const auto visit = [&](int x, int y) {
    if (x < 0 || y < 0 || x >= nx_ || y >= ny_) return;
    const std::size_t i = at(x, y);
    if (outside_[i] || own_[i]) return;
    own_[i] = 1;
    stack.emplace_back(x, y);
  };
  for (const auto& [x, y] : heart(centre)) visit(x, y);
  while (!stack.empty()) {
    const auto [x, y] = stack.back();
    stack.pop_back();
    visit(x + 1, y), visit(x - 1, y), visit(x, y + 1), visit(x, y - 1);
  }
}

std::vector<Vec2> OutlineField::contour(const Vec2& centre) {
  mark_own(centre);
  Crossings crossings;
  for (int y = 0; y + 1 < ny_; ++y) {
    for (int x = 0; x + 1 < nx_; ++x) {
      const std::array<std::pair<int, int>, 4> corner{
          {{x, y}, {x + 1, y}, {x + 1, y + 1}, {x, y + 1}}};
      std::array<std::pair<std::size_t, Vec2>, 4> found;
      std::size_t n = 0;
      bool touches = false, own = false;
      for (std::size_t k = 0; k < 4; ++k) {
        const auto [ax, ay] = corner[k];
        const auto [bx, by] = corner[(k + 1) % 4];
        const double a = static_cast<double>(distance_[at(ax, ay)]) - reach_;
        const double b = static_cast<double>(distance_[at(bx, by)]) - reach_;
        touches = touches || outside_[at(ax, ay)] != 0;
        own = own || own_[at(ax, ay)] != 0;
        if ((a > 0) == (b > 0)) continue;
        const double t = a / (a - b);
        const std::size_t edge = 2 * at(std::min(ax, bx), std::min(ay, by)) + (ax == bx ? 1U : 0U);
        found[n++] = {edge, low_ + kCell * ((1 - t) * Vec2(ax, ay) + t * Vec2(bx, by))};
      }
      if (!touches || !own) continue;
      for (std::size_t k = 0; k + 1 < n; k += 2)
        crossings.join(found[k].first, found[k].second, found[k + 1].first, found[k + 1].second);
    }
  }
  return crossings.longest();
}

}  // namespace regarment
