#include <gtest/gtest.h>

#include <set>

#include "garment_samples.h"

namespace regarment {
namespace {

struct Surface {
  std::map<std::pair<int, int>, int> directed;  // welded edges with their direction, and how often
  std::set<int> particles;
  explicit Surface(const Pattern& pattern) {
    for (const Triangle& t : pattern.triangles)
      for (std::size_t k = 0; k < 3; ++k) {
        const int a = pattern.particle[t[k]], b = pattern.particle[t[(k + 1) % 3]];
        ++directed[{a, b}];
        particles.insert(a);
      }
  }
  int undirected() const {
    std::set<std::pair<int, int>> edges;
    for (const auto& [edge, unused] : directed) edges.insert(std::minmax(edge.first, edge.second));
    return static_cast<int>(edges.size());
  }
  /// Next particle along the border, which runs as its triangles do.
  std::map<int, int> border() const {
    std::map<int, int> next;
    for (const auto& [edge, unused] : directed)
      if (!directed.contains({edge.second, edge.first})) next[edge.first] = edge.second;
    return next;
  }
};

void expect_topology(const std::string& name, double edge_length, int loops) {
  const GarmentTemplate garment = find_template(name);
  const Pattern pattern = make_pattern(garment, garment.typical(), edge_length);
  const Surface surface(pattern);
  for (const auto& [edge, count] : surface.directed) {
    EXPECT_EQ(count, 1);
    EXPECT_NE(edge.first, edge.second);
  }
  EXPECT_EQ(static_cast<int>(surface.particles.size()), pattern.particle_count);
  // A sphere with holes: V - E + F = 2 - loops.
  const int euler =
      pattern.particle_count - surface.undirected() + static_cast<int>(pattern.triangles.size());
  EXPECT_EQ(euler, 2 - loops) << name << " with edges of " << edge_length;

  ASSERT_EQ(static_cast<int>(pattern.edges.size()), loops);
  std::map<int, int> border = surface.border();
  for (const PatternEdge& edge : pattern.edges) {
    ASSERT_EQ(edge.vertices.size(), edge.segments.size());
    for (std::size_t i = 0; i < edge.vertices.size(); ++i) {
      const int from = pattern.particle[static_cast<std::size_t>(edge.vertices[i])];
      const int to =
          pattern.particle[static_cast<std::size_t>(edge.vertices[(i + 1) % edge.vertices.size()])];
      EXPECT_EQ(border.at(from), to) << edge.name;
      border.erase(from);
      EXPECT_EQ(edge.segments[i][0], edge.vertices[i]);
      EXPECT_EQ(pattern.particle[static_cast<std::size_t>(edge.segments[i][1])], to);
      EXPECT_EQ(pattern.panel[static_cast<std::size_t>(edge.segments[i][0])],
                pattern.panel[static_cast<std::size_t>(edge.segments[i][1])]);
    }
  }
  EXPECT_TRUE(border.empty()) << "a border that no edge names";
}

TEST(Sewing, MakesAnAnnulusOfASkirt) {
  for (const double edge_length : {0.5, 0.2, 0.1, 0.07, 0.05, 0.033, 0.02, 0.013})
    expect_topology("skirt", edge_length, 2);
}

TEST(Sewing, MakesASphereWithFourHolesOfAShirt) {
  for (const double edge_length : {0.5, 0.2, 0.1, 0.07, 0.05, 0.033, 0.02, 0.013})
    expect_topology("tshirt", edge_length, 4);
}

TEST(Sewing, NamesTheLoopsAndTheirLimbs) {
  const auto names = [](const std::string& garment) {
    std::map<std::string, std::string> limbs;
    const GarmentTemplate loaded = find_template(garment);
    for (const PatternEdge& edge : make_pattern(loaded, loaded.typical(), 0.05).edges)
      limbs[edge.name] = edge.limb;
    return limbs;
  };
  using Limbs = std::map<std::string, std::string>;
  EXPECT_EQ(names("skirt"), (Limbs{{"waist", "torso"}, {"hem", "torso"}}));
  EXPECT_EQ(names("tshirt"), (Limbs{{"hem", "torso"},
                                    {"neck", "neck"},
                                    {"left_cuff", "left_arm"},
                                    {"right_cuff", "right_arm"}}));
}

TEST(Sewing, WeldsPointsThatLieOnEachOther) {
  // All seams of both garments lie in the same place of the common plane (but for a sleeve too
  // short to be cut on), so every welded vertex has the same s, t in all its panels, and two
  // vertices of one panel are never welded.
  for (const std::string name : {"skirt", "tshirt"}) {
    const GarmentTemplate garment = find_template(name);
    Pattern pattern = make_pattern(garment, garment.typical(), 0.03);
    for (const Dimensions& d : test::possible_dimensions(garment, 20)) {
      if (name == "tshirt" && test::ShirtPoints(d).is_turned) continue;
      move_pattern(garment, d, pattern);
      std::map<int, std::vector<std::size_t>> vertices;
      for (std::size_t v = 0; v < pattern.flat.size(); ++v)
        vertices[pattern.particle[v]].push_back(v);
      std::set<std::size_t> sizes;
      for (const auto& [particle, welded] : vertices) {
        std::set<int> panels;
        for (const std::size_t v : welded) {
          EXPECT_LT((pattern.flat[v] - pattern.flat[welded[0]]).norm(), 1e-12);
          panels.insert(pattern.panel[v]);
        }
        EXPECT_EQ(panels.size(), welded.size());
        sizes.insert(welded.size());
      }
      // Inside; on a seam; where armhole, shoulder and sleeve meet in four panels.
      EXPECT_EQ(sizes,
                name == "skirt" ? (std::set<std::size_t>{1, 2}) : (std::set<std::size_t>{1, 2, 4}));
    }
  }
}

TEST(Sewing, RunsEveryLoopWithTheGarmentOnItsLeft) {
  // Seen from above, x to the wearer's left and z to the front: the front panel has z > 0. The hem
  // of a skirt has the garment above it, so it runs from the wearer's right to the left in front.
  const GarmentTemplate skirt = find_template("skirt");
  const Pattern pattern = make_pattern(skirt, skirt.typical(), 0.05);
  const auto moves_left_in_front = [&](const std::string& name) {
    int left = 0, right = 0;
    for (const auto& segment : edge_named(pattern, name).segments) {
      const auto a = static_cast<std::size_t>(segment[0]), b = static_cast<std::size_t>(segment[1]);
      if (!pattern.panel_is_front[static_cast<std::size_t>(pattern.panel[a])]) continue;
      ++(pattern.flat[b].x() > pattern.flat[a].x() ? left : right);
    }
    EXPECT_TRUE(left == 0 || right == 0);
    return left > 0;
  };
  EXPECT_TRUE(moves_left_in_front("hem"));
  EXPECT_FALSE(moves_left_in_front("waist"));
}

}  // namespace
}  // namespace regarment
