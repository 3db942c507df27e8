#pragma once

#include <cstdint>
#include <vector>

#include "geometry/element_block.h"
#include "geometry/kdop_bounds.h"
#include "geometry/normal_cone.h"
#include "geometry/surface_element.h"

namespace regarment {

/// A tree of nodes with a few children each; a leaf is a block of elements.
template <int K, class Elements>
struct KDopNodes {
  using Block = typename BlockOf<Elements>::Type;
  static constexpr int kWidth = 4;  // most children of a node
  static constexpr std::uint32_t kLeaf = 0x80000000;

  struct alignas(64) Node {
    KDopLanes<K, kWidth> dops;
    std::array<std::uint32_t, kWidth> children{};  // a node, or kLeaf and a block
    std::uint32_t used = 0;                        // bit i: child i exists
  };

  std::vector<Node> nodes;               // the root first; none when there are no elements
  std::vector<ConeLanes<kWidth>> cones;  // of each node's children
  std::vector<Block> blocks;
  Elements elements;  // Block::kSize per block; the last one again where there are fewer
  FloatFrame frame;

  explicit KDopNodes(const Elements& from);
};

extern template struct KDopNodes<6, TriangleElements>;
extern template struct KDopNodes<14, TriangleElements>;
extern template struct KDopNodes<18, TriangleElements>;
extern template struct KDopNodes<26, TriangleElements>;
extern template struct KDopNodes<6, PointElements>;
extern template struct KDopNodes<14, PointElements>;
extern template struct KDopNodes<18, PointElements>;
extern template struct KDopNodes<26, PointElements>;

}  // namespace regarment
