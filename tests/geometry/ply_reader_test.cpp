#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "geometry/read_text.h"
#include "support/ply_maker.h"

namespace regarment::test {
namespace {

constexpr std::array kForms{PlyForm::Ascii, PlyForm::Little, PlyForm::Big};

Mesh read_ply_text(const std::string& file) { return read_text(file, MeshFormat::Ply); }

// A pyramid over a square; whole numbers small enough for every type.
const std::vector<Vec3> kPyramid{{0, 0, 0}, {4, 0, 0}, {4, 0, 4}, {0, 0, 4}, {2, 3, 2}};

// Vertices with the given types for x y z, and the faces of the pyramid, the base as a quadrangle.
std::string pyramid(PlyForm form, const std::string& coordinate, const std::string& count = "uchar",
                    const std::string& index = "int", const std::string& list = "vertex_indices") {
  PlyMaker ply(form);
  ply.header("element vertex 5");
  for (const char* axis : {"x", "y", "z"}) ply.header("property " + coordinate + " " + axis);
  ply.header("element face 5").header("property list " + count + " " + index + " " + list);
  ply.header("end_header");
  for (const Vec3& p : kPyramid) {
    for (int axis = 0; axis < 3; ++axis) ply.value(coordinate, p[axis]);
    ply.end_row();
  }
  const std::vector<std::vector<int>> faces{
      {0, 1, 2, 3}, {0, 4, 1}, {1, 4, 2}, {2, 4, 3}, {3, 4, 0}};
  for (const auto& face : faces) {
    ply.value(count, static_cast<double>(face.size()));
    for (const int corner : face) ply.value(index, corner);
    ply.end_row();
  }
  return ply.text();
}

void expect_pyramid(const Mesh& mesh) {
  EXPECT_EQ(mesh.positions, kPyramid);
  const Corners expected{{0, 1, 2}, {0, 2, 3}, {0, 4, 1}, {1, 4, 2}, {2, 4, 3}, {3, 4, 0}};
  EXPECT_EQ(mesh.triangles, expected);
  EXPECT_TRUE(mesh.normals.empty());
  EXPECT_TRUE(mesh.colours.empty());
}

TEST(PlyReader, EveryScalarTypeInEveryForm) {
  for (const PlyForm form : kForms) {
    for (const char* type :
         {"char", "int8", "uchar", "uint8", "short", "int16", "ushort", "uint16", "int", "int32",
          "uint", "uint32", "float", "float32", "double", "float64"}) {
      SCOPED_TRACE(type);
      expect_pyramid(read_ply_text(pyramid(form, type)));
    }
  }
}

TEST(PlyReader, EveryWholeTypeForListLengthsAndIndices) {
  const std::array types{"char", "uchar", "short", "ushort", "int", "uint", "int8", "uint32"};
  for (const PlyForm form : kForms) {
    for (const char* count : types) {
      for (const char* index : types) {
        SCOPED_TRACE(std::string(count) + " " + index);
        expect_pyramid(read_ply_text(pyramid(form, "float", count, index, "vertex_index")));
      }
    }
  }
}

TEST(PlyReader, NegativeAndLargeValuesSurviveTheirType) {
  struct Case {
    const char* type;
    double value;
  };
  for (const PlyForm form : kForms) {
    for (const Case& c : {Case{"char", -128},
                          {"uchar", 255},
                          {"short", -32768},
                          {"ushort", 65535},
                          {"int", -2147483648.0},
                          {"uint", 4294967295.0},
                          {"float", -0.15625},
                          {"double", 0.1}}) {
      PlyMaker ply(form);
      ply.header("element vertex 1").header(std::string("property ") + c.type + " x");
      ply.header("property float y").header("property float z").header("end_header");
      ply.value(c.type, c.value).value("float", 0).value("float", 0).end_row();
      EXPECT_EQ(read_ply_text(ply.text()).positions.at(0).x(), c.value) << c.type;
    }
  }
}

// Two vertices with nine known and two unknown properties, in any order.
std::string two_vertices(PlyForm form, const std::vector<std::string>& order) {
  PlyMaker ply(form);
  ply.header("element vertex 2");
  const auto is_colour = [](const std::string& name) { return name.size() > 2; };
  for (const std::string& name : order) {
    ply.header("property " + std::string(is_colour(name) ? "uchar " : "double ") + name);
  }
  ply.header("end_header");
  const std::map<std::string, std::array<double, 2>> values{
      {"x", {1, -1}},      {"y", {2, -2}},        {"z", {3, -3}},   {"nx", {0, 3}},
      {"ny", {-2, 0}},     {"nz", {0, 4}},        {"red", {10, 0}}, {"green", {20, 255}},
      {"blue", {30, 128}}, {"confidence", {9, 9}}};
  for (std::size_t row = 0; row < 2; ++row) {
    for (const std::string& name : order) {
      ply.value(is_colour(name) ? "uchar" : "double", values.at(name)[row]);
    }
    ply.end_row();
  }
  return ply.text();
}

TEST(PlyReader, PropertiesInAnyOrder) {
  std::vector<std::string> order{"x",  "y",   "z",     "nx",   "ny",
                                 "nz", "red", "green", "blue", "confidence"};
  // Every rotation of the list, forwards and backwards, puts each property in each place.
  for (int turn = 0; turn < 20; ++turn) {
    std::rotate(order.begin(), order.begin() + 1, order.end());
    if (turn == 10) std::reverse(order.begin(), order.end());
    for (const PlyForm form : kForms) {
      const Mesh mesh = read_ply_text(two_vertices(form, order));
      EXPECT_EQ(mesh.positions, (std::vector<Vec3>{{1, 2, 3}, {-1, -2, -3}}));
      ASSERT_EQ(mesh.normals.size(), 2U);
      EXPECT_LT((mesh.normals[0] - Vec3(0, -1, 0)).norm(), 1e-15);
      EXPECT_LT((mesh.normals[1] - Vec3(0.6, 0, 0.8)).norm(), 1e-15);
      EXPECT_EQ(mesh.colours, (std::vector<Colour>{{10, 20, 30}, {0, 255, 128}}));
    }
  }
}

TEST(PlyReader, CoordinatesInAllSixOrders) {
  std::vector<std::string> order{"x", "y", "z"};
  do {
    for (const PlyForm form : kForms) {
      EXPECT_EQ(read_ply_text(two_vertices(form, order)).positions,
                (std::vector<Vec3>{{1, 2, 3}, {-1, -2, -3}}));
    }
  } while (std::next_permutation(order.begin(), order.end()));
}

TEST(PlyReader, PassesOverUnknownElementsAndLists) {
  for (const PlyForm form : kForms) {
    PlyMaker ply(form);
    ply.header("comment made by hand").header("obj_info none");
    ply.header("element camera 2")
        .header("property double f")
        .header("property list uchar short k");
    ply.header("element face 1").header("property uchar flags");
    ply.header("property list uchar float texcoord")
        .header("property list int uint vertex_indices");
    ply.header("element vertex 3")
        .header("property float x")
        .header("property list uchar int extra");
    ply.header("property float y").header("property float z").header("property double quality");
    ply.header("element edge 1").header("property int a").header("property int b");
    ply.header("end_header");
    ply.value("double", 1).value("uchar", 2).value("short", 7).value("short", 8).end_row();
    ply.value("double", 2).value("uchar", 0).end_row();
    ply.value("uchar", 1).value("uchar", 2).value("float", 0.5).value("float", 0.25);
    ply.value("int", 3).value("uint", 2).value("uint", 1).value("uint", 0).end_row();
    for (int i = 0; i < 3; ++i) {
      ply.value("float", i).value("uchar", i);
      for (int k = 0; k < i; ++k) ply.value("int", 99);
      ply.value("float", 10 + i).value("float", 20 + i).value("double", 0.5).end_row();
    }
    ply.value("int", 0).value("int", 1).end_row();
    const Mesh mesh = read_ply_text(ply.text());
    EXPECT_EQ(mesh.positions, (std::vector<Vec3>{{0, 10, 20}, {1, 11, 21}, {2, 12, 22}}));
    EXPECT_EQ(mesh.triangles, (Corners{{2, 1, 0}}));
  }
}

std::string one_vertex(const std::string& properties, const std::string& values) {
  return "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\n"
         "property float z\n" +
         properties + "end_header\n1 2 3 " + values + "\n";
}

TEST(PlyReader, FloatingColoursRunFromZeroToOne) {
  const std::string rgb =
      "property float red\nproperty float green\nproperty float blue\nproperty float alpha\n";
  EXPECT_EQ(read_ply_text(one_vertex(rgb, "0 1 0.2 1")).colours.at(0), (Colour{0, 255, 51}));
  EXPECT_EQ(read_ply_text(one_vertex(rgb, "-1 7 nan 1")).colours.at(0), (Colour{0, 255, 0}));
}

TEST(PlyReader, SixteenBitColours) {
  const std::string rgb = "property ushort red\nproperty ushort green\nproperty ushort blue\n";
  EXPECT_EQ(read_ply_text(one_vertex(rgb, "0 65535 32896")).colours.at(0), (Colour{0, 255, 128}));
}

TEST(PlyReader, OlderNamesOfColoursGiveWayToPlainOnes) {
  const std::string older =
      "property uchar diffuse_red\nproperty uchar diffuse_green\nproperty uchar diffuse_blue\n";
  const std::string plain = "property uchar red\nproperty uchar green\nproperty uchar blue\n";
  EXPECT_EQ(read_ply_text(one_vertex(older, "1 2 3")).colours.at(0), (Colour{1, 2, 3}));
  EXPECT_EQ(read_ply_text(one_vertex(older + plain, "1 2 3 4 5 6")).colours.at(0),
            (Colour{4, 5, 6}));
  EXPECT_TRUE(read_ply_text(one_vertex("property uchar red\n", "9")).colours.empty());
}

TEST(PlyReader, NormalsWithoutDirectionBecomeZero) {
  const std::string n = "property float nx\nproperty float ny\nproperty float nz\n";
  for (const char* values : {"0 0 0", "nan 0 0", "inf 1 1", "1e-30 0 0"}) {
    EXPECT_EQ(read_ply_text(one_vertex(n, values)).normals.at(0), Vec3(0, 0, 0)) << values;
  }
  EXPECT_EQ(read_ply_text(one_vertex(n, "0 1e200 0")).normals.at(0), Vec3(0, 1, 0));
}

TEST(PlyReader, CarriageReturnsBeforeLineFeeds) {
  std::string text = pyramid(PlyForm::Ascii, "float");
  std::string windows;
  for (const char c : text) windows += c == '\n' ? std::string("\r\n") : std::string(1, c);
  expect_pyramid(read_ply_text(windows));

  text = pyramid(PlyForm::Little, "float");
  const std::size_t body = text.find("end_header\n") + 11;
  windows.clear();
  for (const char c : text.substr(0, body)) {
    windows += c == '\n' ? std::string("\r\n") : std::string(1, c);
  }
  expect_pyramid(read_ply_text(windows + text.substr(body)));
}

TEST(PlyReader, WhiteSpaceAtTheEndAndBlankLinesBetweenRows) {
  for (const PlyForm form : kForms) {
    expect_pyramid(read_ply_text(pyramid(form, "float") + "\r\n \t\n"));
  }
  const std::string text = pyramid(PlyForm::Ascii, "int");
  std::string airy = text;
  airy.insert(airy.find("end_header\n") + 11, "\n\n");
  expect_pyramid(read_ply_text(airy));
  expect_pyramid(read_ply_text(text.substr(0, text.size() - 1)));  // last line without its end
}

TEST(PlyReader, NumbersAsPeopleWriteThem) {
  const std::string head =
      "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\n"
      "property float z\nend_header\n";
  EXPECT_EQ(read_ply_text(head + "+1.5 -2E-1 .5").positions.at(0), Vec3(1.5, -0.2, 0.5));
  EXPECT_EQ(read_ply_text(head + "\t1.\t 1e-400   -0\n").positions.at(0), Vec3(1, 0, 0));
}

TEST(PlyReader, FacesOfOneOrTwoCornersEncloseNothing) {
  const std::string text =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
      "property float z\nelement face 4\nproperty list uchar int vertex_indices\nend_header\n"
      "0 0 0\n1 0 0\n0 1 0\n0\n1 2\n2 0 1\n3 0 1 2\n";
  EXPECT_EQ(read_ply_text(text).triangles, (Corners{{0, 1, 2}}));
}

TEST(PlyReader, CloudWithAnEmptyFaceElement) {
  const std::string text =
      "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\n"
      "property float z\nelement face 0\nend_header\n0 0 0\n";
  EXPECT_TRUE(read_ply_text(text).is_cloud());
}

TEST(PlyReader, LimitsAreTheCallers) {
  const std::string text = pyramid(PlyForm::Little, "float");
  EXPECT_NE(complaint(text, MeshFormat::Ply, {.max_vertices = 4}), "");
  EXPECT_NE(complaint(text, MeshFormat::Ply, {.max_triangles = 5}), "");
  EXPECT_EQ(complaint(text, MeshFormat::Ply, {.max_vertices = 5, .max_triangles = 6}), "");
}

}  // namespace
}  // namespace regarment::test
