#include "http/connections.h"

#include <unistd.h>

#include <atomic>
#include <boost/asio/executor_work_guard.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/asio/strand.hpp>
#include <boost/asio/thread_pool.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <condition_variable>
#include <mutex>
#include <set>
#include <thread>
#include <vector>

#include "base/stopwatch.h"
#include "http/slots.h"
#include "http/wire.h"

namespace regarment {
namespace {

namespace net = boost::asio;
namespace beast = boost::beast;
namespace http = beast::http;
using net::ip::tcp;
using ErrorCode = boost::system::error_code;
using Clock = std::chrono::steady_clock;

constexpr std::size_t kBlock = 65536;
constexpr std::size_t kMostDiscarded = std::size_t{64} << 20U;  // of a body nobody wants
constexpr std::chrono::seconds kLinger{2};

class Session;

// What sessions share. What runs them is last, so that they all end before the rest.
struct Shared {
  const ServerOptions options;
  Handler& handler;
  Slots streams;
  RequestIds ids;
  std::atomic<bool> stopping{false};

  std::mutex mutex;
  std::condition_variable fewer;
  std::set<Session*> sessions;  // open ones

  net::io_context context;
  net::thread_pool pool;

  Shared(const ServerOptions& options_, Handler& handler_)
      : options(options_),
        handler(handler_),
        streams(options_.event_streams),
        pool(static_cast<std::size_t>(options_.handler_threads)) {}
};

// Whether the client sent something wrong; else it went away.
bool is_bad_http(const ErrorCode& error) {
  return error.category() == http::make_error_code(http::error::bad_method).category() &&
         error != http::error::end_of_stream && error != http::error::partial_message;
}

HttpProblem problem_of_header(const ErrorCode& error, bool in_target) {
  if (error == http::error::header_limit || error == http::error::buffer_overflow)
    return too_long_header(in_target);
  return bad_http(error == http::error::bad_version ? 505 : 400, error.message());
}

// One connection: a header, the handler, a body, an answer; and again. All of its functions run on
// its strand, but for what is posted to the pool, while the strand waits.
class Session : public std::enable_shared_from_this<Session> {
 public:
  Session(tcp::socket socket, Shared& shared)
      : stream_(std::move(socket)),
        timer_(stream_.get_executor()),
        shared_(shared),
        buffer_(shared.options.header_bytes + 2 * kBlock) {
    const std::lock_guard lock(shared_.mutex);
    shared_.sessions.insert(this);
  }
  ~Session() {
    tell();
    const std::lock_guard lock(shared_.mutex);
    shared_.sessions.erase(this);
    shared_.fewer.notify_all();
  }

  void start() {
    ErrorCode ignored;
    stream_.socket().set_option(tcp::no_delay(true), ignored);
    later([](Session& s) { s.read_header(); });
  }

  // Told when the server stops: a connection without a request ends; with `now`, any.
  void end(bool now) {
    later([now](Session& s) {
      if (!now && !s.waits_for_header_) return;
      ErrorCode ignored;
      s.timer_.cancel();
      s.stream_.socket().close(ignored);
    });
  }

 private:
  template <class Do>
  void later(Do todo) {
    net::post(stream_.get_executor(), [self = shared_from_this(), todo] { todo(*self); });
  }

  // Runs `work` where it may wait; `then` follows on the strand, or the answer to what it throws.
  template <class Work, class Then>
  void in_pool(Work work, Then then) {
    stream_.expires_never();
    net::post(shared_.pool, [self = shared_from_this(), work, then] {
      try {
        work(*self);
        self->later(then);
      } catch (...) {
        self->answer_ =
            response_to_current_exception(self->request_.id, self->served_.internal_error);
        self->later([](Session& s) { s.respond(); });
      }
    });
  }

  void read_header() {
    parser_.emplace();
    parser_->header_limit(static_cast<std::uint32_t>(shared_.options.header_bytes));
    // Not boost::none, which Beast 1.74 takes for less than any length.
    parser_->body_limit(std::numeric_limits<std::uint64_t>::max());
    request_ = {};
    readable_ = false;
    waits_for_header_ = true;
    if (shared_.stopping) return;
    // The first byte may be awaited as long as a connection may idle.
    stream_.expires_after(served_.status != 0 && buffer_.size() == 0 ? shared_.options.idle_time
                                                                     : shared_.options.header_time);
    http::async_read_header(
        stream_, buffer_, *parser_,
        [self = shared_from_this()](ErrorCode error, std::size_t) { self->on_header(error); });
  }

  void on_header(const ErrorCode& error) {
    waits_for_header_ = false;
    if (error && !is_bad_http(error)) return;
    begun_ = true;
    served_ = {};
    watch_ = {};
    request_.id = shared_.ids.next();
    try {
      if (error) throw problem_of_header(error, parser_->get().target().empty());
      read_request();
      readable_ = true;
      std::optional<Response> quick = shared_.handler.at_once(request_);
      if (quick) return answer_ = std::move(*quick), respond();
    } catch (...) {
      answer_ = response_to_current_exception(request_.id, served_.internal_error);
      return respond();
    }
    in_pool([](Session& s) { s.exchange_ = s.shared_.handler.begin(s.request_); },
            [](Session& s) { s.begin_body(); });
  }

  void read_request() {
    const auto& message = parser_->get();
    request_.method = std::string(message.method_string());
    for (const auto& field : message)
      request_.headers.add(std::string(field.name_string()), std::string(field.value()));
    read_target({message.target().data(), message.target().size()}, request_);
    check_header(request_, message.version() > 10, parser_->chunked());
  }

  void begin_body() {
    const std::uint64_t limit = exchange_->body_limit();
    parser_->body_limit(limit);
    if (parser_->content_length().value_or(0) > limit) return refuse(too_long_body(limit));
    if (parser_->is_done()) return finish();
    body_end_ = Clock::now() + shared_.options.body_time;
    block_.resize(kBlock);
    buffer_.reserve(kBlock);
    if (!request_.headers.find("Expect") || parser_->get().version() < 11) return read_body();
    static constexpr std::string_view kContinue = "HTTP/1.1 100 Continue\r\n\r\n";
    write(net::buffer(kContinue.data(), kContinue.size()), [](Session& s) { s.read_body(); });
  }

  void refuse(const HttpProblem& problem) {
    answer_ = problem_response(problem, request_.id);
    respond();
  }

  void read_body() {
    if (parser_->is_done()) return finish();
    if (Clock::now() > body_end_) return;
    parser_->get().body().data = block_.data();
    parser_->get().body().size = block_.size();
    parser_->get().body().more = true;
    stream_.expires_after(shared_.options.idle_time);
    http::async_read_some(
        stream_, buffer_, *parser_,
        [self = shared_from_this()](ErrorCode error, std::size_t) { self->on_body(error); });
  }

  void on_body(const ErrorCode& error) {
    if (error == http::error::body_limit) return refuse(too_long_body(exchange_->body_limit()));
    if (error && error != http::error::need_buffer)
      return is_bad_http(error) ? refuse(bad_http(400, error.message())) : void();
    got_ = block_.size() - parser_->get().body().size;
    served_.bytes_in += got_;
    if (got_ == 0) return read_body();
    in_pool([](Session& s) { s.exchange_->take(std::string_view(s.block_.data(), s.got_)); },
            [](Session& s) { s.read_body(); });
  }

  void finish() {
    in_pool([](Session& s) { s.answer_ = s.exchange_->finish(); }, [](Session& s) { s.respond(); });
  }

  void respond() {
    exchange_.reset();
    const bool head_only = request_.method == "HEAD";
    const bool newer = parser_->get().version() >= 11;
    if (answer_.events) slot_ = shared_.streams.take();
    if (answer_.events && !slot_) answer_ = problem_response(too_many_streams(), request_.id);
    const bool chunked = answer_.events && newer;
    keep_ = parser_->is_done() && parser_->keep_alive() && !shared_.stopping &&
            (!answer_.events || newer);
    served_.status = answer_.status;
    head_ = wire_head(answer_, {keep_, chunked, request_.id});
    if (answer_.events && !head_only) events_.emplace(std::move(answer_.events), chunked);
    blocks_.emplace(head_only ? Response{} : std::move(answer_));
    next_block();
  }

  void next_block() {
    if (blocks_->reads_file())
      return in_pool([](Session& s) { s.sending_ = s.blocks_->next(); },
                     [](Session& s) { s.send_block(); });
    sending_ = blocks_->next();
    send_block();
  }

  void send_block() {
    if (!sending_) return;  // the file broke off: so does the connection
    if (head_.empty() && sending_->empty()) return events_ ? next_events() : end_answer();
    write(std::array<net::const_buffer, 2>{net::buffer(head_), net::buffer(*sending_)},
          [](Session& s) {
            s.head_.clear();
            s.next_block();
          });
  }

  template <class Buffers, class Then>
  void write(const Buffers& buffers, Then then) {
    stream_.expires_after(shared_.options.idle_time);
    net::async_write(stream_, buffers,
                     [self = shared_from_this(), then](ErrorCode error, std::size_t count) {
                       self->served_.bytes_out += count;
                       if (!error) then(*self);
                     });
  }

  void next_events() {
    in_pool([](Session& s) { s.part_ = s.events_->next(s.shared_.stopping); },
            [](Session& s) { s.send_events(); });
  }

  void send_events() {
    if (part_.bytes.empty()) return part_.ended ? void() : wait_for_events();
    write(net::buffer(part_.bytes),
          [](Session& s) { s.part_.ended ? s.end_answer() : s.wait_for_events(); });
  }

  void wait_for_events() {
    timer_.expires_after(shared_.options.event_poll);
    timer_.async_wait([self = shared_from_this()](ErrorCode) { self->next_events(); });
  }

  void end_answer() {
    tell();
    slot_.reset();
    events_.reset();
    blocks_.reset();
    buffer_.shrink_to_fit();
    if (keep_) return read_header();
    ErrorCode ignored;
    stream_.socket().shutdown(tcp::socket::shutdown_send, ignored);
    // Closing over unread bytes would reset the connection, and the client might miss the answer.
    if (parser_->is_done()) return;
    block_.resize(kBlock);
    stream_.expires_after(kLinger);
    discard(kMostDiscarded);
  }

  void discard(std::size_t most) {
    stream_.async_read_some(net::buffer(block_),
                            [self = shared_from_this(), most](ErrorCode error, std::size_t count) {
                              if (!error && count < most) self->discard(most - count);
                            });
  }

  // Once for each request whose header came.
  void tell() {
    if (!std::exchange(begun_, false)) return;
    served_.seconds = watch_.total();
    shared_.handler.served(readable_ ? &request_ : nullptr, served_);
  }

  beast::tcp_stream stream_;
  net::steady_timer timer_;
  Shared& shared_;
  beast::flat_buffer buffer_;  // bounded: the size of a chunk may come without end
  std::optional<http::request_parser<http::buffer_body>> parser_;

  // Of the request at hand.
  Request request_;
  Served served_;
  Stopwatch watch_;
  bool begun_ = false, readable_ = false;
  std::unique_ptr<Exchange> exchange_;
  std::vector<char> block_;  // of the body; empty when none arrives
  std::size_t got_ = 0;      // bytes in it
  Clock::time_point body_end_;

  // Of its answer.
  Response answer_;
  bool keep_ = false;  // the connection, for another request
  std::string head_;   // not yet sent
  std::optional<BodyBlocks> blocks_;
  std::optional<std::string_view> sending_;
  std::shared_ptr<void> slot_;
  std::optional<EventBytes> events_;
  EventBytes::Part part_;

  bool waits_for_header_ = false;  // nothing is lost when the connection ends now
};

}  // namespace

struct Connections::Inside {
  Shared shared;
  net::executor_work_guard<net::io_context::executor_type> guard{shared.context.get_executor()};
  std::vector<std::thread> threads;

  Inside(const ServerOptions& options, Handler& handler) : shared(options, handler) {
    for (int i = 0; i < options.network_threads; ++i)
      threads.emplace_back([this] { shared.context.run(); });
  }

  // Tells all connections to end, and waits until they have or the time is over.
  bool all_end(bool now, std::chrono::seconds most) {
    std::vector<std::shared_ptr<Session>> open;
    std::unique_lock lock(shared.mutex);
    for (Session* session : shared.sessions) open.push_back(session->weak_from_this().lock());
    lock.unlock();  // a session that ends takes it
    for (const auto& session : open)
      if (session) session->end(now);
    open.clear();
    lock.lock();
    return shared.fewer.wait_for(lock, most, [&] { return shared.sessions.empty(); });
  }
};

Connections::Connections(const ServerOptions& options, Handler& handler)
    : inside_(std::make_unique<Inside>(options, handler)) {}

Connections::~Connections() { stop(); }

void Connections::take(int descriptor, bool ipv6) {
  tcp::socket socket(net::make_strand(inside_->shared.context));
  ErrorCode error;
  socket.assign(ipv6 ? tcp::v6() : tcp::v4(), descriptor, error);
  if (error) ::close(descriptor);
  if (error || count() >= inside_->shared.options.connections) return;
  std::make_shared<Session>(std::move(socket), inside_->shared)->start();
}

std::size_t Connections::count() const {
  const std::lock_guard lock(inside_->shared.mutex);
  return inside_->shared.sessions.size();
}

void Connections::stop() {
  if (inside_->shared.stopping.exchange(true)) return;
  constexpr std::chrono::seconds kMoment{1};
  if (!inside_->all_end(false, inside_->shared.options.drain_time)) inside_->all_end(true, kMoment);
  inside_->guard.reset();
  inside_->shared.context.stop();
  for (std::thread& thread : inside_->threads) thread.join();
  inside_->shared.pool.stop();
  inside_->shared.pool.join();
}

}  // namespace regarment
