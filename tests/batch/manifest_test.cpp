#include "batch/manifest.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "base/error.h"
#include "batches.h"

namespace regarment {
namespace {

using Json = nlohmann::json;

TEST(Manifest, ReadsBackWhatItWrote) {
  Manifest plan = plan_of({"a", "b", "c"});
  plan.scans[1].words = {"/data/\"quoted\"\n--wait.ply", "--fix", "hip=95"};
  plan.scans_folder = "/more scans";
  plan.only = "a*";
  const std::string json = manifest_json(plan);
  const Manifest back = parse_manifest(json, "m");
  EXPECT_EQ(manifest_json(back), json);
  EXPECT_EQ(back.scans[1].words, plan.scans[1].words);
  EXPECT_EQ(back.scans_folder, plan.scans_folder);
  EXPECT_EQ(back.timeout, 60);
}

TEST(Manifest, EveryScanIsInOneShard) {
  const Manifest plan = plan_of({"a", "b", "c", "d", "e"});
  ASSERT_EQ(plan.shards(), 3u);
  std::size_t next = 0;
  for (std::size_t i = 0; i < plan.shards(); ++i) {
    const auto [first, end] = plan.shard(i);
    EXPECT_EQ(first, next);
    EXPECT_GT(end, first);
    next = end;
  }
  EXPECT_EQ(next, 5u);
  EXPECT_THROW(plan.shard(3), UsageError);
}

TEST(Manifest, SaysWhichPathIsNoText) {
  Manifest plan = plan_of({"a"});
  plan.scans[0].file = "/data/\xff.ply";
  EXPECT_THROW(manifest_json(plan), UsageError);
}

// A folder may come from anywhere.
TEST(Manifest, TakesNothingElse) {
  const Json good = Json::parse(manifest_json(plan_of({"a"})));
  const auto expect_refused = [&](const std::string& at, const Json& value) {
    Json bad = good;
    bad[Json::json_pointer(at)] = value;
    EXPECT_THROW(parse_manifest(bad.dump(), "m"), ReadError) << at << " " << value;
  };
  expect_refused("/format", "regarment.batch/2");
  expect_refused("/scans", Json::array());
  expect_refused("/scans/0/name", "../../etc");
  expect_refused("/scans/0/name", ".hidden");
  expect_refused("/scans/0/name", "");
  expect_refused("/scans/0/fit", "all");
  expect_refused("/shard_size", 0);
  expect_refused("/shard_size", "many");
  expect_refused("/timeout_s", -1);
  for (const char* text : {"", "{", "[]", "null", "{\"format\": 1}"}) {
    EXPECT_THROW(parse_manifest(text, "m"), ReadError) << text;
  }
}

}  // namespace
}  // namespace regarment
