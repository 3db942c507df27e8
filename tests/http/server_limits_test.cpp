// What a hostile client meets.
#include <gtest/gtest.h>

#include "echo_handler.h"
#include "http/server.h"
#include "raw_client.h"

namespace regarment {
namespace {

ServerOptions tight() {
  ServerOptions options;
  options.header_time = std::chrono::seconds(1);
  options.idle_time = std::chrono::seconds(1);
  options.connections = 3;
  options.event_streams = 1;
  options.event_poll = std::chrono::milliseconds(10);
  return options;
}

class LimitsTest : public testing::Test {
 protected:
  std::string tell(const std::string& request) { return ask(server_.port(), request); }

  EchoHandler handler_;
  Server server_{ServerOptions(), handler_};
};

TEST_F(LimitsTest, LongHeadersAreRefused) {
  const std::string target = tell("GET /" + std::string(100'000, 'a'));
  EXPECT_EQ(status_of(target), 414);
  const std::string line = tell("GET / HTTP/1.1\r\nHost: a\r\nX: " + std::string(100'000, 'a'));
  EXPECT_EQ(status_of(line), 431);
  std::string many = "GET / HTTP/1.1\r\nHost: a\r\n";
  for (int i = 0; i < 10'000; ++i) many += "X-" + std::to_string(i) + ": a\r\n";
  EXPECT_EQ(status_of(tell(many)), 431);
}

TEST_F(LimitsTest, WhatIsNoHttpIsRefused) {
  const std::string post = "POST /echo HTTP/1.1\r\nHost: a\r\n";
  for (const std::string& request :
       {std::string("nonsense\r\n\r\n"), std::string("GET  / HTTP/1.1\r\n\r\n"),
        std::string("GET / HTTP/1.1\r\n\r\n"),
        std::string("GET / HTTP/1.1\r\nHost: a\r\nHost: b\r\n\r\n"),
        std::string("GET http://a/ HTTP/1.1\r\nHost: a\r\n\r\n"),
        post + "Content-Length: -1\r\n\r\n", post + "Content-Length: 1x\r\n\r\n",
        post + "Content-Length: 1\r\nContent-Length: 2\r\n\r\nab",
        post + "Content-Length: 3\r\nTransfer-Encoding: chunked\r\n\r\n0\r\n\r\n",
        post + "Transfer-Encoding: gzip\r\n\r\n",
        post + "Transfer-Encoding: chunked\r\n\r\n-2\r\nab\r\n0\r\n\r\n",
        post + "Transfer-Encoding: chunked\r\n\r\nzz\r\nab\r\n0\r\n\r\n",
        post + "Transfer-Encoding: chunked\r\n\r\nfffffffffffffffff\r\nab\r\n0\r\n\r\n",
        post + "Transfer-Encoding: chunked\r\n\r\n1\r\nabc\r\n0\r\n\r\n"})
    EXPECT_EQ(status_of(tell(request)), 400) << request;
  EXPECT_EQ(status_of(tell("GET / HTTP/3.0\r\nHost: a\r\n\r\n")), 505);
  EXPECT_EQ(status_of(tell(post + "Expect: a miracle\r\n\r\n")), 417);
}

TEST_F(LimitsTest, LongBodiesAreRefusedAsSoonAsTheyShow) {
  const std::string post = "POST /count HTTP/1.1\r\nHost: a\r\nConnection: close\r\n";
  const std::string most = std::to_string(EchoHandler::kLimit);
  EXPECT_EQ(body_of(tell(post + "Content-Length: " + most + "\r\n\r\n" +
                         std::string(EchoHandler::kLimit, 'x'))),
            most);
  EXPECT_EQ(status_of(tell(post + "Content-Length: 1000001\r\n\r\n")), 413);
  std::string chunks;
  for (int i = 0; i < 17; ++i) chunks += "10000\r\n" + std::string(0x10000, 'x') + "\r\n";
  EXPECT_EQ(status_of(tell(post + "Transfer-Encoding: chunked\r\n\r\n" + chunks)), 413);
}

TEST_F(LimitsTest, AChunkSizeWithoutEndIsRefused) {
  const std::string post = "POST /echo HTTP/1.1\r\nHost: a\r\nTransfer-Encoding: chunked\r\n\r\n";
  EXPECT_EQ(status_of(tell(post + std::string(1'000'000, '0'))), 400);
  EXPECT_EQ(status_of(tell(post + "1;" + std::string(1'000'000, 'a'))), 400);
}

TEST(TightServer, ClosesConnectionsThatTakeTheirTime) {
  EchoHandler handler;
  const Server server(tight(), handler);
  RawClient header(server.port()), body(server.port());
  header.send("GET / HT");
  body.send("POST /echo HTTP/1.1\r\nHost: a\r\nContent-Length: 10\r\n\r\nhalf");
  EXPECT_EQ(header.receive_all(), "");
  EXPECT_EQ(body.receive_all(), "");
}

TEST(TightServer, HasOnlySoManyConnectionsAndStreams) {
  EchoHandler handler;
  const Server server(tight(), handler);
  RawClient stream(server.port()), second(server.port());
  stream.send("GET /endless HTTP/1.1\r\nHost: a\r\n\r\n");
  stream.receive_until("id: 1\n\n");
  second.send("GET /endless HTTP/1.1\r\nHost: a\r\n\r\n");
  EXPECT_EQ(status_of(second.receive_answer()), 503);
  RawClient third(server.port());
  third.send("GET /quick HTTP/1.1\r\nHost: a\r\n\r\n");
  EXPECT_EQ(status_of(third.receive_answer()), 200);
  EXPECT_EQ(ask(server.port(), "GET /quick HTTP/1.1\r\nHost: a\r\n\r\n"), "");
}

}  // namespace
}  // namespace regarment
