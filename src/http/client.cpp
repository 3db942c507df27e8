#include "http/client.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <boost/asio/buffer.hpp>
#include <boost/beast/http/buffer_body.hpp>
#include <boost/beast/http/parser.hpp>
#include <cerrno>
#include <cstring>

#include "base/away_error.h"

namespace regarment {
namespace {

namespace net = boost::asio;
namespace http = boost::beast::http;
using ErrorCode = boost::system::error_code;
using Parser = http::response_parser<http::buffer_body>;

constexpr std::size_t kBlock = std::size_t{64} << 10U;
constexpr std::size_t kMostProblem = std::size_t{64} << 10U;  // bytes of an answer that is not good
constexpr int kMostInterim = 8;                               // answers 1xx before the final one
constexpr std::chrono::milliseconds kContinueTime{1000};
constexpr int kContinue = 100, kLastInterim = 199;

bool fits_a_header(std::string_view text) {
  return std::all_of(text.begin(), text.end(), [](char c) { return c > ' ' && c < 0x7f; });
}

/// A file on its way to a server.
class OpenFile {
 public:
  explicit OpenFile(const std::filesystem::path& path) : path_(path.string()) {
    descriptor_ = ::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_NOFOLLOW | O_CLOEXEC);
    struct stat facts {};
    if (descriptor_ < 0) fail(std::strerror(errno));
    if (::fstat(descriptor_, &facts) != 0 || !S_ISREG(facts.st_mode)) {
      ::close(descriptor_);
      fail("is no regular file");
    }
    size_ = static_cast<std::uint64_t>(facts.st_size);
  }
  ~OpenFile() { ::close(descriptor_); }
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;

  std::uint64_t size() const { return size_; }
  std::string_view read(std::uint64_t most) {
    block_.resize(static_cast<std::size_t>(std::min<std::uint64_t>(kBlock, most)));
    const ssize_t got = ::read(descriptor_, block_.data(), block_.size());
    if (got <= 0) fail("became shorter while it was sent");
    return {block_.data(), static_cast<std::size_t>(got)};
  }

 private:
  [[noreturn]] void fail(const char* why) const { throw ReadError(path_ + ": " + why); }

  std::string path_;
  int descriptor_ = -1;
  std::uint64_t size_ = 0;
  std::string block_;
};

}  // namespace

/// One request on a link, and its answer.
class HttpClient::Conversation {
 public:
  Conversation(const HttpClient& client, Link& link, const KeepGoing& go)
      : client_(client), options_(client.options_), link_(link), go_(go) {}

  ClientAnswer run(const ClientRequest& request, AnswerBody* body, std::size_t most) {
    send(request);
    read_header();
    ClientAnswer answer = head();
    if (!answer.is_good()) body = nullptr, most = std::max(most, kMostProblem);
    if (body != nullptr) body->begin(answer);
    read_body([&](std::string_view bytes) {
      if (body != nullptr) return body->take(bytes);
      if (answer.body.size() + bytes.size() > most) fail("answers more than was asked for");
      answer.body.append(bytes);
    });
    // Nobody asked for what came after the answer.
    keeps_ = parser_->keep_alive() && !parser_->need_eof() && arrived_.empty() && all_sent_;
    return answer;
  }

  bool keeps_link() const { return keeps_; }
  /// Whether nothing of an answer came: the link may have been closed before the request.
  bool is_silent() const { return silent_; }

 private:
  [[noreturn]] void fail(const std::string& why) const {
    throw AwayError(client_.address_.text() + ": " + why);
  }

  void send(const ClientRequest& request) {
    std::optional<OpenFile> file;
    if (request.file) file.emplace(*request.file);
    const std::uint64_t size = file ? file->size() : request.body.size();
    const bool asks = file && size > 0;
    std::string head = head_of(request, size, asks);
    if (!file) head += request.body;
    link_.write(head, options_.idle_time, go_);
    if (!asks) return;
    all_sent_ = false;
    if (link_.arrives(kContinueTime, go_)) {
      read_header(true);
      if (parser_->is_header_done()) return;  // refused
    }
    for (std::uint64_t left = size; left > 0;) {
      const std::string_view block = file->read(left);
      link_.write(block, options_.idle_time, go_);
      left -= block.size();
    }
    all_sent_ = true;
  }

  std::string head_of(const ClientRequest& request, std::uint64_t size, bool asks) const {
    std::string out = request.method + " " + request.target + " HTTP/1.1\r\n";
    const auto add = [&](std::string_view name, std::string_view value) {
      out.append(name).append(": ").append(value).append("\r\n");
    };
    add("Host", client_.address_.authority());
    if (!options_.key.empty()) add("Authorization", "Bearer " + options_.key);
    for (const auto& [name, value] : request.headers.all()) add(name, value);
    if (request.method != "GET" || size > 0) add("Content-Length", std::to_string(size));
    if (asks) add("Expect", "100-continue");
    return out + "\r\n";
  }

  void begin_answer() {
    parser_.emplace();
    parser_->header_limit(static_cast<std::uint32_t>(options_.header_bytes));
    // Not boost::none, which Beast 1.74 takes for less than any length.
    parser_->body_limit(std::numeric_limits<std::uint64_t>::max());
  }

  // One header, whatever it says.
  void read_one_header() {
    begin_answer();
    const auto end = std::chrono::steady_clock::now() + options_.answer_time;
    while (!parser_->is_header_done()) {
      if (std::chrono::steady_clock::now() > end) fail("does not come to an answer");
      parse_or_receive(options_.answer_time);
    }
  }

  // Up to the final header, or, `or_continue`, to the one that asks for the file.
  void read_header(bool or_continue = false) {
    if (parser_ && parser_->is_header_done()) return;
    for (int i = 0; i < kMostInterim; ++i) {
      read_one_header();
      if (or_continue && status() == kContinue) return begin_answer();
      if (status() > kLastInterim) return;
    }
    fail("does not come to an answer");
  }

  int status() const { return static_cast<int>(parser_->get().result_int()); }

  ClientAnswer head() const {
    ClientAnswer out;
    out.status = status();
    for (const auto& field : parser_->get())
      out.headers.add(std::string(field.name_string()), std::string(field.value()));
    return out;
  }

  template <class Take>
  void read_body(const Take& take) {
    std::string block(kBlock, '\0');
    while (!parser_->is_done()) {
      auto& body = parser_->get().body();
      body.data = block.data(), body.size = block.size(), body.more = true;
      parse_or_receive(options_.idle_time);
      const std::size_t got = block.size() - parser_->get().body().size;
      if (got > 0) take(std::string_view(block).substr(0, got));
    }
  }

  // Lets the parser have what is there, or more when that is not enough.
  void parse_or_receive(std::chrono::milliseconds most) {
    ErrorCode error;
    if (!arrived_.empty()) {
      const std::size_t used = parser_->put(net::buffer(arrived_), error);
      arrived_.erase(0, used);
      if (error == http::error::need_buffer) error = {};
      if (error && error != http::error::need_more)
        fail("sends what is no answer (" + error.message() + ")");
      if (used > 0 || (!error && parser_->is_done())) return;
    }
    receive(most);
  }

  void receive(std::chrono::milliseconds most) {
    // What the parser wants whole (a header, the size of a chunk) may not come without end.
    if (arrived_.size() > options_.header_bytes + kBlock) fail("sends what is no answer");
    const std::size_t had = arrived_.size();
    arrived_.resize(had + kBlock);
    const std::size_t got = link_.read(arrived_.data() + had, kBlock, most, go_);
    arrived_.resize(had + got);
    if (got > 0) {
      silent_ = false;
      return;
    }
    ErrorCode error;
    if (parser_->got_some()) parser_->put_eof(error);
    if (error || !parser_->is_done()) fail("broke off in the middle of an answer");
  }

  const HttpClient& client_;
  const ClientOptions& options_;
  Link& link_;
  const KeepGoing& go_;
  std::optional<Parser> parser_;
  std::string arrived_;  // and not yet parsed
  bool all_sent_ = true, silent_ = true, keeps_ = false;
};

HttpClient::HttpClient(HttpAddress address, ClientOptions options)
    : address_(std::move(address)), options_(std::move(options)) {
  if (!fits_a_header(options_.key))
    throw UsageError("server_key: holds what no key holds; give one that 'regarment key add' made");
}

HttpClient::~HttpClient() = default;

ClientAnswer HttpClient::ask(const ClientRequest& request, std::size_t most, const KeepGoing& go) {
  return ask(request, nullptr, most, go);
}

ClientAnswer HttpClient::ask(const ClientRequest& request, AnswerBody& body, const KeepGoing& go) {
  return ask(request, &body, 0, go);
}

ClientAnswer HttpClient::ask(const ClientRequest& request, AnswerBody* body, std::size_t most,
                             const KeepGoing& go) {
  // What arrives on a link that rests is its end.
  std::unique_ptr<Link> link = std::move(link_);
  const bool kept = link && !link->arrives(std::chrono::milliseconds(0), go);
  if (!kept) link = std::make_unique<Link>(address_, options_.connect_time, go);
  Conversation first(*this, *link, go);
  try {
    ClientAnswer answer = first.run(request, body, most);
    if (first.keeps_link()) link_ = std::move(link);
    return answer;
  } catch (const AwayError&) {
    // The server may have closed it just before; every request of ours may be sent twice.
    if (!kept || !first.is_silent()) throw;
  }
  link = std::make_unique<Link>(address_, options_.connect_time, go);
  Conversation again(*this, *link, go);
  ClientAnswer answer = again.run(request, body, most);
  if (again.keeps_link()) link_ = std::move(link);
  return answer;
}

std::string url_encoded(std::string_view text) {
  constexpr std::string_view kDigits = "0123456789ABCDEF";
  std::string out;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    const bool plain = (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') ||
                       std::string_view("-._~").find(c) != std::string_view::npos;
    if (plain)
      out += c;
    else
      (out += '%').append({kDigits[byte >> 4U], kDigits[byte & 15U]});
  }
  return out;
}

}  // namespace regarment
