#include "garment/sewing.h"

#include <algorithm>
#include <numeric>

#include "base/error.h"

namespace regarment {

namespace {

std::size_t index(int i) { return static_cast<std::size_t>(i); }

const PanelData& panel_of(const TemplateData& data, int panel) { return data.panels[index(panel)]; }

int halves(const TemplateData& data, int panel) {
  return data.shapes[index(panel_of(data, panel).shape)].on_fold ? 2 : 1;
}

/// Pattern vertex of each vertex of a panel's shape: [panel][half][shape vertex]. The second half
/// shares the vertices on the fold.
std::vector<std::array<std::vector<int>, 2>> number_vertices(const TemplateData& data,
                                                             const std::vector<ShapeMesh>& shapes) {
  std::vector<std::array<std::vector<int>, 2>> numbers(data.panels.size());
  int next = 0;
  for (std::size_t p = 0; p < data.panels.size(); ++p) {
    const ShapeMesh& mesh = shapes[index(data.panels[p].shape)];
    for (int half = 0; half < halves(data, static_cast<int>(p)); ++half)
      for (std::size_t v = 0; v < mesh.coarse.size(); ++v) {
        const bool shared = half == 1 && mesh.on_fold[v];
        numbers[p][index(half)].push_back(shared ? numbers[p][0][v] : next++);
      }
  }
  return numbers;
}

void add_panel(const TemplateData& data, int p, const ShapeMesh& mesh,
               const std::array<std::vector<int>, 2>& numbers, const std::array<int, 2>& offsets,
               Pattern& pattern) {
  const PanelData& panel = panel_of(data, p);
  pattern.panel_names.push_back(panel.name);
  pattern.panel_limbs.push_back(panel.limb);
  pattern.panel_is_front.push_back(panel.is_front);
  for (int half = 0; half < halves(data, p); ++half) {
    for (std::size_t v = 0; v < mesh.coarse.size(); ++v) {
      if (half == 1 && mesh.on_fold[v]) continue;
      std::array<int, 3> coarse = mesh.coarse[v];
      for (int& point : coarse) point += offsets[index(half)];
      pattern.coarse_points.push_back(coarse);
      pattern.barycentric.push_back(mesh.weights[v]);
      pattern.panel.push_back(p);
    }
    for (const auto& corners : mesh.triangles) {
      Triangle triangle;
      for (std::size_t k = 0; k < 3; ++k)
        triangle[k] = static_cast<std::uint32_t>(numbers[index(half)][index(corners[k])]);
      if (is_turned(panel, half)) std::swap(triangle[1], triangle[2]);
      pattern.triangles.push_back(triangle);
    }
  }
}

/// Vertices along one side of a seam or a free edge, in the direction that has the panel on its
/// left, seen from outside.
std::vector<int> along(const TemplateData& data, const std::vector<ShapeMesh>& shapes,
                       const std::vector<std::array<std::vector<int>, 2>>& numbers,
                       const EdgeRef& ref) {
  const PanelData& panel = panel_of(data, ref.panel);
  std::vector<int> vertices;
  for (const int v : shapes[index(panel.shape)].edges[index(ref.edge)])
    vertices.push_back(numbers[index(ref.panel)][index(ref.half)][index(v)]);
  if (!has_panel_on_left(data, ref)) std::reverse(vertices.begin(), vertices.end());
  return vertices;
}

int find(std::vector<int>& parents, int i) {
  while (parents[index(i)] != i) {
    parents[index(i)] = parents[index(parents[index(i)])];
    i = parents[index(i)];
  }
  return i;
}

/// Joins the vertices of all seams; the two sides run in opposite directions.
void weld(const TemplateData& data, const std::vector<ShapeMesh>& shapes,
          const std::vector<std::array<std::vector<int>, 2>>& numbers, Pattern& pattern) {
  std::vector<int> parents(pattern.panel.size());
  std::iota(parents.begin(), parents.end(), 0);
  for (const auto& seam : data.seams) {
    const std::vector<int> a = along(data, shapes, numbers, seam[0]);
    const std::vector<int> b = along(data, shapes, numbers, seam[1]);
    if (a.size() != b.size()) throw InvalidInput("the two sides of a seam are divided differently");
    for (std::size_t i = 0; i < a.size(); ++i) {
      const int first = find(parents, a[i]), second = find(parents, b[b.size() - 1 - i]);
      parents[index(std::max(first, second))] = std::min(first, second);
    }
  }
  pattern.particle.assign(parents.size(), -1);
  for (int v = 0; v < static_cast<int>(parents.size()); ++v) {
    const int root = find(parents, v);
    pattern.particle[index(v)] =
        root == v ? pattern.particle_count++ : pattern.particle[index(root)];
  }
}

/// Every edge is used at most once in each direction, which makes an oriented surface.
std::map<std::pair<int, int>, int> count_directed_edges(const Pattern& pattern) {
  std::map<std::pair<int, int>, int> count;
  for (const Triangle& triangle : pattern.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const int a = pattern.particle[triangle[k]], b = pattern.particle[triangle[(k + 1) % 3]];
      if (a == b) throw InvalidInput("a seam joins the two ends of a triangle's side");
      if (++count[{a, b}] > 1)
        throw InvalidInput(
            "the sewn panels are no surface: an edge has three triangles, or a seam "
            "joins two panels with opposite faces");
    }
  }
  return count;
}

PatternEdge find_loop(const TemplateData& data, const std::vector<ShapeMesh>& shapes,
                      const std::vector<std::array<std::vector<int>, 2>>& numbers,
                      const FreeEdge& edge, const Pattern& pattern) {
  std::map<int, std::array<int, 2>> segment_from;  // by the particle it starts at
  int start = -1;
  for (const EdgeRef& ref : edge.parts) {
    const std::vector<int> vertices = along(data, shapes, numbers, ref);
    if (start < 0) start = pattern.particle[index(vertices.front())];
    for (std::size_t i = 0; i + 1 < vertices.size(); ++i) {
      const int particle = pattern.particle[index(vertices[i])];
      if (!segment_from.insert({particle, {vertices[i], vertices[i + 1]}}).second)
        throw InvalidInput("the free edge '" + edge.name + "' branches");
    }
  }
  PatternEdge loop{edge.name, edge.limb, {}, {}};
  for (int particle = start;;) {
    const auto segment = segment_from.find(particle);
    if (segment == segment_from.end())
      throw InvalidInput("the free edge '" + edge.name + "' is not one closed loop");
    loop.vertices.push_back(segment->second[0]);
    loop.segments.push_back(segment->second);
    particle = pattern.particle[index(segment->second[1])];
    segment_from.erase(segment);
    if (particle == start) break;
  }
  if (!segment_from.empty())
    throw InvalidInput("the free edge '" + edge.name + "' is more than one closed loop");
  return loop;
}

/// The border of the surface must be the free edges and nothing else, no two of them touching.
void check_border(const Pattern& pattern) {
  const auto count = count_directed_edges(pattern);
  std::size_t border = 0, named = 0;
  for (const auto& [edge, unused] : count)
    if (!count.contains({edge.second, edge.first})) ++border;
  std::vector<bool> seen(index(pattern.particle_count), false);
  for (const PatternEdge& edge : pattern.edges) {
    named += edge.vertices.size();
    for (const int v : edge.vertices) {
      const int particle = pattern.particle[index(v)];
      if (seen[index(particle)]) throw InvalidInput("two free edges meet at a point");
      seen[index(particle)] = true;
    }
  }
  if (border != named) throw InvalidInput("the border of the sewn garment is not its free edges");
}

}  // namespace

std::vector<std::array<int, 2>> coarse_offsets(const TemplateData& data) {
  std::vector<std::array<int, 2>> offsets;
  int next = 0;
  for (std::size_t p = 0; p < data.panels.size(); ++p) {
    const ShapeData& shape = data.shapes[index(data.panels[p].shape)];
    std::size_t points = shape.vertices.size() + shape.points.size();
    for (const ShapeEdge& edge : shape.edges)
      points += edge.curvature ? index(edge.curvature->segments - 1) : 0;
    offsets.push_back({next, shape.on_fold ? next + static_cast<int>(points) : next});
    next = offsets.back()[1] + static_cast<int>(points);
  }
  return offsets;
}

Pattern sew(const TemplateData& data, const std::vector<ShapeMesh>& shapes) {
  Pattern pattern;
  const auto numbers = number_vertices(data, shapes);
  const auto offsets = coarse_offsets(data);
  for (int p = 0; p < static_cast<int>(data.panels.size()); ++p)
    add_panel(data, p, shapes[index(panel_of(data, p).shape)], numbers[index(p)], offsets[index(p)],
              pattern);
  weld(data, shapes, numbers, pattern);
  for (const FreeEdge& edge : data.free_edges)
    pattern.edges.push_back(find_loop(data, shapes, numbers, edge, pattern));
  check_border(pattern);
  return pattern;
}

}  // namespace regarment
