#include "http/response.h"

#include <gtest/gtest.h>

#include <fstream>

#include "http/wire.h"
#include "support/folders.h"

namespace regarment {
namespace {

namespace fs = std::filesystem;

std::string bytes_of(std::optional<Response> response) {
  if (!response) return "nothing";
  BodyBlocks blocks(std::move(*response));
  std::string out;
  for (auto block = blocks.next(); block && !block->empty(); block = blocks.next()) out += *block;
  return out;
}

void write(const fs::path& file, const std::string& bytes) { std::ofstream(file) << bytes; }

TEST(FileResponse, HasTheFileOrTheRange) {
  const TemporaryFolder folder;
  const std::string bytes(200'000, 'x');
  write(folder.path() / "a", bytes + "end");
  Request request;
  request.method = "GET";
  EXPECT_EQ(bytes_of(file_response(request, folder.path(), "a", "")), bytes + "end");
  request.headers = {{"Range", "bytes=-4"}};
  auto part = file_response(request, folder.path(), "a", "text/plain");
  ASSERT_TRUE(part);
  EXPECT_EQ(part->status, 206);
  EXPECT_EQ(part->headers.get("Content-Range"), "bytes 199999-200002/200003");
  EXPECT_EQ(bytes_of(std::move(part)), "xend");
  request.headers = {{"Range", "bytes=200003-"}};
  EXPECT_THROW(file_response(request, folder.path(), "a", ""), HttpProblem);
}

TEST(FileResponse, IsNotModifiedUntilTheFileIs) {
  const TemporaryFolder folder;
  write(folder.path() / "a", "1");
  Request request;
  request.method = "GET";
  const std::string etag(file_response(request, folder.path(), "a", "")->headers.get("ETag"));
  request.headers = {{"If-None-Match", etag}};
  EXPECT_EQ(file_response(request, folder.path(), "a", "")->status, 304);
  write(folder.path() / "b", "2");
  fs::rename(folder.path() / "b", folder.path() / "a");
  EXPECT_EQ(file_response(request, folder.path(), "a", "")->status, 200);
}

TEST(FileResponse, NeverLeavesTheFolder) {
  const TemporaryFolder folder;
  fs::create_directories(folder.path() / "in/deep");
  write(folder.path() / "secret", "s");
  write(folder.path() / "in/deep/a", "a");
  fs::create_symlink(folder.path() / "secret", folder.path() / "in/link");
  fs::create_symlink(folder.path(), folder.path() / "in/up");
  const fs::path root = folder.path() / "in";
  const Request request;
  EXPECT_EQ(bytes_of(file_response(request, root, "deep/a", "")), "a");
  for (const char* name : {"../secret", "link", "up/secret", "/etc/passwd", "", ".", "deep",
                           "deep/../deep/a", "none", "deep/none", "deep/"})
    EXPECT_FALSE(file_response(request, root, name, "")) << name;
}

TEST(BodyBlocks, BreakOffWhenTheFileBecomesShorter) {
  const TemporaryFolder folder;
  write(folder.path() / "a", std::string(100'000, 'x'));
  BodyBlocks blocks(*file_response({}, folder.path(), "a", ""));
  EXPECT_TRUE(blocks.next());
  fs::resize_file(folder.path() / "a", 10);
  EXPECT_FALSE(blocks.next());
}

TEST(WithEtag, SendsTheSameBodyOnce) {
  Request request;
  const auto answer = [&] { return with_etag(request, text_response(200, "text/plain", "a")); };
  const std::string etag(answer().headers.get("ETag"));
  // SHA-256 of "a", as sha256sum prints it.
  EXPECT_EQ(etag, "\"ca978112ca1bbdcafac231b39a23dc4da786eff8147c4e72b9807785afee48bb\"");
  request.headers = {{"If-None-Match", etag}};
  EXPECT_EQ(answer().status, 304);
  EXPECT_EQ(answer().body, "");
}

TEST(WireHead, CannotBeSplitByAValue) {
  Response response = text_response(200, "text/plain", "");
  response.headers.add("X-Name", "a\r\nSet-Cookie: b\n");
  const std::string head = wire_head(response, {true, false, "id"});
  EXPECT_NE(head.find("\r\nX-Name: aSet-Cookie: b\r\n"), std::string::npos) << head;
}

TEST(WireChunk, HasItsSizeInHexadecimal) {
  EXPECT_EQ(wire_chunk(""), "0\r\n\r\n");
  EXPECT_EQ(wire_chunk("abc"), "3\r\nabc\r\n");
  EXPECT_EQ(wire_chunk(std::string(0x1f0, 'x')).substr(0, 5), "1f0\r\n");
}

}  // namespace
}  // namespace regarment
