#include "report/report_folder.h"

#include <gtest/gtest.h>

#include <numeric>

#include "base/error.h"
#include "geometry/mesh_io.h"
#include "render/image.h"
#include "report/close_holes.h"
#include "report/evaluations_csv.h"
#include "report/files.h"
#include "searches.h"
#include "support/folders.h"

namespace regarment {
namespace {

namespace fs = std::filesystem;

class ReportFolder : public testing::Test {
 protected:
  ReportFolder() { options_.timing = false; }

  ReportFiles files() const {
    return report_files(analysis_, {skirt_}, options_, close_holes(analysis_), Pictures{});
  }

  GarmentTemplate skirt_ = find_template("skirt");
  Analysis analysis_ = column_analysis(skirt_);
  ReportOptions options_;
};

Mesh read_ply(const std::string& bytes) {
  return parse_mesh(std::as_bytes(std::span(bytes)), MeshFormat::Ply, "made.ply");
}

TEST_F(ReportFolder, HoldsTheFilesOfTheContract) {
  const ReportFiles made = files();
  std::vector<std::string> names;
  for (const auto& [name, bytes] : made) names.push_back(name);
  EXPECT_EQ(names,
            (std::vector<std::string>{
                "borders.json", "filled.ply", "garment-1.glb", "garment-1.obj", "garment-1.ply",
                "labels.u8", "measurements.csv", "pattern-1.dxf", "pattern-1.json", "pattern-1.pdf",
                "pattern-1.svg", "pattern-1.val", "pictures/sketch-1.svg", "pictures/view.json",
                "report.html", "result.json", "segmented.glb", "segmented.ply", "sizes.jsonld"}));
}

TEST_F(ReportFolder, LabelsAreOneBytePerVertexInOrder) {
  const std::string labels = files().at("labels.u8");
  ASSERT_EQ(labels.size(), analysis_.labels.size());
  for (std::size_t i = 0; i < labels.size(); ++i) EXPECT_EQ(labels[i], i % 3 == 0 ? 1 : 0);
}

// By hand: body (x, y, z) is file (1000 x + 100, -1000 z + 200, 1000 y + 300).
TEST_F(ReportFolder, GarmentsStandInTheFilesOwnFrame) {
  const Mesh mesh = read_ply(files().at("garment-1.ply"));
  const auto& draped = analysis_.garments[0].draped;
  ASSERT_EQ(mesh.positions.size(), draped.size());
  EXPECT_EQ(mesh.triangles, analysis_.garments[0].pattern.triangles);
  for (std::size_t i = 0; i < draped.size(); ++i) {
    const Vec3 expected(1000.0 * draped[i].x() + 100.0, -1000.0 * draped[i].z() + 200.0,
                        1000.0 * draped[i].y() + 300.0);
    // 1e-3 mm: the file holds floats of about 1,000 mm.
    EXPECT_LT((mesh.positions[i] - expected).norm(), 1e-3);
  }
}

TEST_F(ReportFolder, TheSegmentedScanKeepsVerticesAndTriangles) {
  analysis_.label_probability.assign(analysis_.labels.size(), 1.0F);
  analysis_.label_probability[4] = 0.5F;
  const Mesh mesh = read_ply(files().at("segmented.ply"));
  EXPECT_EQ(mesh.triangles, analysis_.scan.mesh.triangles);
  ASSERT_EQ(mesh.positions.size(), analysis_.scan.mesh.positions.size());
  ASSERT_EQ(mesh.colours.size(), mesh.positions.size());
  EXPECT_NE(mesh.colours[0], mesh.colours[1]);
  EXPECT_EQ(mesh.colours[1], mesh.colours[2]);
  EXPECT_NE(mesh.colours[2], mesh.colours[4]) << "an unsure label is shaded";
}

TEST_F(ReportFolder, ACloudStaysACloud) {
  analysis_.scan.mesh.triangles.clear();
  analysis_.cap.clear();
  EXPECT_TRUE(read_ply(files().at("segmented.ply")).is_cloud());
}

TEST_F(ReportFolder, WithoutTimingNothingTellsOfTheRun) {
  const ReportFiles made = files();
  analysis_.times = {{"measure", 7.5}};
  options_.threads = 9;
  options_.scan_path = "/somewhere/else/column.ply";
  EXPECT_EQ(files(), made);
  options_.timing = true;
  EXPECT_NE(files(), made);
}

TEST_F(ReportFolder, AFileNameCannotLeaveItsPlaceInAnyFile) {
  analysis_.scan.facts.file = "<script>alert(1)</script>\n\xff.ply";
  for (const auto& [name, bytes] : files()) {
    if (!name.ends_with(".html")) continue;
    EXPECT_EQ(bytes.find("<script>alert"), std::string::npos);
    EXPECT_NE(bytes.find("&lt;script&gt;alert(1)&lt;/script&gt;\\x0a\\xff.ply"), std::string::npos);
  }
}

TEST_F(ReportFolder, ContradictionsAreOurOwnMistake) {
  analysis_.labels.pop_back();
  EXPECT_THROW(files(), InvalidInput);
  analysis_.labels.push_back(2);
  EXPECT_THROW(files(), InvalidInput);
  analysis_ = column_analysis(skirt_);
  analysis_.garments[0].measurements[0].flat = std::nan("");
  EXPECT_THROW(files(), InvalidInput);
}

TEST_F(ReportFolder, DrawnTwiceItHasTheSameBytesWhateverTheThreads) {
  const Pictures one = draw_pictures(analysis_, {}, 1, 1, {});
  const Pictures two = draw_pictures(analysis_, {}, 1, 2, {});
  EXPECT_EQ(one.bytes, two.bytes);
  EXPECT_EQ(one.figures.size(), 16u);
  const std::size_t total =
      std::accumulate(one.bytes.begin(), one.bytes.end(), std::size_t{0},
                      [](std::size_t sum, const auto& file) { return sum + file.second.size(); });
  EXPECT_LT(total, 900u * 1024u);
}

TEST_F(ReportFolder, PicturesForFineScreensShowTheSameInTwiceTheSize) {
  const Pictures plain = draw_pictures(analysis_, {}, 1, 2, {});
  const Pictures fine = draw_pictures(analysis_, {}, 2, 2, {});
  ASSERT_EQ(fine.figures.size(), plain.figures.size());
  std::size_t total = 0;
  for (std::size_t i = 0; i < plain.figures.size(); ++i) {
    const std::string& bytes = fine.bytes.at(fine.figures[i].file);
    const Image small =
        decode_image(std::as_bytes(std::span(plain.bytes.at(plain.figures[i].file))), "plain");
    const Image large = decode_image(std::as_bytes(std::span(bytes)), "fine");
    EXPECT_EQ(large.width, 2 * small.width);
    EXPECT_EQ(large.height, 2 * small.height);
    EXPECT_LT(image_difference(shrink(large, 2), small).mean, 0.01) << plain.figures[i].file;
    total += bytes.size();
  }
  EXPECT_LT(total, 2200u * 1024u);
}

TEST_F(ReportFolder, TheReportIsMadeAgainFromWhatIsStored) {
  const TemporaryFolder home;
  const fs::path place = home.path() / "out";
  options_.timing = true;
  options_.options = {{"units", "mm"}};
  write_report_folder(analysis_, {skirt_}, options_, place, false, {});
  const std::string page = read_file(place / "report.html", 64u << 20);
  fs::remove(place / "report.html");
  EXPECT_EQ(remake_report(place), place / "report.html");
  EXPECT_EQ(read_file(place / "report.html", 64u << 20), page);
  EXPECT_EQ(remake_report(place), place / "report.html");
}

class SearchedFolder : public ReportFolder {
 protected:
  SearchedFolder() {
    analysis_.method = "annealing";
    set_trace(made_trace(skirt_, 3, 40), analysis_.garments[0]);
    set_deviation(analysis_, 0, [](std::size_t i) { return 1e-5 * double(i) - 0.002; });
  }
};

TEST_F(SearchedFolder, HoldsItsEvaluationsToo) {
  const ReportFiles made = files();
  ASSERT_TRUE(made.contains("evaluations-1.csv"));
  EXPECT_EQ(made.at("evaluations-1.csv"), evaluations_csv(*analysis_.garments[0].trace));
  EXPECT_LT(made.at("result.json").size(), 20'000u);
}

TEST_F(SearchedFolder, ShowsTheDeviationOfItsGarments) {
  const Pictures pictures = draw_pictures(analysis_, {}, 1, 2, {});
  ASSERT_EQ(pictures.figures.size(), 20u);
  EXPECT_EQ(pictures.figures.back().kind, "deviation");
  EXPECT_NE(pictures.bytes.at("pictures/deviation-front.jpg"),
            pictures.bytes.at("pictures/segmentation-front.jpg"));
  const std::string page =
      report_files(analysis_, {skirt_}, options_, {}, pictures).at("report.html");
  EXPECT_NE(page.find("id=\"look-deviation\""), std::string::npos);
  EXPECT_NE(page.find("class=\"legend\""), std::string::npos);
}

TEST_F(SearchedFolder, IsMadeAgainFromWhatIsStored) {
  const TemporaryFolder home;
  const fs::path place = home.path() / "out";
  write_report_folder(analysis_, {skirt_}, options_, place, false, {});
  const std::string page = read_file(place / "report.html", 64u << 20);
  fs::remove(place / "report.html");
  remake_report(place);
  EXPECT_EQ(read_file(place / "report.html", 64u << 20), page);
}

TEST_F(SearchedFolder, WithoutItsEvaluationsIsNotMadeAgain) {
  const TemporaryFolder home;
  const fs::path place = home.path() / "out";
  write_report_folder(analysis_, {skirt_}, options_, place, false, {});
  const std::string csv = read_file(place / "evaluations-1.csv", 1u << 20);
  fs::remove(place / "evaluations-1.csv");
  EXPECT_THROW(remake_report(place), ReadError);
  write_file(place / "evaluations-1.csv", csv.substr(0, csv.size() / 2));
  EXPECT_THROW(remake_report(place), ReadError);
}

TEST_F(SearchedFolder, ATraceThatContradictsItselfIsOurOwnMistake) {
  analysis_.garments[0].trace->runs[0].best = 40;
  EXPECT_THROW(files(), InvalidInput);
}

TEST_F(ReportFolder, AStoredResultThatIsNotOursIsRefused) {
  const TemporaryFolder home;
  EXPECT_THROW(remake_report(home.path()), ReadError);
  write_file(home.path() / "result.json", "{}");
  EXPECT_THROW(remake_report(home.path()), ReadError);
  EXPECT_EQ(names_in(home.path()), std::vector<std::string>{"result.json"});
}

TEST_F(ReportFolder, StoppingLeavesNothing) {
  const TemporaryFolder home;
  for (const std::string stop_at : {"draw", "write"}) {
    const Progress progress([&](std::string_view stage, double fraction) {
      return stage != stop_at || fraction < 0.5;
    });
    EXPECT_THROW(
        write_report_folder(analysis_, {skirt_}, options_, home.path() / "out", false, progress),
        Stopped);
    EXPECT_EQ(names_in(home.path()), std::vector<std::string>{});
  }
}

}  // namespace
}  // namespace regarment
