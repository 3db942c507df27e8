#include <gtest/gtest.h>

#include <fstream>

#include <nlohmann/json.hpp>

#include "failures.h"
#include "support/folders.h"

namespace regarment {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

TEST(Help, NamesTheCommandsAndTheExitStatus) {
  const ProgramRun run = run_program({"--help"});
  EXPECT_EQ(run.status, 0);
  EXPECT_EQ(run.err, "");
  for (const char* word : {"fit", "evaluate", "report", "render", "templates", "Exit status"}) {
    EXPECT_NE(run.out.find(word), std::string::npos) << word;
  }
}

TEST(Help, EachCommandHasItsOwn) {
  for (const std::string command : {"fit", "evaluate", "report", "render", "templates"}) {
    const ProgramRun run = run_program({command, "--help"});
    EXPECT_EQ(run.status, 0);
    EXPECT_NE(run.out.find("--json"), std::string::npos) << run.out;
  }
  EXPECT_NE(run_program({"fit", "--help"}).out.find("--ground-truth-labels"), std::string::npos);
}

TEST(Version, IsOneLineEverywhere) {
  const ProgramRun run = run_program({"--version"});
  EXPECT_EQ(run.status, 0);
  EXPECT_TRUE(run.out.starts_with("regarment 0.")) << run.out;
  EXPECT_EQ(lines_of(run.out).size(), 1u);
  EXPECT_EQ(run_program({"fit", "--version"}).out, run.out);
}

TEST(Templates, AreListedAndShown) {
  const ProgramRun list = run_program({"templates"});
  EXPECT_EQ(list.status, 0);
  EXPECT_NE(list.out.find("skirt"), std::string::npos);
  EXPECT_NE(list.out.find("tshirt"), std::string::npos);
  const ProgramRun skirt = run_program({"templates", "skirt"});
  EXPECT_EQ(skirt.status, 0);
  for (const char* code : {"S01", "S02", "S03", "S04"}) {
    EXPECT_NE(skirt.out.find(code), std::string::npos) << code;
  }
}

TEST(Templates, SpeakJson) {
  const Json list = Json::parse(run_program({"templates", "--json"}).out);
  EXPECT_GE(list.size(), 2u);
  const Json tshirt = Json::parse(run_program({"templates", "tshirt", "--json"}).out);
  EXPECT_EQ(tshirt.at("dimensions").size(), 5u);
  EXPECT_EQ(tshirt.at("dimensions").at(0).at("code"), "T01");
}

// A longer skirt: below the hip line points move down, across nothing moves, and the triangles
// stay.
TEST(Templates, TellThePatternAtAnySize) {
  const auto pattern_at = [](const std::string& length) {
    return Json::parse(
               run_program({"templates", "skirt", "--at", "length=" + length, "--json"}).out)
        .at("pattern");
  };
  const Json a = pattern_at("54"), b = pattern_at("64");
  EXPECT_EQ(a.at("triangles"), b.at("triangles"));
  EXPECT_EQ(a.at("coarse_triangle_of_point"), b.at("coarse_triangle_of_point"));
  double lowest_a = 0, lowest_b = 0;
  for (std::size_t i = 0; i < a.at("points_cm").size(); ++i) {
    lowest_a = std::max(lowest_a, a.at("points_cm")[i][1].get<double>());
    lowest_b = std::max(lowest_b, b.at("points_cm")[i][1].get<double>());
  }
  EXPECT_DOUBLE_EQ(lowest_a, 54);
  EXPECT_DOUBLE_EQ(lowest_b, 64);
}

TEST(Templates, RefuseWhatIsNoSize) {
  EXPECT_EQ(run_program({"templates", "skirt", "--at", "length=54"}).status, 2);
  EXPECT_EQ(run_program({"templates", "skirt", "--at", "sleeve=54", "--json"}).status, 2);
  EXPECT_EQ(run_program({"templates", "skirt", "--at", "length=ten", "--json"}).status, 2);
  EXPECT_EQ(run_program({"templates", "tshirt", "--at", "length=9", "--json"}).status, 2);
}

TEST(Render, DrawsFourSidesOfAnythingReadable) {
  const TemporaryFolder home;
  std::ofstream(home.path() / "triangle.off") << "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
  const fs::path out = home.path() / "out";
  const ProgramRun run = run_program(
      {"render", example("skirt-1.mesh.ply"), home.path() / "triangle.off", "--out", out, "--json"},
      kFitSeconds);
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_EQ(names_in(out).size(), 8u);
  EXPECT_EQ(Json::parse(run.out).at("pictures").size(), 8u);
}

TEST(Report, IsMadeAgainWithTheSameBytes) {
  const TemporaryFolder home;
  const fs::path out = home.path() / "out";
  ASSERT_EQ(run_program({"fit", example("skirt-1.mesh.ply"), "--garment", "skirt", "--method",
                         "direct", "--out", out},
                        kFitSeconds)
                .status,
            0);
  const std::string before = bytes_of(out / "report.html");
  fs::remove(out / "report.html");
  const ProgramRun run = run_program({"report", out});
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_EQ(run.out, (out / "report.html").string() + "\n");
  EXPECT_EQ(bytes_of(out / "report.html"), before);
}

TEST(Output, AFullDeviceIsATemporaryFailure) {
  // The shell only connects standard output; /dev/full answers every write with "no space".
  const std::string command = std::string(REGARMENT_PROGRAM) + " templates >/dev/full 2>/dev/null";
  EXPECT_EQ(WEXITSTATUS(std::system(command.c_str())), 75);
}

}  // namespace
}  // namespace regarment
