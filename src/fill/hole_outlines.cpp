#include "fill/hole_outlines.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace regarment {
namespace {

// A border this near to an open edge of the garment may be the scan's natural end there, m.
constexpr double kBand = 0.025;
// The scan's border may end as far from the garment's edge, m: an edge is seldom missed by more.
constexpr double kReach = 0.06;
// A border goes backwards along an edge when it does by more than this, m: less is a jag.
constexpr double kBackwards = 0.01;
// Fewer border vertices of another label in a row are a slip of the labels.
constexpr std::size_t kLeastOthers = 4;
// An outline that would follow an edge for more than this share of it has lost its way.
constexpr double kMostOfEdge = 0.75;

constexpr int kFar = -1;

/// What is known of one vertex of a border loop.
struct Stop {
  int edge = kFar;  // nearest open edge of the garment, when within kBand
  double along = 0, distance = 0;
  bool kept = true;  // part of a hole's outline
};

struct EdgePlace {
  std::size_t edge = 0;
  double distance = std::numeric_limits<double>::infinity(), along = 0;
};

EdgePlace nearest_edge(const std::vector<EdgeLoop>& edges, const Vec3& p) {
  EdgePlace best;
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const EdgeLoop::Place place = edges[e].nearest(p);
    if (place.distance < best.distance) best = {e, place.distance, place.along};
  }
  return best;
}

/// A chain of stops of one kind, cyclic: [begin, begin + count).
struct Chain {
  std::size_t begin = 0, count = 0;
};

/// Maximal cyclic chains of stops of which `same(a, b)` of neighbours holds.
template <class Same>
std::vector<Chain> chains(std::size_t n, Same&& same) {
  std::size_t start = n;
  for (std::size_t i = 0; i < n && start == n; ++i)
    if (!same((i + n - 1) % n, i)) start = i;
  if (start == n) return {{0, n}};
  std::vector<Chain> out;
  for (std::size_t k = 0; k < n; ++k) {
    const std::size_t i = (start + k) % n;
    if (k == 0 || !same((i + n - 1) % n, i)) out.push_back({i, 0});
    ++out.back().count;
  }
  return out;
}

/// Leaves out what follows an open edge backwards.
void leave_natural_ends(const std::vector<EdgeLoop>& edges, std::vector<Stop>& stops) {
  const std::size_t n = stops.size();
  const auto same = [&](std::size_t a, std::size_t b) { return stops[a].edge == stops[b].edge; };
  for (const Chain& chain : chains(n, same)) {
    const int edge = stops[chain.begin].edge;
    if (edge == kFar) continue;
    double advance = 0;
    const std::size_t steps = chain.count == n ? n : chain.count - 1;
    for (std::size_t k = 0; k < steps; ++k)
      advance += edges[static_cast<std::size_t>(edge)].step(stops[(chain.begin + k) % n].along,
                                                            stops[(chain.begin + k + 1) % n].along);
    if (advance >= -kBackwards) continue;
    for (std::size_t k = 0; k < chain.count; ++k) stops[(chain.begin + k) % n].kept = false;
  }
}

/// Leaves out border that belongs to others.
void leave_others(const HoleSearch& search, const std::vector<std::uint32_t>& loop,
                  std::vector<Stop>& stops) {
  const std::size_t n = stops.size();
  const auto own = [&](std::size_t i) { return search.labels[loop[i]] == search.label; };
  for (const Chain& chain : chains(n, [&](auto a, auto b) { return own(a) == own(b); })) {
    if (own(chain.begin) || (chain.count < kLeastOthers && chain.count < n)) continue;
    for (std::size_t k = 0; k < chain.count; ++k) stops[(chain.begin + k) % n].kept = false;
  }
}

std::vector<Stop> stops_of(const HoleSearch& search, const std::vector<std::uint32_t>& loop) {
  std::vector<Stop> stops;
  for (const std::uint32_t v : loop) {
    const EdgePlace place = nearest_edge(search.edges, search.positions[v]);
    if (place.distance <= kBand)
      stops.push_back({static_cast<int>(place.edge), place.along, place.distance, true});
    else
      stops.push_back({});
  }
  leave_natural_ends(search.edges, stops);
  leave_others(search, loop, stops);
  return stops;
}

/// Part of a hole's outline between two places on the garment's open edges.
struct Run {
  std::vector<std::uint32_t> vertices;
  EdgePlace first, last;
  bool used = false;
};

/// How many stops beyond `end`, going on by `step` (1, or n - 1 for backwards), still lead to the
/// garment's edge rather than along it: up to the one nearest to it.
std::size_t way_to_edge(const std::vector<EdgeLoop>& edges, const std::vector<Stop>& stops,
                        std::size_t end, std::size_t step, std::size_t most) {
  const std::size_t n = stops.size();
  double along = 0, least = std::numeric_limits<double>::infinity();
  std::size_t best = 0;
  for (std::size_t k = 1; k <= most; ++k) {
    const std::size_t i = (end + k * step) % n, before = (end + (k - 1) * step) % n;
    if (stops[i].edge == kFar) break;
    if (k > 1 && stops[i].edge == stops[before].edge)
      along +=
          edges[static_cast<std::size_t>(stops[i].edge)].step(stops[before].along, stops[i].along);
    if (std::abs(along) > kBackwards) break;
    if (stops[i].distance < least) least = stops[i].distance, best = k;
  }
  return best;
}

void add_runs(const HoleSearch& search, const std::vector<std::uint32_t>& loop,
              const std::vector<Stop>& stops, std::vector<Run>& runs) {
  const std::size_t n = loop.size();
  const auto same = [&](std::size_t a, std::size_t b) { return stops[a].kept == stops[b].kept; };
  for (const Chain& chain : chains(n, same)) {
    if (!stops[chain.begin].kept || chain.count < 2) continue;
    const std::size_t end = (chain.begin + chain.count - 1) % n, most = (n - chain.count) / 2;
    const std::size_t before = way_to_edge(search.edges, stops, chain.begin, n - 1, most);
    const std::size_t after = way_to_edge(search.edges, stops, end, 1, most);
    Run run;
    for (std::size_t k = 0; k < before + chain.count + after; ++k)
      run.vertices.push_back(loop[(chain.begin + n - before + k) % n]);
    run.first = nearest_edge(search.edges, search.positions[run.vertices.front()]);
    run.last = nearest_edge(search.edges, search.positions[run.vertices.back()]);
    if (run.first.distance <= kReach && run.last.distance <= kReach) runs.push_back(std::move(run));
  }
}

HoleOutline closed_outline(const HoleSearch& search, const std::vector<std::uint32_t>& vertices) {
  HoleOutline out;
  for (const std::uint32_t v : vertices) out.points.push_back(search.positions[v]);
  out.vertices = vertices;
  return out;
}

/// The run that begins nearest ahead of where `run` ends; null when there is none.
Run* next_run(const HoleSearch& search, const Run& run, std::vector<Run>& runs) {
  Run* best = nullptr;
  double least = kMostOfEdge * search.edges[run.last.edge].length();
  for (Run& other : runs) {
    if (other.first.edge != run.last.edge) continue;
    const double gap = search.edges[run.last.edge].ahead(run.last.along, other.first.along);
    if (gap <= least) least = gap, best = &other;
  }
  return best;
}

double mean_step(const HoleOutline& outline) {
  double sum = 0;
  for (std::size_t i = 1; i < outline.points.size(); ++i)
    sum += (outline.points[i] - outline.points[i - 1]).norm();
  return sum / static_cast<double>(outline.points.size() - 1);
}

/// New points on the garment's edge between the end of one run and the begin of the next, where
/// these do not lie on it themselves.
void follow_edge(const EdgeLoop& edge, const EdgePlace& from, const EdgePlace& to, double spacing,
                 HoleOutline& out) {
  const double gap = edge.ahead(from.along, to.along);
  const int pieces = std::max(1, static_cast<int>(std::lround(gap / spacing)));
  for (int k = 0; k <= pieces; ++k) {
    const bool at_end =
        (k == 0 && from.distance < spacing / 2) || (k == pieces && to.distance < spacing / 2);
    if (at_end) continue;
    out.points.push_back(edge.at(from.along + gap * k / pieces));
    out.vertices.push_back(HoleOutline::kNew);
  }
}

/// The outline that begins with `first`; empty when it does not come back to it.
HoleOutline joined_outline(const HoleSearch& search, Run& first, std::vector<Run>& runs) {
  HoleOutline out;
  for (Run* run = &first; run != nullptr && !run->used;) {
    run->used = true;
    for (const std::uint32_t v : run->vertices) {
      out.points.push_back(search.positions[v]);
      out.vertices.push_back(v);
    }
    Run* next = next_run(search, *run, runs);
    if (next == nullptr || (next->used && next != &first)) return {};
    follow_edge(search.edges[run->last.edge], run->last, next->first,
                std::max(1e-4, mean_step(out)), out);
    if (next == &first) return out;
    run = next;
  }
  return {};
}

}  // namespace

std::vector<HoleOutline> hole_outlines(const HoleSearch& search) {
  std::vector<HoleOutline> out;
  std::vector<Run> runs;
  for (const std::vector<std::uint32_t>& loop : search.loops) {
    const auto own = std::count_if(loop.begin(), loop.end(), [&](std::uint32_t v) {
      return search.labels[v] == search.label;
    });
    if (own == 0) continue;
    const std::vector<Stop> stops = stops_of(search, loop);
    if (std::all_of(stops.begin(), stops.end(), [](const Stop& s) { return s.kept; }))
      out.push_back(closed_outline(search, loop));
    else
      add_runs(search, loop, stops, runs);
  }
  for (Run& run : runs) {
    if (run.used) continue;
    HoleOutline outline = joined_outline(search, run, runs);
    if (!outline.points.empty()) out.push_back(std::move(outline));
  }
  return out;
}

}  // namespace regarment
