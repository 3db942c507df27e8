#pragma once

#include <array>
#include <cmath>
#include <limits>

#include "geometry/closest_point.h"
#include "geometry/kdop_nodes.h"

namespace regarment {

/// One question to a tree. Boxes and blocks are tested as floats with a margin for all their
/// rounding, so that what they leave out is truly farther; what they let through is reckoned in
/// double.
template <int K, class Elements, bool Filtered>
class KDopSearch {
 public:
  using Nodes = KDopNodes<K, Elements>;
  using NodeLanes = Lanes<Nodes::kWidth>;
  using Block = typename Nodes::Block;

  KDopSearch(const Nodes& nodes, const Vec3& query, const ClosestFilter& filter)
      : nodes_(nodes), query_(query), filter_(filter), test_(filter.normal, filter.min_cosine) {
    const Vec3 from_centre = query - nodes.centre;
    const auto along = KDopAxes<K>::project(from_centre);
    for (int d = 0; d < KDopAxes<K>::kCount; ++d) along_[d] = static_cast<float>(along[d]);
    margin_ = 0x1p-20 * (from_centre.template lpNorm<1>() + 3 * nodes.size);
    best_squared_ = filter.max_distance * filter.max_distance;
    tighten();
  }

  ClosestHit run() {
    walk();
    if (best_index_ == ClosestHit::kNone) return {};
    return {best_index_, best_place_.point, nodes_.elements.normal(best_element_), best_squared_,
            best_place_.on_border};
  }

 private:
  struct Entry {
    float squared_gap;
    std::uint32_t reference;
  };
  // The tree has at most 64 levels, and each leaves all but one of its children behind.
  static constexpr int kMostEntries = 64 * Nodes::kWidth;

  void walk() {
    std::array<Entry, kMostEntries> stack;
    int size = 0;
    stack[size++] = {0, 0};
    while (size > 0) {
      const Entry entry = stack[--size];
      if (entry.squared_gap > limit_) continue;
      if ((entry.reference & Nodes::kLeaf) != 0)
        ask_block(entry.reference & ~Nodes::kLeaf);
      else
        size = push_children(entry.reference, stack.data(), size);
    }
  }

  // The nearest child ends on top.
  int push_children(std::uint32_t at, Entry* stack, int size) const {
    const auto& node = nodes_.nodes[at];
    const NodeLanes gap = node.dops.squared_gap(along_);
    unsigned open = not_above(gap, NodeLanes::all(limit_)) & node.used;
    if constexpr (Filtered)
      if (open != 0) open &= nodes_.cones[at].may_pass(test_);
    const int first = size;
    while (open != 0) {
      const int lane = __builtin_ctz(open);
      open &= open - 1;
      const Entry entry{gap[lane], node.children[lane]};
      int i = size++;
      for (; i > first && stack[i - 1].squared_gap < entry.squared_gap; --i)
        stack[i] = stack[i - 1];
      stack[i] = entry;
    }
    return size;
  }

  void ask_block(std::uint32_t at) {
    const Block& block = nodes_.blocks[at];
    const auto gap = block.squared_gap({along_[0], along_[1], along_[2]});
    unsigned open = not_above(gap, Block::L::all(limit_));
    while (open != 0) {
      const int lane = __builtin_ctz(open);
      open &= open - 1;
      if (gap[lane] > limit_) continue;
      const std::size_t i = std::size_t{at} * Block::kSize + lane;
      if (!Filtered || passes(block.cosine(test_)[lane], i)) ask(i);
    }
  }

  void ask(std::size_t i) {
    const NearestPlace place = nodes_.elements.nearest(i, query_);
    if (place.squared_distance > best_squared_) return;
    const std::uint32_t index = nodes_.elements.index(i);
    if (place.squared_distance == best_squared_ && index >= best_index_) return;
    best_squared_ = place.squared_distance;
    best_place_ = place;
    best_element_ = i;
    best_index_ = index;
    tighten();
  }

  bool passes(float cosine, std::size_t i) const {
    if (cosine < test_.least) return false;
    if (cosine > test_.sure) return true;
    const Vec3 normal = nodes_.elements.normal(i);
    return !normal.isZero(0) && normal.dot(filter_.normal) >= filter_.min_cosine;
  }

  // Bounds above this are farther than the best, whatever their rounding.
  void tighten() {
    const double reach = std::sqrt(best_squared_) + margin_;
    limit_ = static_cast<float>(reach * reach * (1 + 0x1p-19));
  }

  const Nodes& nodes_;
  const Vec3& query_;
  const ClosestFilter& filter_;
  DirectionTest test_;
  std::array<float, KDopAxes<K>::kCount> along_;
  double margin_ = 0;
  float limit_ = 0;
  double best_squared_ = 0;
  NearestPlace best_place_;
  std::size_t best_element_ = 0;
  std::uint32_t best_index_ = ClosestHit::kNone;
};

}  // namespace regarment
