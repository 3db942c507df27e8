#include "measure/judge_edges.h"

#include <gtest/gtest.h>

#include "base/error.h"

namespace regarment {
namespace {

GarmentEdge edge(const char* limb, bool above, double at, double coverage, double score,
                 double contrast = 0) {
  GarmentEdge out;
  out.limb = limb, out.garment_above = above;
  out.found.s.assign(16, at), out.found.coverage = coverage, out.found.score = score;
  out.found.contrast = contrast;
  return out;
}

/// Edges of somebody whose legs join at 0.8 m, or in a skirt at 0.5 m.
struct Case {
  GarmentEdges edges;
  Body body;
  std::map<std::string, double> said;

  explicit Case(bool in_skirt) {
    body.height = 1.75, body.fork = in_skirt ? 0.5 : 0.8, body.fork_is_garment = in_skirt;
  }
  Case& add(const char* name, GarmentEdge e) {
    edges.upper_body = edges.upper_body || e.limb != "torso";
    edges.edges[name] = std::move(e);
    return *this;
  }
  Case& torso(const char* name, double at, double coverage, double score, double contrast = 0) {
    return add(name, edge("torso", std::string(name) == "hem", at, coverage, score, contrast));
  }
  Case& waist_of_other(double at, double coverage, double score) {
    edges.top_of_other = edge("torso", false, at, coverage, score).found;
    return *this;
  }
  Case& cuffs(double coverage, double score, double contrast = 0) {
    add("left_cuff", edge("left_arm", false, 0.1, coverage, score, contrast));
    return add("right_cuff", edge("right_arm", false, 0.1, coverage, score, contrast));
  }
  bool worn() const {
    try {
      judge_edges(edges, body, "garment", said);
      return true;
    } catch (const NoGarmentError& error) {
      message = error.what();
      return false;
    }
  }
  mutable std::string message;
};

TEST(JudgeSkirt, AHemThatJoinsTheLegsExcusesAFaintWaist) {
  EXPECT_TRUE(Case(true).torso("hem", 0.52, 1, 1).torso("waist", 1, 0.5, 0.4).worn());
  const Case naked = Case(false).torso("hem", 0.84, 0.85, 0.9).torso("waist", 1, 0.5, 0.4);
  EXPECT_FALSE(naked.worn());
  EXPECT_NE(naked.message.find("its waist shows on 50 % of the loop"), std::string::npos);
  EXPECT_FALSE(Case(true).torso("hem", 0.52, 0.5, 0.4).torso("waist", 1, 1, 1).worn());
  EXPECT_FALSE(Case(true).torso("hem", 0.9, 1, 1).torso("waist", 1, 0.5, 0.4).worn());
}

TEST(JudgeSkirt, AMiniNeedsBothEdges) {
  EXPECT_TRUE(Case(false).torso("hem", 0.82, 0.9, 1).torso("waist", 1, 0.9, 0.9).worn());
  EXPECT_FALSE(Case(false).torso("hem", 0.82, 0.5, 0.6).torso("waist", 1, 0.9, 0.9).worn());
}

TEST(JudgeEdges, WhatWasSaidOrIsCoveredNeedNotShow) {
  Case said = Case(false).torso("hem", 0.7, 0.9, 0.9).torso("waist", 1, 0.3, 0.2);
  EXPECT_FALSE(said.worn());
  said.said["waist"] = 1;
  EXPECT_TRUE(said.worn());
  Case covered = Case(false).torso("hem", 0.7, 0.9, 0.9).torso("waist", 1, 0.3, 0.2);
  covered.edges.edges["waist"].covered = true;
  EXPECT_TRUE(covered.worn());
}

TEST(JudgeTshirt, NeedsHemAndSleevesUnlessOneIsBeyondDoubt) {
  EXPECT_TRUE(Case(false).torso("hem", 1, 0.84, 0.97).cuffs(0.9, 0.9).worn());
  EXPECT_FALSE(Case(false).torso("hem", 1, 0.9, 0.9).cuffs(0.9, 0.9).worn());
  EXPECT_TRUE(Case(false).torso("hem", 1, 0.95, 1.1).cuffs(0.6, 0.55).worn());
  EXPECT_TRUE(Case(false).torso("hem", 1, 0.65, 0.9).cuffs(0.7, 1.1).worn());
  EXPECT_FALSE(Case(false).torso("hem", 1, 0.9, 0.9).cuffs(0.6, 0.7).worn());
  EXPECT_FALSE(Case(false).torso("hem", 1, 0.95, 1.1).cuffs(0.6, 0.4).worn());
  const Case naked = Case(false).torso("hem", 1, 0.7, 0.7).cuffs(0.9, 0.9);
  EXPECT_FALSE(naked.worn());
  EXPECT_NE(naked.message.find("its hem shows"), std::string::npos);
}

TEST(JudgeTshirt, FoldsOfASleeveProveItToo) {
  Case faint = Case(false).torso("hem", 1, 0.9, 0.9).cuffs(0.6, 0.4);
  EXPECT_FALSE(faint.worn());
  for (const char* cuff : {"left_cuff", "right_cuff"})
    faint.edges.edges[cuff].clearest = edge("left_arm", false, 0.05, 0.9, 1.1).found;
  EXPECT_TRUE(faint.worn());
}

TEST(JudgeTshirt, ACrotchWithElbowsIsNone) {
  EXPECT_FALSE(Case(false).torso("hem", 0.85, 0.95, 0.95).cuffs(0.9, 0.9).worn());
  EXPECT_TRUE(Case(false).torso("hem", 0.85, 0.95, 1.3).cuffs(0.9, 0.9).worn());
  EXPECT_FALSE(Case(false).torso("hem", 0.85, 1, 1.3).cuffs(0.7, 0.9).worn());
  EXPECT_TRUE(Case(false).torso("hem", 0.85, 0.9, 0.9).cuffs(1, 1.2).worn());
  EXPECT_TRUE(Case(false).torso("hem", 0.85, 1, 1.6).cuffs(0.7, 0.9).worn());
}

TEST(JudgeTshirt, AHemThatJoinsTheLegsIsNoCrotch) {
  EXPECT_TRUE(Case(true).torso("hem", 0.52, 0.9, 0.96).cuffs(0.9, 0.9).worn());
  EXPECT_FALSE(Case(false).torso("hem", 0.82, 0.9, 0.96).cuffs(0.9, 0.9).worn());
}

// The side that lies higher is the cloth: at its top edge a skirt looks more like a top edge, at
// its hem a T-shirt more like a hem.
TEST(JudgeTshirt, ASkirtsTopEdgeIsNoHem) {
  const auto seen_as = [](double hem, double top) {
    return Case(false).torso("hem", 1, 1, hem).cuffs(1, 1.1).waist_of_other(1.02, 1, top);
  };
  EXPECT_TRUE(seen_as(1.5, 1.3).worn());
  const Case skirt = seen_as(1.3, 1.5);
  EXPECT_FALSE(skirt.worn());
  EXPECT_NE(skirt.message.find("102 cm above the floor it shows the top edge"), std::string::npos);
}

TEST(JudgeTshirt, AWaistBetweenHemAndSleevesIsASkirts) {
  const auto with_waist = [](double coverage, double score) {
    return Case(true).torso("hem", 0.52, 1, 1.2).cuffs(0.9, 0.9).waist_of_other(1, coverage, score);
  };
  EXPECT_FALSE(with_waist(0.95, 0.8).worn());
  EXPECT_TRUE(with_waist(0.95, 0.4).worn());  // what bodies and folds show
  EXPECT_TRUE(with_waist(0.5, 0.8).worn());
}

TEST(JudgeTshirt, SleevesBeyondDoubtProveAShirtWhateverElseThereIs) {
  Case both = Case(true).torso("hem", 0.52, 1, 1.2).cuffs(1, 1.8).waist_of_other(1, 1, 0.8);
  EXPECT_TRUE(both.worn());
}

TEST(JudgeTshirt, ColourThatEndsAtTheHemEndsAtTheSleeves) {
  EXPECT_TRUE(Case(false).torso("hem", 1, 1, 1.8, 0.5).cuffs(0.9, 1.5, 0.5).worn());
  const Case skirt = Case(false).torso("hem", 1, 1, 1.8, 0.5).cuffs(0.9, 0.9, 0.02);
  EXPECT_FALSE(skirt.worn());
  EXPECT_NE(skirt.message.find("neither sleeve"), std::string::npos);
}

TEST(JudgeEdges, AnEdgeWithoutDataIsMissing) {
  Case none = Case(false).torso("hem", 0.8, 1, 1).torso("waist", 1, 1, 1);
  none.edges.edges["waist"].found = FoundEdge{};
  EXPECT_FALSE(none.worn());
  EXPECT_NE(none.message.find("no data where its waist would be"), std::string::npos);
}

}  // namespace
}  // namespace regarment
