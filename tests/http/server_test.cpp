#include "http/server.h"

#include <gtest/gtest.h>

#include <fstream>

#include "base/error.h"
#include "echo_handler.h"
#include "raw_client.h"
#include "support/folders.h"

namespace regarment {
namespace {

class ServerTest : public testing::Test {
 protected:
  static ServerOptions quick_polls() {
    ServerOptions options;
    options.event_poll = std::chrono::milliseconds(10);
    return options;
  }
  std::uint16_t port() const { return server_.port(); }
  std::string get(const std::string& path, const std::string& fields = "") {
    return ask(port(),
               "GET " + path + " HTTP/1.1\r\nHost: a\r\nConnection: close\r\n" + fields + "\r\n");
  }

  EchoHandler handler_;
  Server server_{quick_polls(), handler_};
};

TEST_F(ServerTest, AnswersOnOneConnectionOneAfterTheOther) {
  RawClient client(port());
  client.send("GET /quick HTTP/1.1\r\nHost: a\r\n\r\n");
  EXPECT_EQ(body_of(client.receive_answer()), "quick");
  // Two at once, the first with a body.
  client.send(
      "POST /echo HTTP/1.1\r\nHost: a\r\nContent-Length: 5\r\n\r\nhello"
      "GET /quick HTTP/1.1\r\nHost: a\r\n\r\n");
  EXPECT_EQ(body_of(client.receive_answer()), "hello");
  EXPECT_EQ(body_of(client.receive_answer()), "quick");
}

TEST_F(ServerTest, TakesChunkedBodies) {
  EXPECT_EQ(body_of(ask(port(),
                        "POST /echo HTTP/1.1\r\nHost: a\r\nConnection: close\r\n"
                        "Transfer-Encoding: chunked\r\n\r\n3\r\nabc\r\nA;x=y\r\n0123456789\r\n"
                        "0\r\n\r\n")),
            "abc0123456789");
}

TEST_F(ServerTest, AsksForTheBodyOnlyWhenItWantsIt) {
  const std::string fields = "Host: a\r\nContent-Length: 2\r\nExpect: 100-continue\r\n\r\n";
  RawClient wanted(port());
  wanted.send("POST /echo HTTP/1.1\r\n" + fields);
  EXPECT_EQ(wanted.receive_until("\r\n\r\n"), "HTTP/1.1 100 Continue\r\n\r\n");
  wanted.send("ok");
  EXPECT_EQ(body_of(wanted.receive_answer()), "ok");
  RawClient refused(port());
  refused.send("POST /refuse HTTP/1.1\r\n" + fields);
  const std::string answer = refused.receive_all();
  EXPECT_EQ(status_of(answer), 401);
  EXPECT_EQ(field_of(answer, "Connection"), "close");
}

TEST_F(ServerTest, TellsAProblemInJsonWithTheRequestsId) {
  const std::string answer = get("/refuse");
  EXPECT_EQ(status_of(answer), 401);
  EXPECT_EQ(field_of(answer, "Content-Type"), "application/problem+json");
  EXPECT_EQ(field_of(answer, "X-Why"), "test");
  EXPECT_NE(body_of(answer).find("\"code\": \"no_key\""), std::string::npos);
  EXPECT_NE(body_of(answer).find(field_of(answer, "X-Request-Id")), std::string::npos);
}

TEST_F(ServerTest, TellsNothingOfItsInside) {
  const std::string answer = get("/crash");
  EXPECT_EQ(status_of(answer), 500);
  EXPECT_EQ(answer.find("secret"), std::string::npos);
  const std::string away = get("/away");
  EXPECT_EQ(status_of(away), 503);
  EXPECT_EQ(away.find("secret"), std::string::npos);
  EXPECT_EQ(status_of(get("/full")), 507);
  EXPECT_EQ(status_of(get("/late")), 422);
}

TEST_F(ServerTest, EveryAnswerHasSecurityHeaders) {
  for (const char* path : {"/quick", "/echo", "/refuse", "/crash", "/a%"}) {
    const std::string answer = get(path);
    EXPECT_EQ(field_of(answer, "X-Content-Type-Options"), "nosniff") << path;
    EXPECT_EQ(field_of(answer, "Cache-Control"), "no-store") << path;
    EXPECT_TRUE(field_of(answer, "Content-Security-Policy").starts_with("default-src 'none'"));
  }
}

TEST_F(ServerTest, HeadIsTheSameWithoutTheBody) {
  const std::string answer =
      ask(port(), "HEAD /quick HTTP/1.1\r\nHost: a\r\nConnection: close\r\n\r\n");
  EXPECT_EQ(status_of(answer), 200);
  EXPECT_EQ(field_of(answer, "Content-Length"), "5");
  EXPECT_EQ(body_of(answer), "");
}

TEST_F(ServerTest, SendsFilesAndParts) {
  const TemporaryFolder folder;
  handler_.folder = folder.path();
  std::string bytes(300'000, 'x');
  bytes += "end";
  std::ofstream(folder.path() / "a") << bytes;
  EXPECT_EQ(body_of(get("/file")), bytes);
  EXPECT_EQ(body_of(get("/file", "Range: bytes=299999-\r\n")), "xend");
  std::string ranges = "Range: bytes=0-";
  for (int i = 0; i < 1200; ++i) ranges += ",0-";
  EXPECT_EQ(status_of(get("/file", ranges + "\r\n")), 200);
}

TEST_F(ServerTest, SendsEventsAsTheyCome) {
  const std::string answer = get("/events");
  EXPECT_EQ(field_of(answer, "Transfer-Encoding"), "chunked");
  EXPECT_EQ(body_of(answer), "7\r\nid: 1\n\n\r\n7\r\nid: 2\n\n\r\n7\r\nid: 3\n\n\r\n0\r\n\r\n");
  // HTTP/1.0 knows no chunks: the end of the connection is the end.
  EXPECT_EQ(body_of(ask(port(), "GET /events HTTP/1.0\r\n\r\n")), "id: 1\n\nid: 2\n\nid: 3\n\n");
}

TEST_F(ServerTest, TellsOfEachRequestOnce) {
  get("/quick");
  get("/refuse");
  {
    RawClient gone(port());
    gone.send("POST /echo HTTP/1.1\r\nHost: a\r\nContent-Length: 10\r\n\r\nhalf");
  }
  EXPECT_EQ(handler_.wait_for_served(3), (std::vector<int>{200, 401, 0}));
}

TEST_F(ServerTest, StopsOnceOpenRequestsAreAnswered) {
  RawClient idle(port()), held(port()), watching(port());
  watching.send("GET /endless HTTP/1.1\r\nHost: a\r\n\r\n");
  watching.receive_until("id: 3\n\n");
  held.send("GET /hold HTTP/1.1\r\nHost: a\r\n\r\n");
  handler_.wait_until_held();
  std::thread stopping([&] { server_.stop(); });
  EXPECT_EQ(idle.receive_all(), "");
  EXPECT_TRUE(watching.receive_all().ends_with("\r\n0\r\n\r\n"));
  handler_.release();
  EXPECT_EQ(status_of(held.receive_all()), 200);
  stopping.join();
  EXPECT_EQ(server_.connections(), 0U);
  EXPECT_THROW(RawClient{port()}, std::runtime_error);
}

TEST(Server, SaysWhichPortCannotBeHad) {
  EchoHandler handler;
  const Server first({}, handler);
  ServerOptions same;
  same.port = first.port();
  try {
    const Server second(same, handler);
    ADD_FAILURE() << "two servers on one port";
  } catch (const UsageError& error) {
    EXPECT_NE(std::string(error.what()).find(std::to_string(same.port)), std::string::npos);
  }
  ServerOptions elsewhere;
  elsewhere.address = "example";
  EXPECT_THROW(Server(elsewhere, handler), UsageError);
}

}  // namespace
}  // namespace regarment
