#include "base/stage_cache.h"

#include <gtest/gtest.h>

#include <chrono>
#include <fstream>
#include <thread>

#include "base/error.h"
#include "support/folders.h"

namespace regarment {
namespace {

namespace fs = std::filesystem;

void use_at(const fs::path& file, int seconds_ago) {
  fs::last_write_time(file, fs::file_time_type::clock::now() - std::chrono::seconds(seconds_ago));
}

TEST(StageCache, GivesBackWhatWasPut) {
  const TemporaryFolder home;
  const StageCache cache(home.path() / "a/b", 1000);
  EXPECT_FALSE(cache.get("x").has_value());
  const std::string bytes("\0a\nb", 4);
  cache.put("x", bytes);
  EXPECT_EQ(StageCache(home.path() / "a/b", 1).get("x"), bytes);
  cache.put("x", "again");
  EXPECT_EQ(cache.get("x"), "again");
  EXPECT_EQ(names_in(home.path() / "a/b").size(), 1U);
}

TEST(StageCache, ForgetsWhatWasNotUsedForLongest) {
  const TemporaryFolder home;
  const StageCache cache(home.path(), 10);
  cache.put("a", "1234");
  cache.put("b", "1234");
  use_at(home.path() / "a.stage", 200);
  use_at(home.path() / "b.stage", 300);
  EXPECT_TRUE(cache.get("b").has_value());  // used now
  cache.put("c", "1234");
  EXPECT_FALSE(cache.get("a").has_value());
  EXPECT_TRUE(cache.get("b").has_value());
  EXPECT_TRUE(cache.get("c").has_value());
}

TEST(StageCache, KeepsNothingThatIsTooLargeAndLeavesOthersFiles) {
  const TemporaryFolder home;
  std::ofstream(home.path() / "mine.txt") << std::string(100, 'x');
  const StageCache cache(home.path(), 10);
  cache.put("a", std::string(11, 'x'));
  cache.put("b", "1234567890");
  EXPECT_FALSE(cache.get("a").has_value());
  EXPECT_TRUE(cache.get("b").has_value());
  EXPECT_TRUE(fs::exists(home.path() / "mine.txt"));
}

TEST(StageCache, TakesAwayWhatAKilledProcessLeft) {
  const TemporaryFolder home;
  std::ofstream(home.path() / "a.stage-new-abcdef") << "12345678";
  use_at(home.path() / "a.stage-new-abcdef", 100);
  StageCache(home.path(), 10).put("b", "1234");
  EXPECT_EQ(names_in(home.path()), std::vector<std::string>{"b.stage"});
}

TEST(StageCache, IsSafeWithManyAtOnce) {
  const TemporaryFolder home;
  // Room for two of four entries: they are put, read and taken away at once.
  const auto work = [&](int self) {
    const StageCache cache(home.path(), 2 * 5000);
    for (int i = 0; i < 100; ++i) {
      const std::string name(1, static_cast<char>('a' + (i + self) % 4));
      if (const auto found = cache.get(name)) {
        EXPECT_EQ(*found, std::string(5000, name[0]));
      }
      cache.put(name, std::string(5000, name[0]));
    }
  };
  std::vector<std::jthread> all;
  for (int self = 0; self < 4; ++self) all.emplace_back(work, self);
  all.clear();
  EXPECT_LE(names_in(home.path()).size(), 4U);
}

TEST(StageCache, RefusesWhatIsNoFolder) {
  const TemporaryFolder home;
  std::ofstream(home.path() / "file") << "x";
  EXPECT_THROW(StageCache(home.path() / "file", 10), UsageError);
  EXPECT_THROW(StageCache(home.path() / "file/below", 10), UsageError);
}

TEST(BuildIdentity, IsKnown) { EXPECT_GE(build_identity().size(), 8U); }

}  // namespace
}  // namespace regarment
