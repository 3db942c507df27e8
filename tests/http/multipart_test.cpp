#include "http/multipart.h"

#include <gtest/gtest.h>

#include "http/problem.h"

namespace regarment {
namespace {

// What a form held, as text: "name|filename|type|data;".
class Taken : public FormReceiver {
 public:
  void begin_part(const FormPart& part) override {
    text += part.name + "|" + part.filename.value_or("-") + "|" + part.content_type + "|";
  }
  void take_data(std::string_view bytes) override {
    EXPECT_FALSE(bytes.empty());
    text.append(bytes);
  }
  void end_part() override { text += ";"; }

  std::string text;
};

std::string take(const std::string& form, std::size_t piece) {
  Taken taken;
  FormParser parser("XX", taken);
  for (std::size_t at = 0; at < form.size(); at += piece) parser.take(form.substr(at, piece));
  parser.finish();
  return taken.text;
}

std::string part(const std::string& disposition, const std::string& data) {
  return "--XX\r\nContent-Disposition: form-data; " + disposition + "\r\n\r\n" + data + "\r\n";
}

TEST(FormParser, TakesPartsWhateverThePieces) {
  const std::string almost = "\r\n--X\r\n--\r\n\r\n--xx\r\n-";
  const std::string form = part("name=\"a\"; filename=\"s.ply\"", almost) + part("name=b", "") +
                           "--XX\r\ncontent-type: text/plain\r\n"
                           "CONTENT-DISPOSITION: Form-Data; name=\"c\"\r\n\r\n1\r\n--XX--\r\n";
  for (std::size_t piece = 1; piece <= form.size(); ++piece)
    ASSERT_EQ(take(form, piece), "a|s.ply||" + almost + ";b|-||;c|-|text/plain|1;") << piece;
}

TEST(FormParser, TakesTheLongestHeaderWhateverThePieces) {
  const auto form = [](std::size_t header) {
    const std::string known = "Content-Disposition: form-data; name=a\r\nX: ";
    return "--XX\r\n" + known + std::string(header - known.size(), 'x') + "\r\n\r\n1\r\n--XX--";
  };
  for (const std::size_t piece : {1U, 2U, 3U, 4U, 5U, 10'000U}) {
    EXPECT_EQ(take(form(4096), piece), "a|-||1;") << piece;
    EXPECT_THROW(take(form(4097), piece), HttpProblem) << piece;
  }
}

TEST(FormParser, HandsOutDataBeforeThePartEnds) {
  Taken taken;
  FormParser parser("XX", taken);
  const std::string data(100000, 'z');
  parser.take(part("name=a", data).substr(0, 100000));
  EXPECT_GT(taken.text.size(), 99900U);  // all but the header and what may begin a boundary
}

TEST(FormParser, RefusesWhatIsNoForm) {
  const std::string good = part("name=a", "1");
  const std::string long_header = "--XX\r\nX: " + std::string(5000, 'x');
  std::string many;
  for (int i = 0; i < 33; ++i) many += part("name=a", "");
  for (const std::string& form :
       {std::string(""),
        std::string("--XX--\r\n"),
        std::string("x--XX"),
        "\r\n" + good,
        good,
        good + "--XX",
        good + "--XX-",
        good + "--XX--more",
        good + "--XX--\r\n\r\n",
        good + "--XXX--",
        std::string("--XX\r\n\r\n1\r\n--XX--"),
        std::string("--XX\r\nContent-Disposition: form-data\r\n\r\n1\r\n--XX--"),
        std::string("--XX\r\nContent-Disposition: attachment; name=a\r\n\r\n1\r\n--XX--"),
        std::string("--XX\r\nno colon\r\n\r\n1\r\n--XX--"),
        part("name=\"\"", "1") + "--XX--",
        part("name=a\r\nContent-Disposition: form-data; name=b", "1") + "--XX--",
        part("name=a\r\nContent-Transfer-Encoding: base64", "1") + "--XX--",
        part(std::string("name=a\0", 7), "1") + "--XX--",
        part("name=a\nX: b", "1") + "--XX--",
        long_header,
        many + "--XX--"}) {
    for (const std::size_t piece : {std::size_t{1}, form.size() + 1})
      EXPECT_THROW(take(form, piece), HttpProblem) << form.substr(0, 200) << " in " << piece;
  }
}

TEST(FormParser, AnEmptyLineMayFollowTheLastBoundary) {
  EXPECT_EQ(take(part("name=a", "1") + "--XX--", 7), "a|-||1;");
  EXPECT_EQ(take(part("name=a", "1") + "--XX--\r\n", 1), "a|-||1;");
}

TEST(FormBoundary, HasUpToSeventyCharacters) {
  EXPECT_EQ(form_boundary("multipart/form-data; boundary=abc"), "abc");
  EXPECT_EQ(form_boundary("multipart/form-data; boundary=\"a b?\""), "a b?");
  EXPECT_EQ(form_boundary("multipart/form-data; boundary=" + std::string(70, 'b')),
            std::string(70, 'b'));
  for (const std::string& boundary :
       {std::string("\"\""), std::string(71, 'b'), std::string("\"a \""), std::string("\"a\rb\""),
        std::string("\"a*\"")})
    EXPECT_THROW(form_boundary("multipart/form-data; boundary=" + boundary), HttpProblem);
  EXPECT_THROW(form_boundary("multipart/form-data"), HttpProblem);
}

}  // namespace
}  // namespace regarment
