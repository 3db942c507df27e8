// worker, key, config and doctor, seen from outside.

#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "failures.h"
#include "support/folders.h"

namespace regarment {
namespace {

using Json = nlohmann::json;

class ServiceCommands : public testing::Test {
 protected:
  ProgramRun run(Arguments arguments) {
    arguments.insert(arguments.end(), {"--data", data()});
    return run_program(arguments, 60);
  }
  std::string data() const { return (home_.path() / "data").string(); }

  TemporaryFolder home_;
};

TEST_F(ServiceCommands, AKeyIsAddedListedAndRevoked) {
  const ProgramRun added = run({"key", "add", "scanner", "--scope", "submit", "--scope", "read"});
  ASSERT_EQ(added.status, 0) << added.err;
  const std::string secret = lines_of(added.out).at(0);
  EXPECT_TRUE(secret.starts_with("rgm_"));
  const Json keys = Json::parse(run({"key", "list", "--json"}).out);
  ASSERT_EQ(keys.size(), 1U);
  EXPECT_EQ(keys[0].at("name"), "scanner");
  EXPECT_EQ(keys[0].at("scopes"), (Json{"submit", "read"}));
  const std::string id = keys[0].at("id");
  EXPECT_NE(secret.find(id), std::string::npos);
  EXPECT_EQ(run({"key", "list"}).out.find(secret), std::string::npos);
  EXPECT_EQ(run({"key", "revoke", id}).status, 0);
  EXPECT_EQ(run({"key", "revoke", id}).status, 2);
  EXPECT_TRUE(Json::parse(run({"key", "list", "--json"}).out)[0].contains("revoked"));
}

TEST_F(ServiceCommands, AKeyNeedsWhatItsActionNeeds) {
  EXPECT_EQ(run({"key"}).status, 2);
  EXPECT_EQ(run({"key", "make"}).status, 2);
  EXPECT_EQ(run({"key", "add", "a"}).status, 2);
  EXPECT_EQ(run({"key", "add", "--scope", "read"}).status, 2);
  EXPECT_EQ(run({"key", "add", "a", "--scope", "all"}).status, 2);
  EXPECT_EQ(run({"key", "list", "a"}).status, 2);
  EXPECT_EQ(run({"key", "revoke"}).status, 2);
}

TEST_F(ServiceCommands, TheConfigSaysWhoSetWhat) {
  const std::string file = home_.path() / "service.toml";
  std::ofstream(file) << "port = 0\nworkers = 3\n";
  const ProgramRun good = run({"config", "check", "--config", file, "--json"});
  ASSERT_EQ(good.status, 0) << good.err;
  const Json fields = Json::parse(good.out);
  EXPECT_EQ(fields.at("workers"), (Json{{"value", "3"}, {"from", "file"}}));
  EXPECT_EQ(fields.at("data").at("from"), "command line");
  std::ofstream(file) << "prot = 0\n";
  const ProgramRun bad = run({"config", "check", "--config", file});
  EXPECT_EQ(bad.status, 2);
  EXPECT_NE(bad.err.find("did you mean port?"), std::string::npos) << bad.err;
}

TEST_F(ServiceCommands, TheDoctorLooksAtEveryPart) {
  const ProgramRun well = run({"doctor", "--json"});
  const Json parts = Json::parse(well.out);
  EXPECT_EQ(parts.size(), 8U);
  for (const Json& part : parts) {
    // A build with sanitizers reads scans in the open, and is told so.
    if (part.at("part") == "sandbox") continue;
    EXPECT_TRUE(part.at("ok")) << part;
  }
  std::ofstream(data() + "/store.sqlite3") << std::string(4096, 'x');
  const ProgramRun ill = run({"doctor"});
  EXPECT_EQ(ill.status, 5);
  EXPECT_NE(ill.out.find("failed  store"), std::string::npos) << ill.out;
  EXPECT_NE(ill.out.find("ok      disk"), std::string::npos) << ill.out;
}

TEST_F(ServiceCommands, AWorkerEndsWhenNothingWaits) {
  EXPECT_EQ(run({"worker", "--until-empty"}).status, 0);
  std::ofstream(data() + "/not a folder") << "x";
  EXPECT_EQ(run_program({"worker", "--data", data() + "/not a folder"}).status, 2);
}

TEST_F(ServiceCommands, ProgressMayBeJsonLines) {
  const ProgramRun drawn = run_program({"render", example("skirt-1.mesh.ply"), "--out",
                                        home_.path() / "pictures", "--progress", "json"},
                                       kFitSeconds);
  ASSERT_EQ(drawn.status, 0) << drawn.err;
  const auto lines = lines_of(drawn.err);
  EXPECT_GT(lines.size(), 1U);
  for (const std::string& line : lines) {
    const Json said = Json::parse(line);
    EXPECT_TRUE(said.at("stage").is_string());
    EXPECT_GE(said.at("fraction"), 0.0);
    EXPECT_LE(said.at("fraction"), 1.0);
  }
}

}  // namespace
}  // namespace regarment
