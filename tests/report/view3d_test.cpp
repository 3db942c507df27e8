#include "report/view3d.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "analyses.h"
#include "base/error.h"

namespace regarment {
namespace {

using Json = nlohmann::json;

std::string decoded(const std::string& text) {
  const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  unsigned bits = 0, count = 0;
  for (const char c : text) {
    if (c == '=') break;
    bits = bits << 6u | static_cast<unsigned>(digits.find(c));
    count += 6;
    if (count >= 8) {
      count -= 8;
      out += static_cast<char>(bits >> count & 0xffu);
    }
  }
  return out;
}

unsigned byte_at(const std::string& bytes, std::size_t i) {
  return static_cast<unsigned char>(bytes[i]);
}

unsigned word_at(const std::string& bytes, std::size_t i) {
  return byte_at(bytes, 2 * i) | byte_at(bytes, 2 * i + 1) << 8u;
}

class View3d : public testing::Test {
 protected:
  Json view() const { return Json::parse(view_json(analysis_)); }
  /// Point `i` of a part, m, in the body frame.
  static Vec3 point(const Json& view, const Json& part, std::size_t i) {
    const std::string bytes = decoded(part.at("points"));
    Vec3 p;
    for (int k = 0; k < 3; ++k) {
      p[k] = double(view["low"][k]) +
             word_at(bytes, 3 * i + std::size_t(k)) / 65535.0 * double(view["size"][k]);
    }
    return p;
  }

  GarmentTemplate skirt_ = find_template("skirt");
  Analysis analysis_ = column_analysis(skirt_);
};

TEST_F(View3d, PointsLieWhereTheyDo) {
  const Json json = view();
  const auto& scan = analysis_.scan.mesh;
  const auto& draped = analysis_.garments[0].draped;
  ASSERT_EQ(decoded(json["scan"]["points"]).size(), 6 * scan.positions.size());
  ASSERT_EQ(decoded(json["garments"][0]["points"]).size(), 6 * draped.size());
  const double step = 2.0 / 65535.0;  // m: of the largest side
  for (std::size_t i = 0; i < scan.positions.size(); ++i) {
    EXPECT_LT((point(json, json["scan"], i) - scan.positions[i]).norm(), step) << i;
  }
  for (std::size_t i = 0; i < draped.size(); ++i) {
    EXPECT_LT((point(json, json["garments"][0], i) - draped[i]).norm(), step) << i;
  }
}

TEST_F(View3d, TrianglesNormalsAndLabelsFollowTheScan) {
  const Json scan = view()["scan"];
  const std::string triangles = decoded(scan["triangles"]), labels = decoded(scan["labels"]);
  const std::string normals = decoded(scan["normals"]);
  ASSERT_EQ(triangles.size(), 6 * analysis_.scan.mesh.triangles.size());
  for (std::size_t t = 0; t < analysis_.scan.mesh.triangles.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_EQ(word_at(triangles, 3 * t + k), analysis_.scan.mesh.triangles[t][k]);
    }
  }
  for (std::size_t i = 0; i < analysis_.labels.size(); ++i) {
    EXPECT_EQ(byte_at(labels, i), analysis_.labels[i]);
  }
  for (std::size_t i = 0; i < analysis_.scan.mesh.normals.size(); ++i) {
    const auto x = static_cast<signed char>(normals[3 * i]);
    EXPECT_NEAR(x / 127.0, analysis_.scan.mesh.normals[i].x(), 0.51 / 127.0);
  }
}

TEST_F(View3d, DeviationsAreOfTheScaleOrNone) {
  EXPECT_EQ(view()["scan"]["values"], "");
  EXPECT_EQ(view()["scale"], "");
  auto& deviation = analysis_.garments[0].deviation;
  deviation.assign(analysis_.scan.mesh.positions.size(), std::nanf(""));
  deviation[0] = 0.0F;
  deviation[1] = -0.01F;
  deviation[2] = 0.01F;
  const Json json = view();
  EXPECT_EQ(json["scale_mm"], 10.0);
  const std::string values = decoded(json["scan"]["values"]);
  EXPECT_EQ(byte_at(values, 0), 127u);  // the middle of 0..254
  EXPECT_EQ(byte_at(values, 1), 0u);
  EXPECT_EQ(byte_at(values, 2), 254u);
  EXPECT_EQ(byte_at(values, 3), 255u);
  EXPECT_EQ(decoded(json["scale"]).size(), 3u * 255u);
}

TEST_F(View3d, ALargeScanIsThinned) {
  analysis_.scan.mesh = column(400, 200, 0.15, 1.7);
  analysis_.labels.assign(analysis_.scan.mesh.positions.size(), 0);
  analysis_.scan.outlier.assign(analysis_.labels.size(), 0);
  EXPECT_LE(decoded(view()["scan"]["triangles"]).size(), 6 * kViewElements);
  EXPECT_LT(view_json(analysis_).size(), 900'000u);
}

TEST_F(View3d, WhatItWritesIsTakenAndNothingThatCouldLeaveItsElement) {
  EXPECT_NO_THROW(check_view(view_json(analysis_)));
  EXPECT_NO_THROW(check_view(""));
  EXPECT_THROW(check_view("{\"low\":\"</script><script>alert(1)</script>\"}"), ReadError);
  EXPECT_THROW(check_view("{\"low\": 1}"), ReadError);  // a space is nothing it writes
  EXPECT_THROW(check_view("{\"low\":"), ReadError);
}

}  // namespace
}  // namespace regarment
