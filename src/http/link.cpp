#include "http/link.h"

#include <netdb.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <openssl/err.h>
#include <openssl/ssl.h>
#include <openssl/x509v3.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <arpa/inet.h>
#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstring>
#include <thread>
#include <utility>

#include "base/away_error.h"
#include "base/one_line.h"

namespace regarment {
namespace {

using std::chrono::milliseconds;
using Clock = std::chrono::steady_clock;

constexpr milliseconds kLook{100};  // between two questions whether to go on

struct FreeAddresses {
  void operator()(addrinfo* list) const { ::freeaddrinfo(list); }
};
using Addresses = std::unique_ptr<addrinfo, FreeAddresses>;

struct FreeTls {
  void operator()(SSL_CTX* context) const { ::SSL_CTX_free(context); }
  void operator()(SSL* session) const { ::SSL_free(session); }
};

/// How long something may take that asks now and then whether to go on.
class Patience {
 public:
  Patience(milliseconds most, const KeepGoing& go) : end_(Clock::now() + most), go_(go) {}

  /// How long to wait before asking again; zero: the time is over. Throws Stopped.
  milliseconds next() const {
    if (!go_()) throw Stopped();
    const auto left = std::chrono::ceil<milliseconds>(end_ - Clock::now());
    return std::clamp(left, milliseconds(0), kLook);
  }

 private:
  Clock::time_point end_;
  const KeepGoing& go_;
};

// What a thread that looks up a name shares with whom it is for, who may not wait for its end.
struct Lookup {
  std::string host, port;
  std::atomic<bool> done = false;
  int error = 0;
  Addresses found;

  void run() {
    addrinfo hints{};
    hints.ai_socktype = SOCK_STREAM;
    addrinfo* list = nullptr;
    error = ::getaddrinfo(host.c_str(), port.c_str(), &hints, &list);
    found.reset(list);
    done = true;
  }
};

/// What there is of a link, whatever stage it reached.
struct Ends {
  std::string name;  // of the server, for people
  int socket = -1;
  std::unique_ptr<SSL_CTX, FreeTls> context;
  std::unique_ptr<SSL, FreeTls> session;  // null: no TLS

  Ends() = default;
  Ends(const Ends&) = delete;
  Ends& operator=(const Ends&) = delete;
  ~Ends() { close(); }

  void close() {
    session.reset();
    if (socket >= 0) ::close(std::exchange(socket, -1));
  }
  [[noreturn]] void fail(const std::string& why) const { throw AwayError(name + ": " + why); }
};

Addresses look_up(const HttpAddress& address, const Ends& ends, milliseconds most,
                  const KeepGoing& go) {
  const auto lookup = std::make_shared<Lookup>();
  lookup->host = address.host, lookup->port = std::to_string(address.port);
  // getaddrinfo can neither be ended nor told how long it may take.
  std::thread([lookup] { lookup->run(); }).detach();
  const Patience patience(most, go);
  constexpr milliseconds kMoment{5};
  while (!lookup->done) {
    const milliseconds left = patience.next();
    if (left.count() == 0) ends.fail("nobody says where that is; see to the name service");
    std::this_thread::sleep_for(std::min(left, kMoment));
  }
  if (lookup->error != 0)
    ends.fail(std::string("cannot be found (") + ::gai_strerror(lookup->error) +
              "); see to the name of the server");
  return std::move(lookup->found);
}

// Whether the socket is ready for `events` within the time.
bool ready(int socket, int events, milliseconds most, const KeepGoing& go) {
  const Patience patience(most, go);
  for (;;) {
    pollfd waits{socket, static_cast<short>(events), 0};
    const milliseconds next = patience.next();
    if (::poll(&waits, 1, static_cast<int>(next.count())) > 0) return true;
    if (next.count() == 0) return false;
  }
}

// The socket of the first address that answers.
void connect(Ends& ends, const addrinfo* list, milliseconds most, const KeepGoing& go) {
  std::string why = "has no address";
  for (; list != nullptr; list = list->ai_next) {
    ends.socket = ::socket(list->ai_family, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
    if (ends.socket < 0) ends.fail(std::strerror(errno));
    int error = 0;
    if (::connect(ends.socket, list->ai_addr, list->ai_addrlen) != 0) error = errno;
    if (error == EINPROGRESS && ready(ends.socket, POLLOUT, most, go)) {
      socklen_t size = sizeof error;
      ::getsockopt(ends.socket, SOL_SOCKET, SO_ERROR, &error, &size);
    }
    if (error == 0) {
      const int on = 1;
      ::setsockopt(ends.socket, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
      return;
    }
    why = error == EINPROGRESS ? "does not answer" : std::strerror(error);
    ends.close();
  }
  ends.fail(why + "; is 'regarment serve' running there?");
}

std::string tls_reason(const SSL* session) {
  const long verdict = ::SSL_get_verify_result(session);
  if (verdict != X509_V_OK)
    return std::string("its certificate is not to be trusted (") +
           ::X509_verify_cert_error_string(verdict) +
           "); an authority of your own is named by SSL_CERT_FILE";
  const unsigned long error = ::ERR_peek_last_error();
  const char* reason = error == 0 ? nullptr : ::ERR_reason_error_string(error);
  return std::string("the connection broke") + (reason ? std::string(" (") + reason + ")" : "");
}

// Runs a call of OpenSSL until it is done; 0: the peer has closed.
template <class Call>
int run_tls(const Ends& ends, milliseconds most, const KeepGoing& go, const Call& call) {
  for (;;) {
    ::ERR_clear_error();
    const int result = call(ends.session.get());
    if (result > 0) return result;
    const int error = ::SSL_get_error(ends.session.get(), result);
    if (error == SSL_ERROR_ZERO_RETURN) return 0;
    if (error != SSL_ERROR_WANT_READ && error != SSL_ERROR_WANT_WRITE)
      ends.fail(tls_reason(ends.session.get()));
    if (!ready(ends.socket, error == SSL_ERROR_WANT_READ ? POLLIN : POLLOUT, most, go))
      ends.fail("does not answer");
  }
}

bool is_ip(const std::string& host) {
  in6_addr any{};
  return ::inet_pton(AF_INET, host.c_str(), &any) == 1 ||
         ::inet_pton(AF_INET6, host.c_str(), &any) == 1;
}

// SSL_set_tlsext_host_name, which is a macro with a cast that our warnings refuse.
bool say_host(SSL* session, std::string host) {
  return ::SSL_ctrl(session, SSL_CTRL_SET_TLSEXT_HOSTNAME, TLSEXT_NAMETYPE_host_name,
                    host.data()) == 1;
}

void shake_hands(Ends& ends, const std::string& host, milliseconds most, const KeepGoing& go) {
  ends.context.reset(::SSL_CTX_new(::TLS_client_method()));
  SSL_CTX* context = ends.context.get();
  bool good = context != nullptr && ::SSL_CTX_set_default_verify_paths(context) == 1 &&
              SSL_CTX_set_min_proto_version(context, TLS1_2_VERSION) == 1;
  if (good) ::SSL_CTX_set_verify(context, SSL_VERIFY_PEER, nullptr);
  ends.session.reset(good ? ::SSL_new(context) : nullptr);
  SSL* session = ends.session.get();
  good = session != nullptr && ::SSL_set_fd(session, ends.socket) == 1;
  if (good && is_ip(host))
    good = ::X509_VERIFY_PARAM_set1_ip_asc(::SSL_get0_param(session), host.c_str()) == 1;
  else if (good)
    good = ::SSL_set1_host(session, host.c_str()) == 1 && say_host(session, host);
  if (!good) ends.fail("TLS cannot be set up; see to the installation of OpenSSL");
  if (run_tls(ends, most, go, [](SSL* s) { return ::SSL_connect(s); }) == 0)
    ends.fail("closed while shaking hands");
}

}  // namespace

struct Link::Inside : Ends {};

Link::Link(const HttpAddress& address, milliseconds most, const KeepGoing& go)
    : inside_(std::make_unique<Inside>()) {
  inside_->name = address.text();
  const Addresses found = look_up(address, *inside_, most, go);
  connect(*inside_, found.get(), most, go);
  if (address.tls) shake_hands(*inside_, address.host, most, go);
}

Link::~Link() = default;

std::size_t Link::read(char* to, std::size_t size, milliseconds most, const KeepGoing& go) {
  const Ends& ends = *inside_;
  if (ends.session)
    return static_cast<std::size_t>(run_tls(ends, most, go, [&](SSL* s) {
      return ::SSL_read(s, to, static_cast<int>(std::min<std::size_t>(size, 1U << 20U)));
    }));
  for (;;) {
    const ssize_t got = ::recv(ends.socket, to, size, 0);
    if (got >= 0) return static_cast<std::size_t>(got);
    if (errno == EINTR) continue;
    if (errno != EAGAIN) ends.fail(std::strerror(errno));
    if (!ready(ends.socket, POLLIN, most, go)) ends.fail("does not answer");
  }
}

void Link::write(std::string_view bytes, milliseconds most, const KeepGoing& go) {
  const Ends& ends = *inside_;
  while (!bytes.empty()) {
    const std::size_t size = std::min<std::size_t>(bytes.size(), 1U << 16U);
    if (ends.session) {
      const int sent = run_tls(ends, most, go, [&](SSL* s) {
        return ::SSL_write(s, bytes.data(), static_cast<int>(size));
      });
      if (sent == 0) ends.fail("closed the connection");
      bytes.remove_prefix(static_cast<std::size_t>(sent));
      continue;
    }
    const ssize_t sent = ::send(ends.socket, bytes.data(), size, MSG_NOSIGNAL);
    if (sent >= 0) bytes.remove_prefix(static_cast<std::size_t>(sent));
    if (sent >= 0 || errno == EINTR) continue;
    if (errno != EAGAIN) ends.fail(std::strerror(errno));
    if (!ready(ends.socket, POLLOUT, most, go)) ends.fail("takes nothing more");
  }
}

bool Link::arrives(milliseconds most, const KeepGoing& go) {
  if (inside_->session && ::SSL_pending(inside_->session.get()) > 0) return true;
  return ready(inside_->socket, POLLIN, most, go);
}

}  // namespace regarment
