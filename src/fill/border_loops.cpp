#include "fill/border_loops.h"

#include <algorithm>
#include <numeric>
#include <optional>
#include <tuple>

namespace regarment {
namespace {

/// A triangle's edge from its corner `corner` to the next one.
struct HalfEdge {
  std::uint32_t from = 0, to = 0;
  std::uint32_t triangle = 0;
  std::uint8_t corner = 0;

  bool operator<(const HalfEdge& other) const {
    return std::tie(from, to, triangle) < std::tie(other.from, other.to, other.triangle);
  }
};

/// All half-edges of a mesh, by their ends.
class HalfEdges {
 public:
  HalfEdges(std::span<const Triangle> triangles, std::size_t vertices)
      : triangles_(triangles), edges_(3 * triangles.size()), start_(vertices + 1, 0) {
    for (const Triangle& t : triangles)
      for (const std::uint32_t v : t) ++start_[v + 1];
    std::partial_sum(start_.begin(), start_.end(), start_.begin());
    std::vector<std::size_t> next(start_.begin(), start_.end() - 1);
    for (std::uint32_t t = 0; t < triangles.size(); ++t)
      for (std::uint8_t k = 0; k < 3; ++k) edges_[next[triangles[t][k]]++] = of(t, k);
    for (std::size_t v = 0; v < vertices; ++v)
      std::sort(edges_.begin() + static_cast<std::ptrdiff_t>(start_[v]),
                edges_.begin() + static_cast<std::ptrdiff_t>(start_[v + 1]));
  }

  const std::vector<HalfEdge>& all() const { return edges_; }

  HalfEdge of(std::uint32_t triangle, int corner) const {
    const Triangle& t = triangles_[triangle];
    return {t[corner % 3], t[(corner + 1) % 3], triangle, static_cast<std::uint8_t>(corner % 3)};
  }

  HalfEdge after(const HalfEdge& edge) const { return of(edge.triangle, edge.corner + 1); }

  std::span<const HalfEdge> between(std::uint32_t from, std::uint32_t to) const {
    // By halves: any number of triangles may share a vertex.
    const auto last = edges_.begin() + static_cast<std::ptrdiff_t>(start_[from + 1]);
    const auto begin = std::lower_bound(edges_.begin() + static_cast<std::ptrdiff_t>(start_[from]),
                                        last, HalfEdge{from, to, 0, 0});
    auto end = begin;
    while (end != last && end->to == to) ++end;
    return {begin, end};
  }

  bool is_border(const HalfEdge& edge) const { return between(edge.to, edge.from).empty(); }

  /// The border edge that goes on where a border edge ends, found round that vertex; nothing where
  /// the mesh is not a surface.
  std::optional<HalfEdge> next_border(const HalfEdge& border) const {
    HalfEdge edge = after(border);
    for (std::size_t turned = 0; turned <= triangles_.size(); ++turned) {
      const auto across = between(edge.to, edge.from);
      if (between(edge.from, edge.to).size() > 1 || across.size() > 1) return std::nullopt;
      if (across.empty()) return edge;
      edge = after(across[0]);
    }
    return std::nullopt;
  }

 private:
  std::span<const Triangle> triangles_;
  std::vector<HalfEdge> edges_;     // sorted
  std::vector<std::size_t> start_;  // where those from each vertex begin; one more
};

/// Loops through distinct vertices, for a loop that may pass some more than once.
void take_apart(const std::vector<std::uint32_t>& loop, std::vector<std::uint8_t>& on_way,
                std::vector<std::vector<std::uint32_t>>& out) {
  constexpr std::size_t kLeast = 3;
  std::vector<std::uint32_t> way;
  const auto emit = [&](auto begin, auto end) {
    if (static_cast<std::size_t>(end - begin) >= kLeast) out.emplace_back(begin, end);
  };
  for (const std::uint32_t v : loop) {
    if (on_way[v] != 0) {
      const auto begin = std::find(way.begin(), way.end(), v);
      emit(begin, way.end());
      for (auto w = begin; w != way.end(); ++w) on_way[*w] = 0;
      way.erase(begin, way.end());
    }
    on_way[v] = 1;
    way.push_back(v);
  }
  for (const std::uint32_t v : way) on_way[v] = 0;
  emit(way.begin(), way.end());
}

}  // namespace

std::vector<std::vector<std::uint32_t>> border_loops(std::span<const Triangle> triangles,
                                                     std::size_t vertices) {
  const HalfEdges edges(triangles, vertices);
  std::vector<std::uint8_t> seen(3 * triangles.size(), 0), on_way(vertices, 0);
  const auto slot = [](const HalfEdge& e) { return 3 * std::size_t{e.triangle} + e.corner; };
  std::vector<std::vector<std::uint32_t>> out;
  for (const HalfEdge& first : edges.all()) {
    if (seen[slot(first)] != 0 || !edges.is_border(first)) continue;
    std::vector<std::uint32_t> loop;
    std::optional<HalfEdge> edge = first;
    while (edge && seen[slot(*edge)] == 0) {
      seen[slot(*edge)] = 1;
      loop.push_back(edge->from);
      edge = edges.next_border(*edge);
    }
    if (!edge || slot(*edge) != slot(first)) continue;
    std::reverse(loop.begin(), loop.end());
    take_apart(loop, on_way, out);
  }
  return out;
}

}  // namespace regarment
