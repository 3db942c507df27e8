#include "analysis/edge_places.h"

#include <gtest/gtest.h>

namespace regarment {
namespace {

FoundEdge edge_at(double s) {
  FoundEdge edge;
  edge.s.assign(16, s);
  return edge;
}

GarmentEdge edge_with(const std::string& limb, double s,
                      const std::vector<std::pair<double, double>>& rivals) {
  GarmentEdge edge;
  edge.limb = limb;
  edge.found = edge_at(s);
  for (const auto& [at, weight] : rivals) edge.rivals.push_back({edge_at(at), weight});
  return edge;
}

GarmentEdges edges_of(std::map<std::string, GarmentEdge> named) {
  GarmentEdges out;
  for (const auto& [name, edge] : named) {
    LimbView view{LimbAxis::polar(Vec3::Zero()), {}, {}};
    view.map.s_low = edge.limb == "right_arm" ? 0.5 : 0.0;  // both maps begin at a shoulder
    out.limbs.emplace(edge.limb, view);
  }
  out.edges = std::move(named);
  return out;
}

double at(const EdgePlaces& places, const std::string& name) {
  return places.edges.edges.at(name).found.s.front();
}

TEST(EdgePlaces, OfOneAnswerAreOne) {
  const auto places = edge_places(edges_of({{"waist", edge_with("torso", 1.0, {})}}), 3, 0.1);
  ASSERT_EQ(places.size(), 1U);
  EXPECT_EQ(places[0].weight, 1);
  EXPECT_TRUE(places[0].moved.empty());
}

TEST(EdgePlaces, TakeTheWeightsOfTheEdge) {
  const auto places = edge_places(
      edges_of({{"waist", edge_with("torso", 1.0, {{1.1, 0.3}, {0.9, 0.2}, {0.8, 0.05}})}}), 3,
      0.1);
  ASSERT_EQ(places.size(), 3U);
  // What is too improbable is left out, and the others share its weight.
  EXPECT_NEAR(places[0].weight, 0.45 / 0.95, 1e-12);
  EXPECT_NEAR(places[1].weight, 0.3 / 0.95, 1e-12);
  EXPECT_NEAR(places[2].weight, 0.2 / 0.95, 1e-12);
  EXPECT_EQ(at(places[1], "waist"), 1.1);
  EXPECT_EQ(places[1].moved, std::vector<std::string>{"waist"});
}

TEST(EdgePlaces, KeepWhereTheEdgeWasFoundAsARival) {
  const auto places =
      edge_places(edges_of({{"waist", edge_with("torso", 1.0, {{1.1, 0.3}, {0.9, 0.2}})}}), 3, 0.1);
  const GarmentEdge& moved = places.at(2).edges.edges.at("waist");
  EXPECT_EQ(moved.found.s.front(), 0.9);
  ASSERT_EQ(moved.rivals.size(), 2U);
  EXPECT_EQ(moved.rivals[0].edge.s.front(), 1.0);
  EXPECT_NEAR(moved.rivals[0].weight, 0.5, 1e-12);
  EXPECT_EQ(moved.rivals[1].edge.s.front(), 1.1);
}

TEST(EdgePlaces, ACoveredEdgeStays) {
  GarmentEdges edges = edges_of({{"waist", edge_with("torso", 1.0, {{1.1, 0.4}})}});
  edges.edges.at("waist").covered = true;
  EXPECT_EQ(edge_places(edges, 3, 0.1).size(), 1U);
}

// Both may end 10 cm further down: together this is as probable as one alone is not.
TEST(EdgePlaces, CuffsMoveTogether) {
  const GarmentEdges edges = edges_of({{"left_cuff", edge_with("left_arm", 0.2, {{0.3, 0.4}})},
                                       {"right_cuff", edge_with("right_arm", 0.7, {{0.8, 0.4}})}});
  const auto places = edge_places(edges, 3, 0.1);
  ASSERT_EQ(places.size(), 2U);
  EXPECT_EQ(at(places[1], "left_cuff"), 0.3);
  EXPECT_EQ(at(places[1], "right_cuff"), 0.8);
  EXPECT_EQ(places[1].moved, (std::vector<std::string>{"left_cuff", "right_cuff"}));
  EXPECT_NEAR(places[1].weight / places[0].weight, 0.16 / 0.36, 1e-12);
}

TEST(EdgePlaces, AreAtMostAsManyAsAsked) {
  const auto edges =
      edges_of({{"waist", edge_with("torso", 1.0, {{1.1, 0.2}, {0.9, 0.2}, {0.8, 0.2}})}});
  EXPECT_EQ(edge_places(edges, 2, 0.01).size(), 3U);
}

}  // namespace
}  // namespace regarment
