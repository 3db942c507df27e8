#include "http/wire.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <ctime>
#include <new>

#include "base/away_error.h"

namespace regarment {
namespace {

constexpr std::chrono::seconds kHeartbeat{15};
constexpr std::size_t kBlock = std::size_t{64} << 10U;

// In every answer; CSP and Cache-Control only where the answer does not say otherwise.
constexpr std::array<std::pair<std::string_view, std::string_view>, 5> kSecurity{
    {{"X-Content-Type-Options", "nosniff"},
     {"Referrer-Policy", "no-referrer"},
     {"X-Frame-Options", "SAMEORIGIN"},
     {"Cross-Origin-Opener-Policy", "same-origin"},
     {"Cross-Origin-Resource-Policy", "same-origin"}}};
constexpr std::array<std::pair<std::string_view, std::string_view>, 2> kUnlessSaid{
    {{"Content-Security-Policy", "default-src 'none'; frame-ancestors 'none'; sandbox"},
     {"Cache-Control", "no-store"}}};

std::string date_now() {
  const std::time_t now = std::time(nullptr);
  std::tm utc{};
  ::gmtime_r(&now, &utc);
  std::array<char, 40> text{};
  // The names are English whatever the locale: the program never sets one.
  std::strftime(text.data(), text.size(), "%a, %d %b %Y %H:%M:%S GMT", &utc);
  return text.data();
}

void add_field(std::string& out, std::string_view name, std::string_view value) {
  out.append(name).append(": ");
  for (const char c : value)
    if (static_cast<unsigned char>(c) >= 0x20 && c != 0x7f) out += c;
  out += "\r\n";
}

std::uint64_t length_of(const Response& response) {
  return response.file ? response.file->end - response.file->begin : response.body.size();
}

}  // namespace

std::string wire_head(const Response& response, const WireHead& how) {
  std::string out = "HTTP/1.1 " + std::to_string(response.status) + " ";
  out.append(status_phrase(response.status)).append("\r\n");
  add_field(out, "Date", date_now());
  add_field(out, "X-Request-Id", how.request_id);
  if (!response.content_type.empty()) add_field(out, "Content-Type", response.content_type);
  if (how.chunked) {
    add_field(out, "Transfer-Encoding", "chunked");
  } else if (!response.events && response.status != 304 && response.status != 204) {
    add_field(out, "Content-Length", std::to_string(length_of(response)));
  }
  for (const auto& [name, value] : kSecurity) add_field(out, name, value);
  for (const auto& [name, value] : kUnlessSaid)
    if (!response.headers.find(name)) add_field(out, name, value);
  for (const auto& [name, value] : response.headers.all()) add_field(out, name, value);
  add_field(out, "Connection", how.keep_alive ? "keep-alive" : "close");
  return out + "\r\n";
}

std::string wire_chunk(std::string_view bytes) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::string size;
  for (std::size_t rest = bytes.size(); rest > 0 || size.empty(); rest /= kDigits.size())
    size.insert(size.begin(), kDigits[rest % kDigits.size()]);
  return size.append("\r\n").append(bytes).append("\r\n");
}

Response response_to_current_exception(const std::string& request_id, std::string& internal_error) {
  const auto answer = [&](int status, const char* code, const std::string& detail) {
    return problem_response(HttpProblem(status, code, detail), request_id);
  };
  try {
    throw;
  } catch (const HttpProblem& problem) {
    return problem_response(problem, request_id);
  } catch (const AwayError& error) {
    internal_error = error.what();  // says more of the house than those outside need to know
    return answer(503, "away", "something the service needs is away; try again in a moment");
  } catch (const TemporaryError& error) {
    return answer(507, "no_space", error.what());
  } catch (const UsageError& error) {
    return answer(422, "bad_request", error.what());
  } catch (const ReadError& error) {
    return answer(422, "unreadable", error.what());
  } catch (const std::bad_alloc&) {
    return answer(503, "out_of_memory", "the service is short of memory; try again later");
  } catch (const std::exception& error) {
    internal_error = error.what();
    return answer(500, "internal", "the service failed; its log has this request's id");
  }
}

BodyBlocks::BodyBlocks(Response response) : response_(std::move(response)) {}

std::optional<std::string_view> BodyBlocks::next() {
  if (!response_.file) return std::exchange(done_, true) ? "" : std::string_view(response_.body);
  FileBody& file = *response_.file;
  block_.resize(static_cast<std::size_t>(std::min<std::uint64_t>(kBlock, file.end - file.begin)));
  if (block_.empty()) return "";
  const ssize_t got =
      ::pread(file.descriptor, block_.data(), block_.size(), static_cast<off_t>(file.begin));
  if (got <= 0) return std::nullopt;
  block_.resize(static_cast<std::size_t>(got));
  file.begin += block_.size();
  return block_;
}

EventBytes::EventBytes(std::unique_ptr<EventStream> events, bool chunked)
    : events_(std::move(events)), chunked_(chunked) {}

EventBytes::Part EventBytes::next(bool stop) try {
  EventStream::Part part = events_->next();
  const bool ended = part.ended || stop;
  if (part.bytes.empty() && !ended && Clock::now() - last_ > kHeartbeat) part.bytes = ":\n\n";
  if (!part.bytes.empty()) last_ = Clock::now();
  if (!chunked_) return {std::move(part.bytes), ended};
  std::string bytes = part.bytes.empty() ? "" : wire_chunk(part.bytes);
  if (ended) bytes += wire_chunk({});
  return {std::move(bytes), ended};
} catch (const std::exception&) {
  return {{}, true};
}

}  // namespace regarment
