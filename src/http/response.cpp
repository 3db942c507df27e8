#include "http/response.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <nlohmann/json.hpp>

#include "base/sha256.h"
#include "http/conditional.h"

namespace regarment {
namespace {

namespace fs = std::filesystem;

FileBody owned(int descriptor) {
  FileBody out;
  out.descriptor = descriptor;
  out.keeps = std::shared_ptr<void>(nullptr, [descriptor](void*) { ::close(descriptor); });
  return out;
}

// Opens root/file step by step, so that no link on the way leads out of the folder.
std::optional<FileBody> open_below(const fs::path& root, const fs::path& file) {
  int here = ::open(root.c_str(), O_PATH | O_DIRECTORY | O_CLOEXEC);
  if (here < 0) return std::nullopt;
  FileBody folder = owned(here);
  for (auto step = file.begin(); step != file.end(); ++step) {
    const bool last = std::next(step) == file.end();
    if (step->empty() || *step == ".." || *step == "." || step->is_absolute()) return std::nullopt;
    const int flags = last ? O_RDONLY | O_NONBLOCK : O_PATH | O_DIRECTORY;
    here = ::openat(folder.descriptor, step->c_str(), flags | O_NOFOLLOW | O_CLOEXEC);
    if (here < 0) return std::nullopt;
    folder = owned(here);
  }
  return folder;
}

std::string etag_of(const struct stat& facts) {
  constexpr std::int64_t kNanoseconds = 1'000'000'000;
  const std::int64_t time = facts.st_mtim.tv_sec * kNanoseconds + facts.st_mtim.tv_nsec;
  return '"' + std::to_string(facts.st_size) + '-' + std::to_string(time) + '-' +
         std::to_string(facts.st_ino) + '"';
}

}  // namespace

Response text_response(int status, std::string content_type, std::string body) {
  Response out;
  out.status = status;
  out.content_type = std::move(content_type);
  out.body = std::move(body);
  return out;
}

Response problem_response(const HttpProblem& problem, const std::string& request_id) {
  const nlohmann::ordered_json json = {{"type", "urn:regarment:problem:" + problem.code},
                                       {"title", status_phrase(problem.status)},
                                       {"status", problem.status},
                                       {"detail", problem.what()},
                                       {"code", problem.code},
                                       {"request_id", request_id}};
  Response out = text_response(
      problem.status, "application/problem+json",
      json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n");
  out.headers = problem.headers;
  return out;
}

std::optional<Response> file_response(const Request& request, const fs::path& root,
                                      const fs::path& file, std::string content_type) {
  std::optional<FileBody> body = open_below(root, file);
  struct stat facts {};
  if (!body || ::fstat(body->descriptor, &facts) != 0 || !S_ISREG(facts.st_mode))
    return std::nullopt;
  const auto size = static_cast<std::uint64_t>(facts.st_size);
  const std::string etag = etag_of(facts);
  Response out;
  out.content_type = std::move(content_type);
  out.headers = {{"ETag", etag}, {"Accept-Ranges", "bytes"}};
  if (has_etag(request, etag)) {
    out.status = 304;
    return out;
  }
  const auto asked = asked_range(request, size, etag);
  if (std::holds_alternative<NoSuchRange>(asked))
    throw HttpProblem(416, "no_such_range",
                      "the file has " + std::to_string(size) + " bytes; ask for a range of these",
                      {{"Content-Range", "bytes */" + std::to_string(size)}});
  body->end = size;
  if (const auto* range = std::get_if<ByteRange>(&asked)) {
    out.status = 206;
    std::tie(body->begin, body->end) = *range;
    out.headers.add("Content-Range", "bytes " + std::to_string(body->begin) + "-" +
                                         std::to_string(body->end - 1) + "/" +
                                         std::to_string(size));
  }
  out.file = std::move(body);
  return out;
}

Response with_etag(const Request& request, Response response) {
  const std::string etag = '"' + sha256_hex(std::as_bytes(std::span(response.body))) + '"';
  response.headers.add("ETag", etag);
  if (response.status == 200 && has_etag(request, etag)) {
    response.status = 304;
    response.body.clear();
  }
  return response;
}

}  // namespace regarment
