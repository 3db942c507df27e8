#include "http/client.h"

#include <gtest/gtest.h>

#include <fstream>

#include "base/away_error.h"
#include "echo_handler.h"
#include "scripted_peer.h"
#include "support/folders.h"

namespace regarment {
namespace {

using namespace std::chrono_literals;

constexpr std::size_t kMost = 100'000;

bool always() { return true; }

HttpAddress here(std::uint16_t port) { return {false, "127.0.0.1", port}; }

class ClientTest : public testing::Test {
 protected:
  ClientAnswer get(const std::string& target, Headers headers = {}) {
    return client_.ask({"GET", target, std::move(headers)}, kMost, always);
  }
  std::filesystem::path file(const std::string& bytes) {
    std::filesystem::path out = folder_.path() / "a";
    std::ofstream(out) << bytes;
    return out;
  }

  TemporaryFolder folder_;
  EchoHandler handler_;
  Server server_{{}, handler_};
  HttpClient client_{here(server_.port()), {}};
};

TEST_F(ClientTest, AsksOneAfterTheOtherOnOneConnection) {
  EXPECT_EQ(get("/quick").body, "quick");
  EXPECT_EQ(client_.ask({"POST", "/echo", {}, "hello"}, kMost, always).body, "hello");
  const ClientAnswer refused = get("/refuse");
  EXPECT_EQ(refused.status, 401);
  EXPECT_EQ(refused.headers.get("X-Why"), "test");
  EXPECT_NE(refused.body.find("no_key"), std::string::npos);
  EXPECT_EQ(get("/quick").body, "quick");
  EXPECT_EQ(server_.connections(), 1U);
}

TEST_F(ClientTest, SendsFilesAsTheyAre) {
  std::string bytes;
  for (int i = 0; i < 100'000; ++i) bytes += static_cast<char>(i % 251);
  ClientRequest request{"PUT", "/echo"};
  for (const std::string& content : {bytes, std::string()}) {
    request.file = file(content);
    EXPECT_EQ(client_.ask(request, kMost, always).body, content);
  }
  EXPECT_EQ(server_.connections(), 1U);
}

TEST_F(ClientTest, DoesNotSendAFileThatIsRefused) {
  ClientRequest request{"PUT", "/refuse"};
  request.file = file(std::string(EchoHandler::kLimit, 'x'));
  EXPECT_EQ(client_.ask(request, kMost, always).status, 401);
  request.target = "/echo";
  request.file = file(std::string(EchoHandler::kLimit + 1, 'x'));
  EXPECT_EQ(client_.ask(request, kMost, always).status, 413);
  EXPECT_EQ(get("/quick").body, "quick");
}

TEST_F(ClientTest, NeedsTheFileItIsToSend) {
  ClientRequest request{"PUT", "/echo"};
  for (const char* name : {"none", "."}) {
    request.file = folder_.path() / name;
    EXPECT_THROW(client_.ask(request, kMost, always), ReadError);
  }
  std::filesystem::create_symlink(file("secret"), folder_.path() / "link");
  request.file = folder_.path() / "link";
  EXPECT_THROW(client_.ask(request, kMost, always), ReadError);
}

class Kept : public AnswerBody {
 public:
  void begin(const ClientAnswer& answer) override { status = answer.status; }
  void take(std::string_view more) override { bytes.append(more); }

  int status = 0;
  std::string bytes;
};

TEST_F(ClientTest, HandsABodyOnAsItComes) {
  handler_.folder = folder_.path();
  const std::string bytes(500'000, 'x');
  file(bytes + "end");
  Kept whole, part;
  client_.ask({"GET", "/file"}, whole, always);
  EXPECT_EQ(whole.bytes, bytes + "end");
  client_.ask({"GET", "/file", {{"Range", "bytes=500000-"}}}, part, always);
  EXPECT_EQ(part.status, 206);
  EXPECT_EQ(part.bytes, "end");
}

TEST_F(ClientTest, EndsWhenItIsTold) {
  int asked = 0;
  const auto twice = [&] { return ++asked <= 2; };
  EXPECT_THROW(client_.ask({"GET", "/hold"}, kMost, twice), Stopped);
  handler_.release();
}

TEST_F(ClientTest, TakesNoKeyThatWouldBreakAHeader) {
  ClientOptions options;
  options.key = "rgm_a\r\nX-Other: b";
  EXPECT_THROW(HttpClient(here(server_.port()), options), UsageError);
}

class BadPeerTest : public testing::Test {
 protected:
  BadPeerTest() {
    options_.answer_time = options_.idle_time = 300ms;
    options_.connect_time = 10s;
  }
  ClientAnswer ask() {
    if (!client_) client_ = std::make_unique<HttpClient>(here(peer_.port()), options_);
    return client_->ask({"GET", "/"}, kMost, always);
  }

  ScriptedPeer peer_;
  ClientOptions options_;
  std::unique_ptr<HttpClient> client_;
};

TEST_F(BadPeerTest, WhatIsNoWholeAnswerIsAway) {
  const std::string head = "HTTP/1.1 200 OK\r\n";
  for (const std::string& text :
       {std::string(), std::string("H"), std::string("SSH-2.0-OpenSSH\r\n\r\n"), head,
        head + "Content-Length: 5\r\n\r\n1234", head + "Content-Length: -5\r\n\r\n",
        head + "Content-Length: 99999999999999999999999\r\n\r\n", head + ": x\r\n\r\n",
        head + "Transfer-Encoding: chunked\r\n\r\n4\r\nabcd\r\n",
        head + "Transfer-Encoding: chunked\r\n\r\nffffffffffffffffff\r\n",
        head + "Content-Length: 100001\r\n\r\n" + std::string(100'001, 'x')}) {
    peer_.answer(text);
    EXPECT_THROW(ask(), AwayError) << text.substr(0, 80);
  }
}

TEST_F(BadPeerTest, NothingComesWithoutEnd) {
  for (const char* text : {"X", "HTTP/1.1 100 Continue\r\n\r\n", "HTTP/1.1 204 "}) {
    peer_.answer(text, true);
    EXPECT_THROW(ask(), AwayError) << text;
  }
  peer_.answer("HTTP/1.1 200 OK\r\nX-A: " + std::string(1'000'000, 'a'));
  EXPECT_THROW(ask(), AwayError);
  peer_.answer("HTTP/1.1 200 OK\r\nTransfer-Encoding: chunked\r\n\r\n1;" +
               std::string(1'000'000, 'a'));
  EXPECT_THROW(ask(), AwayError);
}

TEST_F(BadPeerTest, ASilentOneIsAway) {
  for (const char* text :
       {"", "HTTP/1.1 200 OK\r\n", "HTTP/1.1 200 OK\r\nContent-Length: 5\r\n\r\n12"}) {
    peer_.answer(text, false, true);
    EXPECT_THROW(ask(), AwayError) << text;
  }
}

TEST_F(BadPeerTest, NobodyIsFollowedElsewhere) {
  peer_.answer("HTTP/1.1 302 Found\r\nLocation: http://127.0.0.1:1/\r\nContent-Length: 0\r\n\r\n");
  EXPECT_EQ(ask().status, 302);
  EXPECT_EQ(peer_.requests().size(), 1U);
}

TEST_F(BadPeerTest, AConnectionThatEndedIsMadeAnew) {
  for (const char* body : {"one", "two", "three"}) {
    peer_.answer(good_answer(body));
    EXPECT_EQ(ask().body, body);
  }
}

TEST_F(BadPeerTest, WhatFollowsAnAnswerIsNotTheNextOne) {
  peer_.answer(good_answer("one") + good_answer("false"), false, true);
  peer_.answer(good_answer("two"));
  EXPECT_EQ(ask().body, "one");
  EXPECT_EQ(ask().body, "two");
}

TEST_F(BadPeerTest, TheKeyIsSaidToTheServer) {
  options_.key = "rgm_key";
  peer_.answer(good_answer(""));
  ask();
  EXPECT_NE(peer_.requests().at(0).find("\r\nAuthorization: Bearer rgm_key\r\n"),
            std::string::npos);
}

TEST(Client, NobodyThereIsAway) {
  std::uint16_t port = 0;
  {
    const ScriptedPeer peer;
    port = peer.port();
  }
  HttpClient client(here(port), {});
  EXPECT_THROW(client.ask({"GET", "/"}, kMost, always), AwayError);
}

// What speaks no TLS is no server of an https address.
TEST(Client, TlsNeedsATlsServer) {
  ScriptedPeer peer;
  peer.answer(good_answer(""));
  ClientOptions options;
  options.connect_time = 300ms;  // what it waits for is an answer to its greeting
  HttpClient client({true, "127.0.0.1", peer.port()}, options);
  EXPECT_THROW(client.ask({"GET", "/"}, kMost, always), AwayError);
}

TEST(UrlEncoded, KeepsWhatIsPlainAndNothingElse) {
  EXPECT_EQ(url_encoded("a-Z_0.9~"), "a-Z_0.9~");
  EXPECT_EQ(url_encoded("a b/?%\xc3\xa4"), "a%20b%2F%3F%25%C3%A4");
}

}  // namespace
}  // namespace regarment
