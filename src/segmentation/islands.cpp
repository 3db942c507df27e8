#include "segmentation/islands.h"

#include <numeric>

#include "base/error.h"

namespace regarment {
namespace {

std::uint32_t root_of(std::vector<std::uint32_t>& parent, std::uint32_t i) {
  while (parent[i] != i) i = parent[i] = parent[parent[i]];
  return i;
}

}  // namespace

void remove_islands(std::span<const CutLink> links, std::span<const float> odds, std::size_t least,
                    double firm, std::vector<std::uint8_t>& label) {
  const std::size_t n = label.size();
  if (odds.size() != n) throw InvalidInput("remove_islands: one label per vertex");
  std::vector<std::uint32_t> parent(n);
  std::iota(parent.begin(), parent.end(), 0U);
  std::vector<std::uint8_t> linked(n, 0);
  for (const CutLink& link : links) {
    if (link.a >= n || link.b >= n) throw InvalidInput("remove_islands: a link leaves the graph");
    linked[link.a] = linked[link.b] = 1;
    if (label[link.a] == label[link.b]) parent[root_of(parent, link.b)] = root_of(parent, link.a);
  }
  std::vector<std::uint32_t> size(n, 0);
  std::vector<double> support(n, 0.0);
  for (std::uint32_t v = 0; v < n; ++v) {
    const std::uint32_t root = root_of(parent, v);
    ++size[root];
    support[root] += (label[v] ? 1 : -1) * static_cast<double>(odds[v]);
  }
  for (std::uint32_t v = 0; v < n; ++v) {
    const std::uint32_t root = root_of(parent, v);
    if (linked[v] && size[root] < least && support[root] < firm * size[root])
      label[v] = label[v] ? 0 : 1;
  }
}

}  // namespace regarment
