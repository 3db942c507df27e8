#include "evaluation/find_scans.h"

#include <gtest/gtest.h>

#include <fstream>

#include "support/folders.h"

namespace regarment {
namespace {

namespace fs = std::filesystem;

// home/truth with the table, home/scans with scans.
class FindScans : public ::testing::Test {
 protected:
  FindScans() {
    for (const char* name :
         {"scans/skirt-1.mesh.ply", "scans/skirt-1.cloud.PLY", "scans/skirt-1.labels.u8",
          "scans/skirt-10.mesh.ply", "scans/skirt-1.txt", "truth/skirt-1.garment1.ply",
          "truth/near.obj", "truth/skirt-1.mesh.labels.u8", "scans/skirt-10.mesh.labels.u8"}) {
      fs::create_directories((home_.path() / name).parent_path());
      std::ofstream(home_.path() / name) << "x";
    }
  }
  std::vector<std::string> names(const std::string& written, bool with_scans = true) const {
    std::vector<std::string> out;
    const auto folder = with_scans ? std::optional(scans_) : std::nullopt;
    for (const fs::path& path : find_scans(written, truth_, folder)) {
      out.push_back(fs::relative(path, home_.path()).string());
    }
    return out;
  }

  TemporaryFolder home_;
  fs::path truth_ = home_.path() / "truth", scans_ = home_.path() / "scans";
};

using Names = std::vector<std::string>;

TEST_F(FindScans, TakesAPathSeenFromTheTableFirst) {
  EXPECT_EQ(names("near.obj"), Names{"truth/near.obj"});
  EXPECT_EQ(names("../scans/skirt-10.mesh.ply"), Names{"scans/skirt-10.mesh.ply"});
}

TEST_F(FindScans, LooksIntoTheOtherFolder) {
  EXPECT_EQ(names("skirt-10.mesh.ply"), Names{"scans/skirt-10.mesh.ply"});
  EXPECT_EQ(names("elsewhere/skirt-10.mesh.ply"), Names{"scans/skirt-10.mesh.ply"});
}

TEST_F(FindScans, AStemMeansEveryMeshOfThatName) {
  EXPECT_EQ(names("skirt-1"), (Names{"scans/skirt-1.cloud.PLY", "scans/skirt-1.mesh.ply"}));
  EXPECT_EQ(names("skirt-1", false), Names{"truth/skirt-1.garment1.ply"});
}

TEST_F(FindScans, FindsNothingWhereNothingIs) {
  EXPECT_EQ(names("skirt-2"), Names{});
  EXPECT_EQ(names(".."), Names{});
}

TEST_F(FindScans, LabelsStandBesideTheTableOrTheScan) {
  EXPECT_EQ(find_labels("", scans_ / "skirt-1.mesh.ply", truth_, {}),
            truth_ / "skirt-1.mesh.labels.u8");
  EXPECT_EQ(find_labels("", scans_ / "skirt-10.mesh.ply", truth_, {}),
            scans_ / "skirt-10.mesh.labels.u8");
  EXPECT_EQ(find_labels("", scans_ / "skirt-1.cloud.PLY", truth_, {}), std::nullopt);
}

TEST_F(FindScans, WrittenLabelsAreTakenAtTheirWord) {
  EXPECT_EQ(find_labels("skirt-1.labels.u8", scans_ / "a.ply", truth_, scans_),
            scans_ / "skirt-1.labels.u8");
  EXPECT_EQ(find_labels("none.u8", scans_ / "skirt-1.mesh.ply", truth_, scans_),
            truth_ / "none.u8");
}

}  // namespace
}  // namespace regarment
