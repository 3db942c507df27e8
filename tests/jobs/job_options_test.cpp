#include "jobs/job_options.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "jobs/job_progress.h"
#include "support/texts.h"

namespace regarment {
namespace {

using Words = std::vector<std::string>;

std::string refusal(const std::string& json) {
  return refusal_of<UsageError>([&] { option_words(json); });
}

TEST(JobOptions, BecomeWordsInTheirOrder) {
  EXPECT_EQ(option_words("{}"), Words{});
  EXPECT_EQ(option_words(R"({"seed": 7, "method": "direct", "collisions": true, "as-printed": false,
                             "fix": {"length": 54, "skirt.hip": 95.25}, "hint": "waist_edge=103",
                             "layer_attenuation": 0.5})"),
            (Words{"--seed=7", "--method=direct", "--collisions", "--fix=length=54,skirt.hip=95.25",
                   "--hint=waist_edge=103", "--layer-attenuation=0.5"}));
}

TEST(JobOptions, NeverNameFilesOutputsOrThreads) {
  for (const char* name :
       {"out", "force", "threads", "placement", "ground-truth", "json", "ground-truth-labels",
        "no-state", "name", "garment", "progress", "x", "--seed", ""}) {
    EXPECT_NE(refusal("{\"" + std::string(name) + "\": true}").find("unknown or not for a service"),
              std::string::npos)
        << name;
  }
}

TEST(JobOptions, AreRefusedInOneLineThatNamesThem) {
  const std::pair<const char*, const char*> cases[] = {
      {"", "no JSON"},
      {"{", "no JSON"},
      {"[]", "no JSON object"},
      {"7", "no JSON object"},
      {R"({"seed": "7"})", "'seed' wants a number"},
      {R"({"method": 7})", "'method' wants a text"},
      {R"({"method": ""})", "'method' wants a text of 1"},
      {R"({"method": "a\u0000b"})", "'method' wants a text of 1"},
      {R"({"collisions": 1})", "'collisions' wants true or false"},
      {R"({"fix": {}})", "'fix' wants an object"},
      {R"({"fix": {"length": "x"}})", "'fix' wants numbers of cm"},
      {R"({"no_timing": true, "no-timing": true})", "given twice"},
      {R"({"fix": {"a": {"b": {"c": {}}}}})", "too deep"}};
  for (const auto& [json, what] : cases) {
    EXPECT_NE(refusal(json).find(what), std::string::npos) << json << ": " << refusal(json);
    EXPECT_EQ(refusal(json).find('\n'), std::string::npos);
  }
  EXPECT_NE(refusal(std::string(70000, ' ')).find("64 KiB"), std::string::npos);
}

TEST(JobOptions, AreListedInOrder) {
  const auto names = job_option_names();
  EXPECT_TRUE(std::is_sorted(names.begin(), names.end()));
  EXPECT_GT(names.size(), 10U);
}

TEST(JobProgress, ReadsLinesOfItsFormOnly) {
  const auto line = parse_progress(R"({"stage":"fit","fraction":0.5,"detail":"run 1"})");
  ASSERT_TRUE(line);
  EXPECT_EQ(line->stage + line->detail, "fitrun 1");
  EXPECT_EQ(line->fraction, 0.5);
  for (const char* other :
       {"", "fit", "{", "[]", "{}", R"({"stage":"fit"})", R"({"stage":"","fraction":0.5})",
        R"({"stage":"fit","fraction":1.5})", R"({"stage":"fit","fraction":"0.5"})",
        R"({"stage":1,"fraction":0.5})"}) {
    EXPECT_FALSE(parse_progress(other)) << other;
  }
}

TEST(JobProgress, NeverGoesBackAndEndsWhole) {
  JobProgress progress(JobKind::Fit);
  double before = 0;
  for (const char* stage : {"read", "prepare", "place", "measure", "fit", "fit", "measure", "fit",
                            "unheard of", "draw", "write"}) {
    for (const double fraction : {0.0, 0.5, 1.0}) {
      const double now = progress.after({stage, fraction, ""});
      EXPECT_GE(now, before);
      before = now;
    }
  }
  EXPECT_EQ(before, 1);
  EXPECT_EQ(JobProgress(JobKind::Render).after({"draw", 0.25, ""}), 0.25);
}

}  // namespace
}  // namespace regarment
