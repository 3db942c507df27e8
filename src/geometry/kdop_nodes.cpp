#include "geometry/kdop_nodes.h"

#include <algorithm>

#include "geometry/kdop_partition.h"

namespace regarment {
namespace {

// Below this depth ranges are halved, so that no input makes a tree deeper than twice this.
constexpr int kDeep = 32;

template <int K, class Elements>
class Builder {
 public:
  using Nodes = KDopNodes<K, Elements>;
  static constexpr std::size_t kBlock = Nodes::Block::kSize;

  Builder(const Elements& from, Nodes& to) : from_(from), to_(to) {
    set_frame();
    box_elements();
    for (std::size_t i = 0; i < from.size(); ++i) normals_.push_back(from.normal(i));
    add_node(boxed_range(items_, 0, items_.size()), 0);
    to_.elements = Elements(from, order_);
  }

 private:
  // Around the median, with room for all elements, but at most for four times what nine in ten of
  // them need: a few strays far away cost the others none of the floats' digits.
  void set_frame() {
    std::vector<double> values(from_.size());
    const auto ranked = [&](double rank) {
      const auto at = values.begin() +
                      static_cast<std::ptrdiff_t>(rank * static_cast<double>(values.size() - 1));
      std::nth_element(values.begin(), at, values.end());
      return *at;
    };
    for (int axis = 0; axis < 3; ++axis) {
      for (std::size_t i = 0; i < values.size(); ++i) values[i] = from_.corners(i)[0][axis];
      to_.frame.centre[axis] = ranked(0.5);
    }
    for (std::size_t i = 0; i < values.size(); ++i) {
      values[i] = 0;
      for (const Vec3& corner : from_.corners(i))
        values[i] = std::max(values[i], (corner - to_.frame.centre).cwiseAbs().maxCoeff());
    }
    to_.frame.reach = std::min(4 * ranked(0.9), ranked(1));
  }

  void box_elements() {
    items_.resize(from_.size());
    for (std::size_t i = 0; i < from_.size(); ++i) {
      KDop<6> box;
      for (const Vec3& corner : from_.corners(i)) box.add(corner - to_.frame.centre);
      items_[i] = {box.low, box.high, static_cast<std::uint32_t>(i)};
    }
  }

  KDop<K> add_node(const ElementRange& range, int depth) {
    const std::size_t at = to_.nodes.size();
    to_.nodes.emplace_back();
    to_.cones.emplace_back();
    KDop<K> whole;
    int lane = 0;
    for (const ElementRange& child : children_of(range, depth)) {
      const std::size_t first = order_.size();
      std::size_t reference = to_.nodes.size();
      KDop<K> dop;
      if (child.size() <= kBlock) {
        reference = Nodes::kLeaf | to_.blocks.size();
        dop = add_block(child);
      } else {
        dop = add_node(child, depth + 1);
      }
      auto& node = to_.nodes[at];
      node.dops.set(lane, dop);
      node.children[lane] = static_cast<std::uint32_t>(reference);
      node.used |= 1U << lane;
      to_.cones[at].set(lane, cone_from(first));
      whole.add(dop);
      ++lane;
    }
    return whole;
  }

  // Parts a range into as many as a node has room for, the one with the largest box first.
  std::vector<ElementRange> children_of(const ElementRange& range, int depth) {
    std::vector<ElementRange> children{range};
    const auto rank = [](const ElementRange& r) { return r.size() > kBlock ? r.half_area : -1; };
    while (children.size() < Nodes::kWidth) {
      const auto largest = std::max_element(
          children.begin(), children.end(),
          [&](const ElementRange& a, const ElementRange& b) { return rank(a) < rank(b); });
      if (largest->size() <= kBlock) break;
      if (!largest->distinct && coincide(items_, *largest)) {
        drop_repeats(*largest);
        continue;
      }
      const std::size_t middle = part_range(items_, *largest, kBlock, depth > kDeep);
      ElementRange second = boxed_range(items_, middle, largest->end);
      second.distinct = largest->distinct;
      *largest = boxed_range(items_, largest->begin, middle);
      largest->distinct = second.distinct;
      children.insert(largest + 1, second);
    }
    return children;
  }

  // Of elements that are the same in all but the index the first is enough.
  void drop_repeats(ElementRange& range) {
    const auto begin = items_.begin() + range.begin, end = items_.begin() + range.end;
    std::sort(begin, end, [&](const BoxedElement& a, const BoxedElement& b) {
      const int order = from_.compare(a.element, b.element);
      return order != 0 ? order < 0 : a.element < b.element;
    });
    const auto last = std::unique(begin, end, [&](const BoxedElement& a, const BoxedElement& b) {
      return from_.compare(a.element, b.element) == 0;
    });
    range.end = static_cast<std::size_t>(last - items_.begin());
    range.distinct = true;
  }

  KDop<K> add_block(const ElementRange& range) {
    KDop<K> dop;
    typename Nodes::Block block;
    for (std::size_t lane = 0; lane < kBlock; ++lane) {
      const std::uint32_t i = items_[std::min(range.begin + lane, range.end - 1)].element;
      block.set(static_cast<int>(lane), from_, i, to_.frame);
      order_.push_back(i);
      for (const Vec3& corner : from_.corners(i)) dop.add(corner - to_.frame.centre);
    }
    to_.blocks.push_back(block);
    return dop;
  }

  NormalCone cone_from(std::size_t first) const {
    return NormalCone::around([&](auto&& visit) {
      for (std::size_t i = first; i < order_.size(); ++i) visit(normals_[order_[i]]);
    });
  }

  const Elements& from_;
  Nodes& to_;
  std::vector<BoxedElement> items_;
  std::vector<Vec3> normals_;         // of from_
  std::vector<std::uint32_t> order_;  // which of from_ each element of the tree is
};

}  // namespace

template <int K, class Elements>
KDopNodes<K, Elements>::KDopNodes(const Elements& from) {
  if (from.size() > 0) Builder<K, Elements>(from, *this);
}

template struct KDopNodes<6, TriangleElements>;
template struct KDopNodes<14, TriangleElements>;
template struct KDopNodes<18, TriangleElements>;
template struct KDopNodes<26, TriangleElements>;
template struct KDopNodes<6, PointElements>;
template struct KDopNodes<14, PointElements>;
template struct KDopNodes<18, PointElements>;
template struct KDopNodes<26, PointElements>;

}  // namespace regarment
