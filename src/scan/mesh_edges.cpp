#include "scan/mesh_edges.h"

#include <algorithm>
#include <numeric>

namespace regarment {
namespace {

/// Disjoint sets whose members carry a sign relative to their set's root.
class SignedSets {
 public:
  explicit SignedSets(std::size_t size) : parent_(size), sign_(size, 0) {
    std::iota(parent_.begin(), parent_.end(), 0u);
  }

  struct Root {
    std::uint32_t index;
    std::uint8_t sign;  // 1 when the member is opposite to the root
  };

  Root root(std::uint32_t i) {
    std::uint8_t sign = 0;
    std::uint32_t top = i;
    for (; parent_[top] != top; top = parent_[top]) sign ^= sign_[top];
    // Hang all passed members directly under the root.
    std::uint8_t rest = sign;
    while (parent_[i] != i) {
      const std::uint32_t next = parent_[i];
      const std::uint8_t own = sign_[i];
      parent_[i] = top;
      sign_[i] = rest;
      rest ^= own;
      i = next;
    }
    return {top, sign};
  }

  /// The lower root stays, so numbering does not depend on the order of joining.
  void join(std::uint32_t a, std::uint32_t b, std::uint8_t opposite) {
    const Root ra = root(a), rb = root(b);
    if (ra.index == rb.index) return;
    const auto [low, high] = std::minmax(ra.index, rb.index);
    parent_[high] = low;
    sign_[high] = ra.sign ^ rb.sign ^ opposite;
  }

 private:
  std::vector<std::uint32_t> parent_;
  std::vector<std::uint8_t> sign_;
};

/// A triangle's side, filed under its lower vertex.
struct Side {
  std::uint32_t high;
  std::uint32_t triangle;
  bool upward;  // runs from the lower vertex to the higher
};

}  // namespace

MeshEdges find_edges(std::span<const Triangle> triangles, std::size_t vertices) {
  std::vector<std::uint32_t> first(vertices + 1, 0);
  for (const Triangle& t : triangles) {
    for (int i = 0; i < 3; ++i) ++first[std::min(t[i], t[(i + 1) % 3]) + 1];
  }
  std::partial_sum(first.begin(), first.end(), first.begin());
  std::vector<Side> sides(3 * triangles.size());
  std::vector<std::uint32_t> next(first.begin(), first.end() - 1);
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    for (int i = 0; i < 3; ++i) {
      const std::uint32_t a = triangles[t][i], b = triangles[t][(i + 1) % 3];
      sides[next[std::min(a, b)]++] = {std::max(a, b), t, a < b};
    }
  }
  MeshEdges edges;
  for (std::uint32_t low = 0; low < vertices; ++low) {
    const auto begin = sides.begin() + first[low], end = sides.begin() + first[low + 1];
    std::sort(begin, end, [](const Side& a, const Side& b) {
      return a.high != b.high ? a.high < b.high : a.triangle < b.triangle;
    });
    for (auto at = begin; at != end;) {
      auto after = at;
      while (after != end && after->high == at->high) ++after;
      if (after - at == 1) edges.border.push_back({low, at->high});
      if (after - at > 2) ++edges.crowded;
      if (after - at == 2 && at->triangle != at[1].triangle) {
        edges.pairs.push_back({at->triangle, at[1].triangle, at->upward != at[1].upward});
      }
      at = after;
    }
  }
  return edges;
}

std::size_t count_holes(const MeshEdges& edges, std::size_t vertices) {
  SignedSets sets(vertices);
  for (const auto& [a, b] : edges.border) sets.join(a, b, 0);
  std::vector<std::uint32_t> roots;
  for (const auto& [a, b] : edges.border) roots.push_back(sets.root(a).index);
  std::sort(roots.begin(), roots.end());
  return static_cast<std::size_t>(std::unique(roots.begin(), roots.end()) - roots.begin());
}

Sheets find_sheets(std::size_t triangles, const MeshEdges& edges) {
  SignedSets sets(triangles);
  for (const MeshEdges::Pair& pair : edges.pairs) {
    sets.join(pair.one, pair.other, pair.same_winding ? 0 : 1);
  }
  Sheets sheets;
  sheets.of_triangle.resize(triangles);
  sheets.turn.resize(triangles);
  std::vector<std::uint32_t> number(triangles), turned, size;
  for (std::uint32_t t = 0; t < triangles; ++t) {
    const auto [root, sign] = sets.root(t);
    if (root == t) {
      number[t] = static_cast<std::uint32_t>(sheets.count++);
      turned.push_back(0);
      size.push_back(0);
    }
    const std::uint32_t sheet = number[root];
    sheets.of_triangle[t] = sheet;
    sheets.turn[t] = sign;
    turned[sheet] += sign;
    ++size[sheet];
  }
  for (std::uint32_t t = 0; t < triangles; ++t) {
    const std::uint32_t sheet = sheets.of_triangle[t];
    if (2 * turned[sheet] > size[sheet]) sheets.turn[t] ^= 1;
  }
  return sheets;
}

}  // namespace regarment
