#include "jobs/service_config.h"

#include <gtest/gtest.h>

#include <fstream>
#include <map>

#include "base/error.h"
#include "support/folders.h"
#include "support/texts.h"

namespace regarment {
namespace {

class ServiceConfigTest : public testing::Test {
 protected:
  ReadConfig read(const std::string& toml) {
    const auto file = folder_.path() / "service.toml";
    std::ofstream(file) << toml;
    return read_service_config(file, [&](const std::string& name) -> std::optional<std::string> {
      const auto found = environment_.find(name);
      if (found == environment_.end()) return std::nullopt;
      return found->second;
    });
  }
  std::string refusal(const std::string& toml) {
    return refusal_of<UsageError>([&] { read(toml); });
  }
  static std::string from(const ReadConfig& read, const std::string& name) {
    for (const ConfigEntry& entry : read.entries) {
      if (entry.name == name) return entry.value + " " + entry.from;
    }
    return "none";
  }

  TemporaryFolder folder_;
  std::map<std::string, std::string> environment_;
};

TEST_F(ServiceConfigTest, EnvironmentCountsMoreThanFileAndFileMoreThanDefaults) {
  environment_ = {{"REGARMENT_PORT", "0"}, {"REGARMENT_STORE", ""}, {"REGARMENT_OTHER", "x"}};
  const ReadConfig out = read("port = 81\nlease_seconds = 2\ndata = \"/srv/scans\"\n");
  EXPECT_EQ(out.config.port, 0);
  EXPECT_EQ(out.config.lease_seconds, 2);
  EXPECT_EQ(out.config.data, "/srv/scans");
  EXPECT_EQ(out.config.max_attempts, 3);
  EXPECT_EQ(out.config.store_or_default(), "/srv/scans/store.sqlite3");
  EXPECT_EQ(from(out, "port"), "0 environment");
  EXPECT_EQ(from(out, "lease_seconds"), "2 file");
  EXPECT_EQ(from(out, "max_attempts"), "3 default");
}

TEST_F(ServiceConfigTest, RefusesWhatItDoesNotKnowWithLineAndNearestName) {
  EXPECT_NE(refusal("port = 1\nleese_seconds = 3\n").find("line 2: leese_seconds"),
            std::string::npos);
  EXPECT_NE(refusal("leese_seconds = 3").find("did you mean lease_seconds?"), std::string::npos);
  EXPECT_NE(refusal("[server]\nport = 3").find("server"), std::string::npos);
}

TEST_F(ServiceConfigTest, RefusesWrongValuesInOneLine) {
  const std::pair<const char*, const char*> cases[] = {{"port = 70000", "is not from 0 to 65535"},
                                                       {"port = -1", "is not from 0 to 65535"},
                                                       {"port = 1.5", "is not a number"},
                                                       {"port = \"80\"", "wants a number"},
                                                       {"port = true", "wants a number"},
                                                       {"data = 3", "wants a text in quotes"},
                                                       {"data = \"\"", "is empty"},
                                                       {"lease_seconds = nan", "is not from"},
                                                       {"lease_seconds = 0", "is not from"},
                                                       {"max_queue = -5", "is not a number"},
                                                       {"port = [1]", "wants a number"},
                                                       {"port = ", "line 1"},
                                                       {"port = 1\nport = 2", "line 2"}};
  for (const auto& [toml, what] : cases) {
    EXPECT_NE(refusal(toml).find(what), std::string::npos) << toml << ": " << refusal(toml);
    EXPECT_EQ(refusal(toml).find('\n'), std::string::npos);
  }
  environment_ = {{"REGARMENT_WORKERS", "many"}};
  EXPECT_EQ(refusal(""), "REGARMENT_WORKERS: 'many' is not a number from 0 to 256");
}

TEST_F(ServiceConfigTest, ShowsNoKeyAndTakesOnlyAddressesOfServers) {
  environment_ = {{"REGARMENT_SERVER_KEY", "rgm_secret"}};
  const ReadConfig out = read("server = \"https://studio\"\n");
  EXPECT_EQ(out.config.server_key, "rgm_secret");
  EXPECT_EQ(from(out, "server_key"), "set environment");
  EXPECT_EQ(from(out, "server"), "https://studio file");
  environment_.clear();
  EXPECT_EQ(from(read(""), "server_key"), "not set default");
  const std::string said = refusal("server = \"http://me:secret@studio\"");
  EXPECT_NE(said.find("line 1: server: "), std::string::npos);
  EXPECT_EQ(said.find("secret"), std::string::npos);
}

TEST_F(ServiceConfigTest, NeedsTheFileItWasGiven) {
  EXPECT_THROW(read_service_config("/nowhere/service.toml"), ReadError);
}

}  // namespace
}  // namespace regarment
