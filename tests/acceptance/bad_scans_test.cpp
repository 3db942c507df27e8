#include <gtest/gtest.h>

#include <fstream>

#include "failures.h"
#include "support/bad_files.h"
#include "support/folders.h"

namespace regarment {
namespace {

class BadScan : public testing::TestWithParam<test::BadFile> {};

TEST_P(BadScan, EndsInOneLineAndLeavesNothing) {
  const TemporaryFolder in, out;
  const auto file = test::put(GetParam(), in.path());
  const ProgramRun run =
      run_program({"fit", file.string(), "--garment", "skirt", "--out", out.path() / "result"});
  expect_failure(run, GetParam().exit_status);
  EXPECT_EQ(names_in(out.path()), std::vector<std::string>{});
}

std::string test_name(const testing::TestParamInfo<test::BadFile>& info) {
  std::string name = std::to_string(info.index) + "_" + info.param.title;
  for (char& c : name) {
    if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
  }
  return name;
}

INSTANTIATE_TEST_SUITE_P(All, BadScan, testing::ValuesIn(test::bad_files()), test_name);

std::string ply_of(const std::vector<std::array<double, 3>>& points) {
  std::string text = "ply\nformat ascii 1.0\nelement vertex " + std::to_string(points.size()) +
                     "\nproperty float x\nproperty float y\nproperty float z\nend_header\n";
  for (const auto& p : points) {
    text += std::to_string(p[0]) + " " + std::to_string(p[1]) + " " + std::to_string(p[2]) + "\n";
  }
  return text;
}

void write(const std::filesystem::path& file, const std::string& text) {
  std::ofstream(file, std::ios::binary) << text;
}

void expect_no_person(const std::vector<std::array<double, 3>>& points) {
  const TemporaryFolder folder;
  write(folder.path() / "thing.ply", ply_of(points));
  const ProgramRun run = run_program({"fit", folder.path() / "thing.ply", "--garment", "skirt",
                                      "--out", folder.path() / "out", "--quiet"});
  expect_failure(run, 3);
  EXPECT_EQ(names_in(folder.path()), std::vector<std::string>{"thing.ply"});
}

TEST(NoPerson, ACube) {
  std::vector<std::array<double, 3>> points;
  for (int i = 0; i < 40; ++i) {
    for (int j = 0; j < 40; ++j) {
      const double u = i / 39.0, v = j / 39.0;
      for (const double side : {0.0, 1.0}) {
        points.push_back({u, v, side});
        points.push_back({u, side, v});
        points.push_back({side, u, v});
      }
    }
  }
  expect_no_person(points);
}

TEST(NoPerson, ThreePoints) { expect_no_person({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}); }

TEST(NoPerson, APlane) {
  std::vector<std::array<double, 3>> points;
  for (int i = 0; i < 60; ++i) {
    for (int j = 0; j < 60; ++j) points.push_back({i * 0.03, j * 0.03, 0.0});
  }
  expect_no_person(points);
}

TEST(NoPerson, OnePointManyTimes) {
  expect_no_person(std::vector<std::array<double, 3>>(5000, {1.0, 2.0, 3.0}));
}

}  // namespace
}  // namespace regarment
