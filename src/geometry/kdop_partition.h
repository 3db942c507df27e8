#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "geometry/mesh.h"

namespace regarment {

/// An element on its way into a tree: its box, as floats, and which it is.
struct BoxedElement {
  std::array<float, 3> low, high;
  std::uint32_t element = 0;

  float centre(int axis) const { return low[axis] + high[axis]; }  // doubled
};

/// Elements [begin, end) of a list being put in order.
struct ElementRange {
  std::size_t begin = 0, end = 0;
  float half_area = 0;    // of the box around them
  bool distinct = false;  // no two of them are known to be the same

  std::size_t size() const { return end - begin; }
};

/// The box around `items` of `range`, as a range.
ElementRange boxed_range(const std::vector<BoxedElement>& items, std::size_t begin,
                         std::size_t end);

/// Puts the elements of a range in an order whose first part belongs together and whose rest does,
/// and returns where the second begins, strictly inside. Both parts are chosen so that boxes around
/// them are small where elements are many (surface area heuristic, in bins), or are halves when
/// `halve` or where all centres coincide. `range` has at least two elements; `block` of
/// them cost what one does.
std::size_t part_range(std::vector<BoxedElement>& items, const ElementRange& range,
                       std::size_t block, bool halve);

/// Whether the centres of all elements of the range coincide.
bool coincide(const std::vector<BoxedElement>& items, const ElementRange& range);

}  // namespace regarment
