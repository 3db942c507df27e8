#include "jobs/server_files.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <nlohmann/json.hpp>
#include <span>
#include <thread>

#include "base/away_error.h"
#include "base/one_line.h"
#include "base/sha256.h"
#include "jobs/file_names.h"
#include "report/files.h"

namespace regarment {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;
using Json = nlohmann::json;
using std::chrono::milliseconds;

constexpr std::size_t kMostJson = std::size_t{16} << 20U;
constexpr milliseconds kLook{100}, kFirstPause{200}, kLongestPause{3000};
constexpr int kOk = 200, kPartial = 206;

// What a problem document (RFC 9457) says under this name.
std::string said(const ClientAnswer& answer, const char* name) {
  const Json json = Json::parse(answer.body, nullptr, false);
  if (!json.is_object() || !json.contains(name) || !json[name].is_string()) return {};
  return one_line(json[name].get<std::string>(), 300);
}

// Throws what an answer means to a worker, unless it is a good one.
void check_answer(const ClientAnswer& answer, const std::string& server) {
  if (answer.is_good()) return;
  const std::string code = said(answer, "code"), detail = said(answer, "detail");
  const std::string line =
      server + " answers " + std::to_string(answer.status) + (detail.empty() ? "" : ": " + detail);
  switch (answer.status) {
    case 401:
    case 403:
    case 421:
      throw NoAccess(line + "; set server_key to a key with the scope 'work'");
    case 404:
    case 409:
      if (code == "no_such_job" || code == "not_held") throw ClaimLost();
      if (code == "no_such_address") throw NoAccess(line + "; is it older than this worker?");
      throw TemporaryError(line);
    case 422:
      if (code == "unreadable") throw ReadError(detail);
      if (code == "bad_request") throw UsageError(detail);
      throw TemporaryError(line);
    case 429:
    case 502:
    case 503:
    case 504:
      throw AwayError(line);
    default:
      if (answer.status < 400) throw NoAccess(line + "; give the address that answers itself");
      throw TemporaryError(line);
  }
}

std::string target_of(const Claim& claim, const std::string& below) {
  std::string out = "/v1/work/" + claim.job.id;
  for (std::size_t begin = 0; begin < below.size();) {
    const std::size_t end = std::min(below.find('/', begin), below.size());
    out += "/" + url_encoded(std::string_view(below).substr(begin, end - begin));
    begin = end + 1;
  }
  return out + "?token=" + std::to_string(claim.token);
}

struct Announced {
  std::string name, sha256;
  std::uint64_t bytes = 0;
};

[[noreturn]] void distrust(const std::string& what) {
  throw NoAccess("the server sends " + what + "; is it a regarment of another version?");
}

// Of the forms that job_inputs gives: what a hostile server names leads nowhere else.
bool is_input_name(const Claim& claim, const std::string& name) {
  const std::string own = claim.job.id + "/", source = claim.job.source + "/result-";
  const bool belongs =
      name.starts_with(own) || (!claim.job.source.empty() && name.starts_with(source));
  return belongs && is_file_name(name);
}

std::vector<Announced> announced_by(const ClientAnswer& answer, const Claim& claim) try {
  std::vector<Announced> out;
  const Json json = Json::parse(answer.body);
  for (const Json& one : json.at("files")) {
    out.push_back({one.at("name"), one.at("sha256"), one.at("bytes")});
    if (!is_input_name(claim, out.back().name)) distrust("a file of a name that is none");
  }
  return out;
} catch (const Json::exception&) {
  distrust("no list of files");
}

void make_folders(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw_write_error(folder, error.value());
}

}  // namespace

/// A file as it comes, in one answer or in several.
class ServerFiles::Download : public AnswerBody {
 public:
  Download(fs::path file, std::uint64_t size, std::uint64_t& arrived)
      : file_(std::move(file)), size_(size), arrived_(arrived) {
    constexpr mode_t kOwnerOnly = 0600;
    descriptor_ = ::open(file_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, kOwnerOnly);
    if (descriptor_ < 0) throw_write_error(file_, errno);
  }
  ~Download() override { ::close(descriptor_); }
  Download(const Download&) = delete;
  Download& operator=(const Download&) = delete;

  /// What asks for all that is missing.
  Headers range() const {
    if (got_ == 0 || etag_.empty()) return {};
    return {{"Range", "bytes=" + std::to_string(got_) + "-"}, {"If-Range", etag_}};
  }
  bool is_whole() const { return got_ == size_; }
  std::string sha256() const { return sha_.hex(); }

  void begin(const ClientAnswer& answer) override {
    const std::string from = "bytes " + std::to_string(got_) + "-";
    const bool goes_on =
        answer.status == kPartial && answer.headers.get("Content-Range").starts_with(from);
    if (!goes_on && answer.status != kOk) throw TemporaryError("the server sends another range");
    etag_ = answer.headers.get("ETag");
    if (goes_on) return;
    got_ = 0, sha_ = {};
    if (::ftruncate(descriptor_, 0) != 0) throw_write_error(file_, errno);
  }

  void take(std::string_view bytes) override {
    if (bytes.size() > size_ - got_)
      throw TemporaryError("the server sends more than it announced");
    sha_.add(std::as_bytes(std::span(bytes)));
    while (!bytes.empty()) {
      const ssize_t put =
          ::pwrite(descriptor_, bytes.data(), bytes.size(), static_cast<off_t>(got_));
      if (put < 0 && errno == EINTR) continue;
      if (put < 0) throw_write_error(file_, errno);
      got_ += static_cast<std::uint64_t>(put), arrived_ += static_cast<std::uint64_t>(put);
      bytes.remove_prefix(static_cast<std::size_t>(put));
    }
  }

 private:
  fs::path file_;
  std::uint64_t size_;
  std::uint64_t& arrived_;
  int descriptor_ = -1;
  std::uint64_t got_ = 0;  // bytes of the file
  Sha256 sha_;             // of these
  std::string etag_;
};

FileServer file_server(const ServiceConfig& config) {
  FileServer out;
  out.address = HttpAddress::parse(config.server);
  out.client.key = config.server_key;
  return out;
}

ServerFiles::ServerFiles(FileServer server, const fs::path& data)
    : server_(std::move(server)),
      scratch_(data),
      folders_(scratch_.path()),
      client_(server_.address, server_.client) {}

// Until it is done, or nothing has come for the time of patience.
template <class Act>
auto ServerFiles::patiently(const KeepGoing& go, const Act& act) {
  auto until = Clock::now() + server_.patience;
  milliseconds pause = kFirstPause;
  for (;;) {
    const std::uint64_t before = arrived_;
    try {
      return act();
    } catch (const AwayError&) {
      if (arrived_ > before) until = Clock::now() + server_.patience, pause = kFirstPause;
      if (Clock::now() >= until) {
        in_doubt_ = true;
        throw;
      }
    }
    for (const auto end = Clock::now() + pause; Clock::now() < end;) {
      if (!go()) throw Stopped();
      std::this_thread::sleep_for(std::min(pause, kLook));
    }
    pause = std::min(2 * pause, kLongestPause);
  }
}

ClientAnswer ServerFiles::ask(const ClientRequest& request, const KeepGoing& go) {
  return patiently(go, [&] {
    ClientAnswer answer = client_.ask(request, kMostJson, go);
    check_answer(answer, server_.address.text());
    return answer;
  });
}

void ServerFiles::check(const KeepGoing& go) {
  if (!in_doubt_) return;
  server_version(client_, go);
  in_doubt_ = false;
}

void ServerFiles::fetch(const Claim& claim, JobStore& /*store*/, const KeepGoing& go) {
  const ClientAnswer answer = ask({"POST", target_of(claim, "start")}, go);
  const std::vector<Announced> files = announced_by(answer, claim);
  std::uint64_t sum = 0;
  for (const Announced& one : files) {
    if (one.bytes > folders_.free_bytes() - std::min(folders_.free_bytes(), sum))
      throw TemporaryError(folders_.data().string() + ": no room for the files of the job");
    sum += one.bytes;
  }
  make_folders(folders_.job(claim.job.id));
  for (const Announced& one : files) fetch_file(claim, one.name, one.bytes, one.sha256, go);
}

void ServerFiles::fetch_file(const Claim& claim, const std::string& name, std::uint64_t bytes,
                             const std::string& sha256, const KeepGoing& go) {
  const fs::path file = folders_.data() / "jobs" / name;
  make_folders(file.parent_path());
  Download download(file, bytes, arrived_);
  patiently(go, [&] {
    const ClientRequest request{"GET", target_of(claim, "files/" + name), download.range()};
    check_answer(client_.ask(request, download, go), server_.address.text());
    if (!download.is_whole()) throw AwayError(server_.address.text() + ": a file broke off");
  });
  if (download.sha256() != sha256)
    throw TemporaryError("a file of the job came from the server other than it was announced");
}

std::uint64_t ServerFiles::deliver(const Claim& claim, const KeepGoing& go) {
  const fs::path folder = folders_.result(claim.job.id, claim.token);
  Json list = Json::array();
  for (const std::string& name : file_names(folder)) {
    ClientRequest request{"PUT", target_of(claim, "result/" + name)};
    request.target += "&sha256=" + file_sha256(folder / name);
    request.file = folder / name;
    ask(request, go);
    std::error_code ignored;
    list.push_back({{"name", name}, {"bytes", fs::file_size(folder / name, ignored)}});
  }
  ClientRequest commit{"POST", target_of(claim, "result")};
  commit.headers.add("Content-Type", "application/json");
  commit.body = Json{{"files", list}}.dump();
  const Json answer = Json::parse(ask(commit, go).body, nullptr, false);
  if (!answer.is_object() || !answer.contains("bytes") || !answer["bytes"].is_number_unsigned())
    distrust("no size of the result");
  return answer["bytes"];
}

void ServerFiles::forget(const Claim& /*claim*/) {
  std::error_code ignored;
  for (const char* place : {"jobs", "incoming"}) {
    std::vector<fs::path> found;
    for (const auto& entry : fs::directory_iterator(folders_.data() / place, ignored))
      found.push_back(entry.path());
    for (const fs::path& one : found) fs::remove_all(one, ignored);
  }
}

std::string server_version(HttpClient& client, const KeepGoing& go) {
  const ClientAnswer answer = client.ask({"GET", "/v1/work"}, kMostJson, go);
  check_answer(answer, client.address().text());
  std::string version = said(answer, "version");
  if (version.empty()) distrust("no version");
  return version;
}

}  // namespace regarment
