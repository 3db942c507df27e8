#include "service/access.h"

#include <gtest/gtest.h>

#include "http/problem.h"
#include "support/folders.h"

namespace regarment {
namespace {

class AccessTest : public testing::Test {
 protected:
  std::string key(std::vector<Scope> scopes) { return issue_key(*store_, "test", scopes); }
  static Request request(Headers headers, std::string method = "GET") {
    Request out;
    out.method = std::move(method);
    out.headers = std::move(headers);
    return out;
  }
  int status_of(const Request& request) {
    try {
      access_.admit(request);
      return 200;
    } catch (const HttpProblem& problem) {
      return problem.status;
    }
  }

  TemporaryFolder folder_;
  std::unique_ptr<JobStore> store_ = open_job_store((folder_.path() / "store").string());
  Access access_{*store_};
};

TEST_F(AccessTest, WithoutKeysServesThisMachineAlone) {
  const Caller caller = access_.admit(request({{"Host", "localhost:8080"}}));
  EXPECT_TRUE(caller.may(Scope::Admin));
  EXPECT_EQ(caller.key.id, "");
  EXPECT_EQ(status_of(request({{"Host", "evil.example"}})), 421);
  EXPECT_EQ(status_of(request({})), 421);
}

TEST_F(AccessTest, AKeyIsNeededAsSoonAsThereIsOne) {
  const std::string secret = key({Scope::Read});
  EXPECT_EQ(status_of(request({{"Host", "localhost"}})), 401);
  EXPECT_EQ(status_of(request({{"X-API-Key", secret + "0"}})), 401);
  EXPECT_EQ(status_of(request({{"Authorization", "Basic " + secret}})), 401);
  for (const Headers& headers : {Headers{{"X-API-Key", secret}, {"Host", "far.example"}},
                                 Headers{{"authorization", "bearer  " + secret}}}) {
    const Caller caller = access_.admit(request(headers));
    EXPECT_TRUE(caller.may(Scope::Read));
    EXPECT_FALSE(caller.may(Scope::Submit));
  }
}

TEST_F(AccessTest, ARevokedKeyIsNone) {
  const std::string kept = key({Scope::Read}), gone = key({Scope::Read});
  const std::string id = access_.admit(request({{"X-API-Key", gone}})).key.id;
  EXPECT_TRUE(store_->revoke_key(id));
  EXPECT_EQ(status_of(request({{"X-API-Key", gone}})), 401);
  EXPECT_EQ(status_of(request({{"X-API-Key", kept}})), 200);
}

TEST_F(AccessTest, ASessionIsACookieThatPagesCannotReadOrSendFromElsewhere) {
  const std::string cookie = access_.begin_session(key({Scope::Review}));
  EXPECT_NE(cookie.find("; HttpOnly"), std::string::npos);
  EXPECT_NE(cookie.find("; SameSite=Strict"), std::string::npos);
  const std::string pair = cookie.substr(0, cookie.find(';'));
  const Request asks = request({{"Cookie", "a=b; " + pair}});
  EXPECT_TRUE(access_.admit(asks).may(Scope::Review));
  EXPECT_EQ(status_of(request({{"Cookie", pair + "0"}})), 401);
  access_.end_session(asks);
  EXPECT_EQ(status_of(asks), 401);
  EXPECT_THROW(access_.begin_session("rgm_wrong"), HttpProblem);
}

TEST_F(AccessTest, ForeignPagesChangeNothing) {
  const std::string host = "127.0.0.1:8080";
  for (const Headers& headers : {Headers{{"Host", host}, {"Origin", "http://evil.example"}},
                                 Headers{{"Host", host}, {"Origin", "null"}},
                                 Headers{{"Host", host}, {"Origin", "http://127.0.0.1:8081"}},
                                 Headers{{"Host", host}, {"Sec-Fetch-Site", "cross-site"}},
                                 Headers{{"Host", host}, {"Sec-Fetch-Site", "same-site"}}}) {
    EXPECT_EQ(status_of(request(headers, "POST")), 403);
    EXPECT_EQ(status_of(request(headers)), 200);
  }
  EXPECT_EQ(status_of(request({{"Host", host}, {"Origin", "http://" + host}}, "DELETE")), 200);
  EXPECT_EQ(status_of(request({{"Host", host}}, "POST")), 200);
}

TEST(MeansThisMachine, KnowsItsNames) {
  for (const char* host :
       {"localhost", "LocalHost:1", "127.0.0.1", "127.0.0.1:8080", "[::1]", "[::1]:80"})
    EXPECT_TRUE(means_this_machine(host)) << host;
  for (const char* host : {"", "localhost.evil", "evil:localhost", "127.0.0.1.evil", "127.0.0.2",
                           "::1", "[::1", "localhost:80:80", "localhost:x"})
    EXPECT_FALSE(means_this_machine(host)) << host;
}

TEST(Caller, SubmittersSeeTheirOwnJobsAndReadersAll) {
  Job own, other;
  own.owner = "a";
  other.owner = "b";
  const Caller submitter{{"a", "", {Scope::Submit}, {}, {}}};
  EXPECT_TRUE(submitter.may_see(own) && submitter.may_change(own));
  EXPECT_FALSE(submitter.may_see(other) || submitter.may_change(other));
  const Caller reader{{"a", "", {Scope::Read}, {}, {}}};
  EXPECT_TRUE(reader.may_see(other));
  EXPECT_FALSE(reader.may_change(own));
  const Caller admin{{"c", "", {Scope::Admin}, {}, {}}};
  EXPECT_TRUE(admin.may_see(other) && admin.may_change(other));
}

}  // namespace
}  // namespace regarment
