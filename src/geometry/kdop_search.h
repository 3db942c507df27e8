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
    const Vec3 from_centre = query - nodes.frame.centre;
    const auto along = KDopAxes<K>::project(from_centre);
    for (int d = 0; d < KDopAxes<K>::kCount; ++d) along_[d] = static_cast<float>(along[d]);
    const double margin = 0x1p-20 * (from_centre.template lpNorm<1>() + 3 * nodes.frame.reach);
    margin_squared_ = margin * margin;
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
  static constexpr int kMostEntries = 65 * Nodes::kWidth;

  void walk() {
    std::array<Entry, kMostEntries> stack;
    int size = 0;
    std::uint32_t at = 0;
    while (true) {
      if ((at & Nodes::kLeaf) != 0)
        ask_block(at & ~Nodes::kLeaf);
      else if (descend(at, stack.data(), size))
        continue;
      do {
        if (size == 0) return;
      } while (stack[--size].squared_gap > limit_);
      at = stack[size].reference;
    }
  }

  // Goes on to the nearest child and leaves the others on the stack, the nearest of them on top.
  // False when there is none.
  bool descend(std::uint32_t& at, Entry* stack, int& size) const {
    const auto& node = nodes_.nodes[at];
    const NodeLanes gap = node.dops.squared_gap(along_);
    unsigned open = not_above(gap, NodeLanes::all(limit_)) & node.used;
    if constexpr (Filtered)
      if (open != 0) open &= nodes_.cones[at].may_pass(test_);
    if (open == 0) return false;
    const SortedLanes sorted(gap.part[0], open);
    for (int i = 0; i < 3; ++i)
      stack[size + i] = {sorted.keys[i], node.children[SortedLanes::lane(sorted.keys[i])]};
    at = node.children[sorted.nearest];
    const int others = count_bits4(open) - 1;
    size += others;
    if (others > 0) fetch(stack[size - 1].reference);
    return true;
  }

  // Says that a child will be asked for soon.
  [[gnu::always_inline]] void fetch(std::uint32_t reference) const {
    if ((reference & Nodes::kLeaf) != 0) {
      fetch_all(nodes_.blocks[reference & ~Nodes::kLeaf]);
    } else {
      fetch_all(nodes_.nodes[reference]);
      if constexpr (Filtered) fetch_all(nodes_.cones[reference]);
    }
  }

  template <class Item>
  [[gnu::always_inline]] static void fetch_all(const Item& item) {
    for (std::size_t byte = 0; byte < sizeof(Item); byte += 64)
      __builtin_prefetch(reinterpret_cast<const char*>(&item) + byte);
  }

  void ask_block(std::uint32_t at) {
    const Block& block = nodes_.blocks[at];
    nodes_.elements.fetch(std::size_t{at} * Block::kSize);
    const auto gap = block.squared_gap({along_[0], along_[1], along_[2]});
    unsigned open = not_above(gap, Block::L::all(limit_));
    if constexpr (Filtered)
      if (open != 0) open &= not_above(Block::L::all(test_.least), block.cosine(test_));
    for (int part = 0; open != 0; ++part, open >>= 4) {
      const SortedLanes sorted(gap.part[part], open & 15U);
      for (int i = count_bits4(open & 15U) - 1; i >= 0 && sorted.keys[i] <= limit_; --i) {
        const int lane = 4 * part + SortedLanes::lane(sorted.keys[i]);
        const std::size_t element = std::size_t{at} * Block::kSize + lane;
        if (!Filtered || passes(block, lane, element)) ask(element);
      }
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

  bool passes(const Block& block, int lane, std::size_t i) const {
    if (block.cosine(test_)[lane] > test_.sure) return true;
    const Vec3 normal = nodes_.elements.normal(i);
    return !normal.isZero(0) && normal.dot(filter_.normal) >= filter_.min_cosine;
  }

  // Bounds above this are farther than the best, whatever their rounding: (d + m)^2 is at most
  // d^2 (1 + e) + m^2 (1 + 1 / e) for every e.
  void tighten() {
    constexpr double e = 0x1p-10;
    const double limit = best_squared_ * (1 + e) + margin_squared_ * (1 + 1 / e);
    limit_ = static_cast<float>(std::min(limit * (1 + 0x1p-18) + 0x1p-120, 1e38));
  }

  const Nodes& nodes_;
  const Vec3& query_;
  const ClosestFilter& filter_;
  DirectionTest test_;
  std::array<float, KDopAxes<K>::kCount> along_;
  double margin_squared_ = 0;
  float limit_ = 0;
  double best_squared_ = 0;
  NearestPlace best_place_;
  std::size_t best_element_ = 0;
  std::uint32_t best_index_ = ClosestHit::kNone;
};

}  // namespace regarment
