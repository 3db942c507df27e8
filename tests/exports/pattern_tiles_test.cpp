#include "exports/pattern_tiles.h"

#include <gtest/gtest.h>

#include <fstream>

#include "garments.h"
#include "run_tool.h"
#include "support/folders.h"

namespace regarment {
namespace {

class PatternTiles : public testing::Test {
 protected:
  void write(const std::string& garment, const Dimensions& dimensions) {
    std::ofstream(file_, std::ios::binary) << pattern_tiles(find_template(garment), dimensions);
  }

  /// A page as poppler draws it, ten pixels a millimetre: the longest row of dark pixels, mm.
  std::optional<double> longest_row(const std::string& page) {
    const std::string picture = home_.path() / "page";
    const auto run = run_tool(
        {"pdftoppm", "-gray", "-r", "254", "-f", page, "-l", page, "-singlefile", file_, picture});
    if (!run) return std::nullopt;
    EXPECT_EQ(run->status, 0) << run->text;
    std::ifstream in(picture + ".pgm", std::ios::binary);
    std::string magic;
    int width = 0, height = 0, most = 0;
    in >> magic >> width >> height >> most;
    in.get();
    int longest = 0;
    std::string row(static_cast<std::size_t>(width), '\0');
    for (int y = 0; y < height && in.read(row.data(), width); ++y) {
      int run_length = 0;
      for (const char c : row) {
        run_length = static_cast<unsigned char>(c) < 128 ? run_length + 1 : 0;
        longest = std::max(longest, run_length);
      }
    }
    return longest / 10.0;
  }

  const TemporaryFolder home_;
  const std::string file_ = home_.path() / "pattern.pdf";
};

TEST_F(PatternTiles, TheTestSquareMeasuresTenCentimetres) {
  write("skirt", whole_skirt());
  const auto row = longest_row("1");
  if (!row) GTEST_SKIP() << "poppler-utils is not installed";
  EXPECT_NEAR(*row, 100.3, 0.25);  // with the pen's 0.3 mm, and rounding to pixels
}

// The half skirt is 30 cm wide at the hem; with a border of 8 mm, 172 mm of it stand on the first
// of two columns and the rest on the second. Rows: 600 + 16 mm in frames of 250.
TEST_F(PatternTiles, APieceGoesOnOverItsPages) {
  write("skirt", whole_skirt());
  const auto info = run_tool({"pdfinfo", file_});
  if (!info) GTEST_SKIP() << "poppler-utils is not installed";
  ASSERT_EQ(info->status, 0) << info->text;
  EXPECT_NE(info->text.find("Pages:           7\n"), std::string::npos) << info->text;
  EXPECT_NE(info->text.find("A4"), std::string::npos);
  EXPECT_NEAR(*longest_row("6"), 172.0 + 0.4, 0.5);  // hem, from the fold to the frame
  EXPECT_NEAR(*longest_row("7"), 128.0 + 0.4, 0.5);  // and the rest of its 300 mm
}

TEST_F(PatternTiles, SaysHowOftenToCutAndThatThereIsNoAllowance) {
  write("tshirt", whole_tshirt());
  const auto text = run_tool({"pdftotext", "-layout", file_, "-"});
  if (!text) GTEST_SKIP() << "poppler-utils is not installed";
  ASSERT_EQ(text->status, 0) << text->text;
  for (const char* words : {"cut 2 on the fold", "cut 2 and 2 mirrored", "without seam allowance",
                            "Test square, 10 cm x 10 cm", "place on the fold", "grain line"})
    EXPECT_NE(text->text.find(words), std::string::npos) << words;
}

TEST_F(PatternTiles, QpdfFindsNoFault) {
  write("tshirt", whole_tshirt());
  const auto run = run_tool({"qpdf", "--check", file_});
  if (!run) GTEST_SKIP() << "qpdf is not installed";
  EXPECT_EQ(run->status, 0) << run->text;
}

TEST(PatternTilesBytes, AreTheSameTwice) {
  EXPECT_EQ(pattern_tiles(find_template("tshirt"), whole_tshirt()),
            pattern_tiles(find_template("tshirt"), whole_tshirt()));
}

}  // namespace
}  // namespace regarment
