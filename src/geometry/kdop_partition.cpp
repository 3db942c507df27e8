#include "geometry/kdop_partition.h"

#include <algorithm>
#include <limits>

namespace regarment {
namespace {

constexpr int kBins = 16;

struct Box {
  std::array<float, 3> low, high;

  Box() {
    low.fill(std::numeric_limits<float>::infinity());
    high.fill(-std::numeric_limits<float>::infinity());
  }
  void add(const Box& other) {
    for (int a = 0; a < 3; ++a) {
      low[a] = std::min(low[a], other.low[a]);
      high[a] = std::max(high[a], other.high[a]);
    }
  }
  void add(const BoxedElement& item) {
    for (int a = 0; a < 3; ++a) {
      low[a] = std::min(low[a], item.low[a]);
      high[a] = std::max(high[a], item.high[a]);
    }
  }
  float half_area() const {
    const float x = high[0] - low[0], y = high[1] - low[1], z = high[2] - low[2];
    return x * y + y * z + z * x;
  }
};

struct Bin {
  Box box;
  std::size_t count = 0;
};

struct Split {
  int axis = -1;
  int bin = 0;  // the last one of the first part
  float cost = std::numeric_limits<float>::infinity();
};

// Doubled centres of a range: from where to where, and how to number bins along an axis.
struct CentreExtent {
  std::array<float, 3> low, high, scale;

  int bin(const BoxedElement& item, int axis) const {
    const float at = (item.centre(axis) - low[axis]) * scale[axis];
    return std::clamp(static_cast<int>(at), 0, kBins - 1);
  }
};

CentreExtent centre_extent(const std::vector<BoxedElement>& items, const ElementRange& range) {
  CentreExtent extent;
  extent.low.fill(std::numeric_limits<float>::infinity());
  extent.high.fill(-std::numeric_limits<float>::infinity());
  for (std::size_t i = range.begin; i < range.end; ++i) {
    for (int a = 0; a < 3; ++a) {
      extent.low[a] = std::min(extent.low[a], items[i].centre(a));
      extent.high[a] = std::max(extent.high[a], items[i].centre(a));
    }
  }
  for (int a = 0; a < 3; ++a) {
    const float width = extent.high[a] - extent.low[a];
    extent.scale[a] = width > 0 ? kBins * 0.9999F / width : 0;
  }
  return extent;
}

float blocks(std::size_t count, std::size_t block) {
  const std::size_t whole = (count + block - 1) / block;
  return static_cast<float>(whole);
}

void find_best(const std::array<Bin, kBins>& bins, int axis, std::size_t block, Split& best) {
  std::array<float, kBins> cost_after{};
  Bin after;
  for (int b = kBins - 1; b > 0; --b) {
    after.box.add(bins[b].box);
    after.count += bins[b].count;
    cost_after[b] = after.count > 0 ? after.box.half_area() * blocks(after.count, block) : -1;
  }
  Bin before;
  for (int b = 0; b + 1 < kBins; ++b) {
    before.box.add(bins[b].box);
    before.count += bins[b].count;
    if (before.count == 0 || cost_after[b + 1] < 0) continue;
    const float cost = before.box.half_area() * blocks(before.count, block) + cost_after[b + 1];
    if (cost < best.cost) best = {axis, b, cost};
  }
}

Split best_split(const std::vector<BoxedElement>& items, const ElementRange& range,
                 const CentreExtent& extent, std::size_t block) {
  std::array<std::array<Bin, kBins>, 3> bins;
  for (std::size_t i = range.begin; i < range.end; ++i) {
    for (int a = 0; a < 3; ++a) {
      Bin& bin = bins[a][extent.bin(items[i], a)];
      bin.box.add(items[i]);
      ++bin.count;
    }
  }
  Split best;
  for (int a = 0; a < 3; ++a)
    if (extent.scale[a] > 0) find_best(bins[a], a, block, best);
  return best;
}

std::size_t halve_range(std::vector<BoxedElement>& items, const ElementRange& range,
                        const CentreExtent& extent) {
  int axis = 0;
  for (int a = 1; a < 3; ++a)
    if (extent.high[a] - extent.low[a] > extent.high[axis] - extent.low[axis]) axis = a;
  const std::size_t middle = range.begin + range.size() / 2;
  std::nth_element(items.begin() + range.begin, items.begin() + middle, items.begin() + range.end,
                   [axis](const BoxedElement& a, const BoxedElement& b) {
                     return a.centre(axis) != b.centre(axis) ? a.centre(axis) < b.centre(axis)
                                                             : a.element < b.element;
                   });
  return middle;
}

}  // namespace

ElementRange boxed_range(const std::vector<BoxedElement>& items, std::size_t begin,
                         std::size_t end) {
  Box box;
  for (std::size_t i = begin; i < end; ++i) box.add(items[i]);
  return {begin, end, box.half_area()};
}

std::size_t part_range(std::vector<BoxedElement>& items, const ElementRange& range,
                       std::size_t block, bool halve) {
  const CentreExtent extent = centre_extent(items, range);
  const Split split = halve ? Split{} : best_split(items, range, extent, block);
  if (split.axis < 0) return halve_range(items, range, extent);
  const auto middle = std::partition(
      items.begin() + range.begin, items.begin() + range.end,
      [&](const BoxedElement& item) { return extent.bin(item, split.axis) <= split.bin; });
  return static_cast<std::size_t>(middle - items.begin());
}

bool coincide(const std::vector<BoxedElement>& items, const ElementRange& range) {
  return std::all_of(items.begin() + range.begin, items.begin() + range.end,
                     [&](const BoxedElement& item) {
                       const BoxedElement& first = items[range.begin];
                       return item.low == first.low && item.high == first.high;
                     });
}

}  // namespace regarment
