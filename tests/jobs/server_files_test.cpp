// Against a server that the test makes up, right or wrong; the worker against a true one is in
// tests/service/work_test.cpp.

#include "jobs/server_files.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <span>

#include "base/away_error.h"
#include "base/sha256.h"
#include "scripted_peer.h"
#include "store_places.h"

namespace regarment {
namespace {

using namespace std::chrono_literals;

bool always() { return true; }

std::string hash_of(const std::string& text) { return sha256_hex(std::as_bytes(std::span(text))); }

class ServerFilesTest : public testing::Test {
 protected:
  ServerFilesTest() {
    FileServer server{{false, "127.0.0.1", peer_.port()}, {}, 10s};
    server.client.answer_time = server.client.idle_time = 300ms;
    files_ = std::make_unique<ServerFiles>(server, folder_.path() / "scratch");
    NewJob job;
    job.id = new_job_id();
    store_->create(job);
    claim_ = *store_->claim("w", 1h, 3);
    name_ = job.id + "/scan.ply";
  }
  void announce(const std::string& name, std::uint64_t bytes, const std::string& sha256) {
    peer_.answer(good_answer(R"({"files": [{"name": ")" + name + R"(", "bytes": )" +
                             std::to_string(bytes) + R"(, "sha256": ")" + sha256 + R"("}]})"));
  }
  void fetch() { files_->fetch(claim_, *store_, always); }
  std::string fetched() {
    std::ifstream file(files_->folders().scan(claim_.job.id));
    return {std::istreambuf_iterator<char>(file), {}};
  }

  TemporaryFolder folder_;
  ScriptedPeer peer_;
  std::unique_ptr<JobStore> store_ = open_job_store((folder_.path() / "store").string());
  std::unique_ptr<ServerFiles> files_;
  Claim claim_;
  std::string name_;
};

TEST_F(ServerFilesTest, TakesUpWhereAFileBrokeOff) {
  announce(name_, 10, hash_of("0123456789"));
  peer_.answer("HTTP/1.1 200 OK\r\nETag: \"a\"\r\nContent-Length: 10\r\n\r\n0123");
  peer_.answer(
      "HTTP/1.1 206 Partial Content\r\nETag: \"a\"\r\nContent-Length: 6\r\n"
      "Content-Range: bytes 4-9/10\r\n\r\n45");
  peer_.answer("HTTP/1.1 503 Service Unavailable\r\nContent-Length: 0\r\n\r\n");
  peer_.answer(
      "HTTP/1.1 206 Partial Content\r\nContent-Length: 4\r\n"
      "Content-Range: bytes 6-9/10\r\n\r\n6789");
  fetch();
  EXPECT_EQ(fetched(), "0123456789");
  const auto requests = peer_.requests();
  ASSERT_EQ(requests.size(), 5U);
  EXPECT_EQ(requests[1].find("Range"), std::string::npos);
  EXPECT_NE(requests[2].find("\r\nRange: bytes=4-\r\nIf-Range: \"a\"\r\n"), std::string::npos);
  EXPECT_NE(requests[4].find("\r\nRange: bytes=6-\r\n"), std::string::npos);
}

TEST_F(ServerFilesTest, BeginsAgainWhereTheFileIsAnother) {
  announce(name_, 4, hash_of("abcd"));
  peer_.answer("HTTP/1.1 200 OK\r\nETag: \"a\"\r\nContent-Length: 4\r\n\r\nxyz");
  peer_.answer("HTTP/1.1 200 OK\r\nETag: \"b\"\r\nContent-Length: 4\r\n\r\nabcd");
  fetch();
  EXPECT_EQ(fetched(), "abcd");
}

TEST_F(ServerFilesTest, TakesNoOtherBytesThanWereAnnounced) {
  const std::string wrong[] = {
      good_answer("abce"), good_answer("abcde"),
      "HTTP/1.1 206 Partial Content\r\nContent-Length: 2\r\nContent-Range: bytes 2-3/4\r\n\r\ncd"};
  for (const std::string& answer : wrong) {
    announce(name_, 4, hash_of("abcd"));
    peer_.answer(answer);
    EXPECT_THROW(fetch(), TemporaryError) << answer;
  }
}

TEST_F(ServerFilesTest, NoNameLeadsOutOfTheScratchFolder) {
  const std::string id = claim_.job.id;
  const std::string wrong[] = {
      id + "/../../x",           "/proc/x", "../x", id, id + "/.x", id + "0/x", "/result-1/x", "",
      new_job_id() + "/scan.ply"};
  for (const std::string& name : wrong) {
    announce(name, 1, hash_of("a"));
    EXPECT_THROW(fetch(), NoAccess) << name;
  }
  EXPECT_TRUE(names_in(files_->folders().data() / "jobs").empty());
}

TEST_F(ServerFilesTest, TakesNoMoreThanTheDiskHolds) {
  announce(name_, 1ULL << 62U, hash_of("a"));
  EXPECT_THROW(fetch(), TemporaryError);
}

TEST_F(ServerFilesTest, WhatIsNoListIsNotTrusted) {
  for (const char* body : {"", "[]", "{}", R"({"files": 1})", R"({"files": [1]})",
                           R"({"files": [{"name": 1, "bytes": 1, "sha256": ""}]})"}) {
    peer_.answer(good_answer(body));
    EXPECT_THROW(fetch(), NoAccess) << body;
  }
  peer_.answer("HTTP/1.1 302 Found\r\nLocation: http://127.0.0.1:1/\r\nContent-Length: 0\r\n\r\n");
  EXPECT_THROW(fetch(), NoAccess);
}

TEST_F(ServerFilesTest, AnAnswerSaysWhoseFaultItIs) {
  const auto answer = [&](int status, const std::string& code) {
    const std::string body = R"({"code": ")" + code + R"(", "detail": "the line"})";
    peer_.answer("HTTP/1.1 " + std::to_string(status) +
                 " X\r\nContent-Length: " + std::to_string(body.size()) + "\r\n\r\n" + body);
  };
  for (const auto& [status, code] : {std::pair(404, "no_such_job"), std::pair(409, "not_held")}) {
    answer(status, code);
    EXPECT_THROW(fetch(), ClaimLost);
  }
  for (const auto& [status, code] :
       {std::pair(401, "no_key"), std::pair(403, "no_scope"), std::pair(404, "no_such_address")}) {
    answer(status, code);
    EXPECT_THROW(fetch(), NoAccess);
  }
  answer(422, "unreadable");
  EXPECT_THROW(fetch(), ReadError);
  for (const auto& [status, code] : {std::pair(500, "internal"), std::pair(507, "no_space")}) {
    answer(status, code);
    EXPECT_THROW(fetch(), TemporaryError);
  }
  answer(422, "bad_request");
  try {
    fetch();
    ADD_FAILURE();
  } catch (const UsageError& error) {
    EXPECT_STREQ(error.what(), "the line");
  }
}

TEST_F(ServerFilesTest, WhoEndsItWhileTheServerIsAwayNeedNotWait) {
  int asked = 0;
  EXPECT_THROW(files_->fetch(claim_, *store_, [&] { return ++asked < 5; }), Stopped);
}

}  // namespace
}  // namespace regarment
