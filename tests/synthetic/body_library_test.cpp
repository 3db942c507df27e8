#include "synthetic/body_library.h"

#include <gtest/gtest.h>

#include <cstring>
#include <map>
#include <string>

#include "base/error.h"

namespace regarment {
namespace {

void put(std::string& file, const void* value, std::size_t size) {
  file.append(static_cast<const char*>(value), size);
}

template <typename T>
void put(std::string& file, T value) {
  put(file, &value, sizeof(value));
}

// One body of one triangle, its corners on those of a box of 1 x 2 x 4 m.
std::string packed_triangle() {
  std::string file = "RGBODY1\n";
  for (const std::uint32_t count : {1U, 3U, 1U}) put(file, count);
  file += std::string("flat") + std::string(28, '\0');
  for (const float side : {0.0F, 0.0F, 0.0F, 1.0F, 2.0F, 4.0F}) put(file, side);
  for (const int index : {0, 1, 2}) put(file, static_cast<std::uint16_t>(index));
  for (const int q : {0, 0, 0, 65535, 0, 0, 0, 65535, 13107}) {
    put(file, static_cast<std::uint16_t>(q));
  }
  return file;
}

BodyLibrary unpack(const std::string& file) {
  return unpack_bodies(std::as_bytes(std::span(file)));
}

TEST(BodyLibrary, ReadsWhatTheFormatSays) {
  const BodyLibrary library = unpack(packed_triangle());
  EXPECT_EQ(library.names, std::vector<std::string>{"flat"});
  ASSERT_EQ(library.triangles.size(), 1U);
  EXPECT_EQ(library.triangles[0], (Triangle{0, 1, 2}));
  EXPECT_EQ(library.positions[0][1], Vec3(1, 0, 0));
  EXPECT_TRUE(library.positions[0][2].isApprox(Vec3(0, 2, 0.8), 1e-12));  // 13107 / 65535 = 1 / 5
}

TEST(BodyLibrary, RefusesEveryShorterFile) {
  const std::string file = packed_triangle();
  for (std::size_t size = 0; size < file.size(); ++size) {
    EXPECT_THROW(unpack(file.substr(0, size)), ReadError) << size;
  }
  EXPECT_THROW(unpack(file + "x"), ReadError);
}

TEST(BodyLibrary, RefusesATriangleOutOfRangeAndAnEmptyBox) {
  std::string file = packed_triangle();
  const std::size_t triangle = 8 + 12 + 56;
  file[triangle] = 3;
  EXPECT_THROW(unpack(file), ReadError);
  file = packed_triangle();
  file.replace(8 + 12 + 32 + 12, 4, 4, '\0');
  EXPECT_THROW(unpack(file), ReadError);
}

TEST(BodyLibrary, HoldsEightClosedPeopleAlikeLeftAndRight) {
  const BodyLibrary& library = body_library();
  ASSERT_EQ(library.names.size(), 8U);
  EXPECT_EQ(library.names.front(), "female-average");
  std::map<std::array<std::uint32_t, 2>, int> edges;
  for (const Triangle& t : library.triangles) {
    for (std::size_t k = 0; k < 3; ++k) ++edges[{t[k], t[(k + 1) % 3]}];
  }
  for (const auto& [edge, count] : edges) {
    ASSERT_EQ(count, 1);
    ASSERT_EQ(edges.count({edge[1], edge[0]}), 1U);
  }
  for (const auto& positions : library.positions) {
    ASSERT_EQ(positions.size(), 13380U);
    Vec3 low = positions[0], high = positions[0];
    for (const Vec3& p : positions) low = low.cwiseMin(p), high = high.cwiseMax(p);
    EXPECT_NEAR(low.y(), 0, 1e-4);
    EXPECT_NEAR(low.x(), -high.x(), 1e-4);
    EXPECT_GT(high.y(), 1.5);
    EXPECT_LT(high.y(), 2.0);
  }
}

TEST(BodyLibrary, FacesThePositiveZ) {
  // Toes are in front of heels.
  for (const auto& positions : body_library().positions) {
    double front = 0, back = 0;
    for (const Vec3& p : positions) {
      if (p.y() > 0.05) continue;
      front = std::max(front, p.z());
      back = std::min(back, p.z());
    }
    EXPECT_GT(front, 2 * -back);
  }
}

}  // namespace
}  // namespace regarment
