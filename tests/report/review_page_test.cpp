#include "report/review_page.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "render/image.h"
#include "report/files.h"
#include "report/write_review.h"
#include "results.h"
#include "support/folders.h"
#include "support/texts.h"

namespace regarment {
namespace {

namespace fs = std::filesystem;

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

ReviewItem item(const std::string& name) {
  return {name, "0123456789abcdef", name + "/report.html", example_result(), {"RIFF", 206, 380}};
}

// A PNG: its left half red, its right half blue.
std::string striped(int width, int height) {
  Image image(width, height, {200, 0, 0, 255});
  for (int y = 0; y < height; ++y) {
    for (int x = width / 2; x < width; ++x) image.at(x, y) = {0, 0, 200, 255};
  }
  std::string out;
  for (const std::byte b : encode_image(image, ImageFormat::Png)) out += static_cast<char>(b);
  return out;
}

Image decoded(const Thumbnail& thumbnail) {
  return decode_image(std::as_bytes(std::span(thumbnail.webp)), "thumbnail");
}

TEST(Thumbnail, IsAWholeNumberOfTimesSmaller) {
  const Thumbnail made = make_thumbnail(striped(80, 121), striped(80, 121), 60, "x");
  // 121 rows need three times; 80 columns give 26, twice, and the gap.
  EXPECT_EQ(made.height, 40);
  EXPECT_EQ(made.width, 26 + 6 + 26);
  const Image image = decoded(made);
  EXPECT_EQ(image.width, made.width);
  EXPECT_NEAR(image.at(5, 20).r, 200, 12);  // 12: WebP's loss on plain colours
  EXPECT_NEAR(image.at(21, 20).b, 200, 12);
  EXPECT_NEAR(image.at(32 + 21, 20).b, 200, 12);
}

TEST(Thumbnail, KeepsPicturesThatAreSmallEnough) {
  EXPECT_EQ(make_thumbnail(striped(20, 60), striped(20, 60), 60, "x").height, 60);
}

TEST(Thumbnail, RefusesWhatIsNoPictureOrNoPair) {
  EXPECT_THROW(make_thumbnail("RIFF", striped(20, 60), 60, "x"), ReadError);
  EXPECT_THROW(make_thumbnail(striped(20, 60), striped(20, 50), 60, "x"), ReadError);
}

TEST(ReviewPage, HasACardForEachResultAndRequestsNothing) {
  const std::string page = review_page({item("a"), item("b")});
  EXPECT_EQ(count(page, "<article"), 2u);
  EXPECT_TRUE(has(page, "2 results to review"));
  EXPECT_TRUE(has(page, R"(href="b/report.html")"));
  EXPECT_FALSE(has(page, "{{"));
  for (const char* word : {"http://", "https://", "<link", "@import", "url(", "style=\""}) {
    EXPECT_FALSE(has(page, word)) << word;
  }
}

TEST(ReviewPage, ShowsDimensionsWithTheirDifferences) {
  const std::string page = review_page({item("a")});
  EXPECT_TRUE(has(page, ">+2.5<span class=\"unseen\"> out of tolerance"));  // 112.5 against 110
  EXPECT_TRUE(has(page, ">+0.3</td>"));                                     // 54.3 against 54
  EXPECT_TRUE(has(page, ">(96.0)</span>"));                                 // not seen
}

TEST(ReviewPage, EscapesWhatComesFromOutside) {
  ReviewItem hostile = item("<script>alert(1)</script>");
  hostile.result.scan.file = "\"><img src=x>.ply";
  hostile.result.warnings = {"<b>&"};
  const std::string page = review_page({hostile});
  EXPECT_EQ(count(page, "<script>"), 1u);
  EXPECT_FALSE(has(page, "<img src=x"));
  EXPECT_FALSE(has(page, "<b>&"));
}

TEST(ReviewPage, StandsWithoutAPictureAndWithoutAReport) {
  ReviewItem bare = item("a");
  bare.link.clear();
  bare.picture = {};
  const std::string page = review_page({bare});
  EXPECT_TRUE(has(page, "no picture of the labels"));
  EXPECT_FALSE(has(page, "<h2 id=\"name-1\"><a"));
}

class WriteReview : public testing::Test {
 protected:
  void put(const fs::path& folder) const {
    fs::create_directories(folder / "pictures");
    Result result = example_result();
    result.figures = {{"segmentation", "front", "pictures/segmentation-front.png", 20, 60},
                      {"segmentation", "back", "pictures/segmentation-back.png", 20, 60}};
    write_file(folder / "result.json", result_json(result));
    write_file(folder / "report.html", "<!DOCTYPE html>");
    for (const StoredFigure& figure : result.figures) {
      write_file(folder / figure.file, striped(20, 60));
    }
  }

  TemporaryFolder folder_;
};

TEST_F(WriteReview, FindsResultsGivenAloneTogetherOrInAnEvaluation) {
  const fs::path here = folder_.path();
  put(here / "one");
  put(here / "many" / "b");
  put(here / "many" / "a");
  put(here / "evaluation" / "fits" / "c");
  fs::create_directories(here / "many" / "not");
  EXPECT_EQ(find_results({here / "one", here / "many", here / "evaluation", here / "many" / "a"}),
            (std::vector<fs::path>{here / "one", here / "many" / "a", here / "many" / "b",
                                   here / "evaluation" / "fits" / "c"}));
  EXPECT_THROW(find_results({here / "many" / "not"}), UsageError);
  EXPECT_THROW(find_results({here / "nowhere"}), UsageError);
}

TEST_F(WriteReview, LinksFromThePageToTheReports) {
  const fs::path here = folder_.path();
  put(here / "fits" / "a #1%");
  write_review({here / "fits"}, here / "pages" / "review.html", false, Progress());
  const std::string page = read_file(here / "pages" / "review.html", 1 << 20);
  EXPECT_TRUE(has(page, R"(href="../fits/a%20%231%25/report.html")"));
  EXPECT_TRUE(has(page, "data:image/webp;base64,"));
}

TEST_F(WriteReview, TakesAPageWithoutAFolder) {
  put(folder_.path() / "a");
  const fs::path before = fs::current_path();
  fs::current_path(folder_.path());
  EXPECT_NO_THROW(write_review({"a"}, "review.html", false, Progress()));
  fs::current_path(before);
  EXPECT_TRUE(has(read_file(folder_.path() / "review.html", 1 << 20), R"(href="a/report.html")"));
}

TEST_F(WriteReview, ReplacesAPageOnlyWhenTold) {
  const fs::path here = folder_.path();
  put(here / "a");
  const fs::path page = here / "review.html";
  write_file(page, "mine");
  EXPECT_THROW(write_review({here / "a"}, page, false, Progress()), UsageError);
  EXPECT_EQ(read_file(page, 100), "mine");
  write_review({here / "a"}, page, true, Progress());
  EXPECT_TRUE(has(read_file(page, 1 << 20), "1 result to review"));
  EXPECT_THROW(write_review({here / "a"}, here, true, Progress()), UsageError);
}

TEST_F(WriteReview, NamesTheFolderThatHoldsNoResult) {
  const fs::path here = folder_.path();
  put(here / "a");
  fs::create_directories(here / "b");
  write_file(here / "b" / "result.json", "{}");
  try {
    write_review({here}, here / "review.html", false, Progress());
    FAIL() << "took it";
  } catch (const ReadError& error) {
    EXPECT_TRUE(has(error.what(), "b/result.json"));
  }
  EXPECT_FALSE(fs::exists(here / "review.html"));
}

TEST_F(WriteReview, TwoFoldersOfOneNameAreToldApart) {
  const fs::path here = folder_.path();
  put(here / "x" / "a");
  put(here / "y" / "a");
  write_review({here / "x", here / "y"}, here / "review.html", false, Progress());
  const std::string page = read_file(here / "review.html", 1 << 20);
  EXPECT_TRUE(has(page, R"(data-name="a")"));
  EXPECT_TRUE(has(page, "data-name=\"a (2)\""));
}

}  // namespace
}  // namespace regarment
