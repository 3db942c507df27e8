#include "segmentation/minimum_cut.h"

#include <boost/graph/boykov_kolmogorov_max_flow.hpp>
#include <boost/graph/compressed_sparse_row_graph.hpp>
#include <boost/property_map/property_map.hpp>
#include <cmath>
#include <string>
#include <utility>

#include "base/error.h"

namespace regarment {
namespace {

constexpr float kScale = 1000;  // integer costs: sums are exact, so their order does not matter
constexpr float kMost = 1e4F;

using Graph =
    boost::compressed_sparse_row_graph<boost::directedS, boost::no_property, boost::no_property,
                                       boost::no_property, std::uint32_t, std::uint32_t>;
using Arc = boost::graph_traits<Graph>::edge_descriptor;

std::int32_t rounded(float cost) { return static_cast<std::int32_t>(std::lround(cost * kScale)); }

void check(std::span<const float> odds, std::span<const CutLink> links) {
  for (std::size_t i = 0; i < odds.size(); ++i)
    if (!(std::abs(odds[i]) <= kMost))
      throw InvalidInput("minimum_cut: the odds of vertex " + std::to_string(i) +
                         " are not finite or above 10000");
  for (const CutLink& link : links)
    if (link.a >= odds.size() || link.b >= odds.size() || !(link.cost >= 0 && link.cost <= kMost))
      throw InvalidInput("minimum_cut: the link of vertices " + std::to_string(link.a) + " and " +
                         std::to_string(link.b) +
                         " leaves the graph, or its cost is not between 0 and 10000");
}

/// Arcs both ways between vertices, a source of label 1 and a sink of label 0, laid out by the
/// vertex they leave.
class Network {
 public:
  Network(std::span<const float> odds, std::span<const CutLink> links)
      : vertices_(static_cast<std::uint32_t>(odds.size()) + 2) {
    for (const CutLink& link : links)
      if (link.a != link.b && rounded(link.cost) > 0)
        pairs_.push_back({link.a, link.b, rounded(link.cost), rounded(link.cost)});
    for (std::uint32_t i = 0; i < odds.size(); ++i) {
      if (odds[i] > 0) pairs_.push_back({source(), i, rounded(odds[i]), 0});
      if (odds[i] < 0) pairs_.push_back({i, sink(), rounded(-odds[i]), 0});
    }
    lay_out();
  }

  std::uint32_t source() const { return vertices_ - 2; }
  std::uint32_t sink() const { return vertices_ - 1; }

  /// Which side of the cut each vertex lies on: 1 where the source still reaches it.
  std::vector<std::uint8_t> cut() {
    const Graph graph(boost::edges_are_sorted, ends_.begin(), ends_.end(), vertices_,
                      static_cast<std::uint32_t>(ends_.size()));
    const auto arc_index = boost::get(boost::edge_index, graph);
    const auto vertex_index = boost::get(boost::vertex_index, graph);
    std::vector<std::int32_t> residual = capacity_;
    std::vector<Arc> predecessor(vertices_);
    std::vector<boost::default_color_type> side(vertices_, boost::gray_color);
    std::vector<std::int32_t> distance(vertices_, 0);
    const auto by_arc = [&](auto& values) {
      return boost::make_iterator_property_map(values.begin(), arc_index);
    };
    const auto by_vertex = [&](auto& values) {
      return boost::make_iterator_property_map(values.begin(), vertex_index);
    };
    boost::boykov_kolmogorov_max_flow(graph, by_arc(capacity_), by_arc(residual), by_arc(reverse_),
                                      by_vertex(predecessor), by_vertex(side), by_vertex(distance),
                                      vertex_index, source(), sink());
    std::vector<std::uint8_t> label(vertices_ - 2);
    for (std::size_t i = 0; i < label.size(); ++i) label[i] = side[i] == boost::black_color;
    return label;
  }

 private:
  struct Pair {
    std::uint32_t a, b;
    std::int32_t forth, back;
  };

  void lay_out() {
    std::vector<std::uint32_t> next(vertices_ + 1, 0);
    for (const Pair& p : pairs_) ++next[p.a + 1], ++next[p.b + 1];
    for (std::size_t v = 0; v < vertices_; ++v) next[v + 1] += next[v];
    ends_.resize(2 * pairs_.size());
    capacity_.resize(ends_.size());
    reverse_.resize(ends_.size());
    for (const Pair& p : pairs_) {
      const std::uint32_t forth = next[p.a]++, back = next[p.b]++;
      ends_[forth] = {p.a, p.b}, capacity_[forth] = p.forth, reverse_[forth] = Arc(p.b, back);
      ends_[back] = {p.b, p.a}, capacity_[back] = p.back, reverse_[back] = Arc(p.a, forth);
    }
  }

  std::uint32_t vertices_;
  std::vector<Pair> pairs_;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> ends_;  // of each arc, sorted by the first
  std::vector<std::int32_t> capacity_;
  std::vector<Arc> reverse_;  // the arc that goes the other way
};

}  // namespace

std::vector<std::uint8_t> minimum_cut(std::span<const float> odds, std::span<const CutLink> links) {
  check(odds, links);
  return Network(odds, links).cut();
}

}  // namespace regarment
