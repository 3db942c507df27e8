#include "service/delivery.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <nlohmann/json.hpp>

#include "base/sha256.h"
#include "jobs/file_names.h"
#include "report/files.h"

namespace regarment {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;
using Sizes = std::map<std::string, std::uint64_t>;  // of files, by name

constexpr std::uint64_t kMega = 1'000'000;
constexpr std::size_t kHashDigits = 64;

std::string parameter(const Call& call, const char* name) {
  const auto found = call.request.query.find(name);
  return found == call.request.query.end() ? "" : found->second;
}

template <class Number>
std::optional<Number> number_in(std::string_view text) {
  Number number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return number;
}

std::int64_t token_of(const Call& call) {
  if (const auto token = number_in<std::int64_t>(parameter(call, "token"))) return *token;
  throw HttpProblem(400, "bad_parameter", "token: give the number of the claim");
}

std::string hash_of(const Call& call) {
  std::string hash = parameter(call, "sha256");
  if (hash.size() == kHashDigits && hash.find_first_not_of("0123456789abcdef") == std::string::npos)
    return hash;
  throw HttpProblem(400, "bad_parameter", "sha256: give 64 hexadecimal digits, in small letters");
}

std::string name_of_file(const Call& call) {
  std::string name;
  for (auto part = call.captured.begin() + 1; part != call.captured.end(); ++part)
    name += (name.empty() ? "" : "/") + *part;
  if (!is_file_name(name))
    throw HttpProblem(400, "bad_name",
                      "no name for a file of a result: no part of it begins with a dot");
  return name;
}

void make_folders(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw_write_error("the delivery", error.value());
}

void check_space(const Service& service, const Request& request) {
  const auto length = number_in<std::uint64_t>(request.headers.get("Content-Length"));
  const std::uint64_t left = service.folders.free_bytes(),
                      kept = service.config.min_free_mb * kMega;
  if (left < kept || left - kept < length.value_or(0))
    throw HttpProblem(507, "no_space", "the disk of the service is nearly full; try again later");
}

/// One file on its way. Destroyed before its end, it leaves nothing.
class Delivery : public Exchange {
 public:
  Delivery(const Service& service, const Call& call, const Job& job)
      : service_(service), call_(call), hash_(hash_of(call)), name_(name_of_file(call)) {
    folder_ = service.folders.delivery(job.id, job.token);
    make_folders(folder_);
    // Hidden, and never the same: a request that broke off may not have ended when another comes.
    part_ = folder_ / ("." + new_job_id() + ".part");
    constexpr mode_t kOwnerOnly = 0600;
    descriptor_ = ::open(part_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, kOwnerOnly);
    if (descriptor_ < 0) throw_write_error("the delivery", errno);
  }
  ~Delivery() override {
    ::close(descriptor_);
    std::error_code ignored;
    fs::remove(part_, ignored);
  }
  Delivery(const Delivery&) = delete;
  Delivery& operator=(const Delivery&) = delete;

  std::uint64_t body_limit() const override {
    const std::uint64_t most = service_.config.fit_file_mb;
    return most == 0 ? std::numeric_limits<std::uint64_t>::max() : most << 20U;
  }

  void take(std::string_view bytes) override {
    sha_.add(std::as_bytes(std::span(bytes)));
    while (!bytes.empty()) {
      const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
      if (written < 0 && errno == EINTR) continue;
      if (written < 0) throw_write_error("the delivery", errno);
      bytes.remove_prefix(static_cast<std::size_t>(written));
    }
  }

  Response finish() override {
    if (sha_.hex() != hash_)
      throw HttpProblem(422, "wrong_hash", "the file that came has another SHA-256; send it again");
    // What the store will promise must be on the disk.
    if (::fsync(descriptor_) != 0) throw_write_error("the delivery", errno);
    held_job(service_, call_);
    const fs::path file = folder_ / name_;
    make_folders(file.parent_path());
    std::error_code error;
    fs::rename(part_, file, error);
    if (error) throw_write_error("the delivery", error.value());
    return text_response(204, "", "");
  }

 private:
  const Service& service_;
  const Call call_;
  const std::string hash_, name_;
  fs::path folder_, part_;
  int descriptor_ = -1;
  Sha256 sha_;
};

Sizes announced_sizes(const std::string& body) try {
  Sizes out;
  const Json json = Json::parse(body);
  for (const Json& one : json.at("files"))
    out[one.at("name").get<std::string>()] = one.at("bytes").get<std::uint64_t>();
  if (out.empty()) throw HttpProblem(400, "bad_json", "files: none given");
  return out;
} catch (const Json::exception&) {
  throw HttpProblem(400, "bad_json",
                    "the body must be {\"files\": [{\"name\": TEXT, \"bytes\": NUMBER}, ...]}");
}

Sizes sizes_in(const fs::path& folder) {
  Sizes out;
  for (const std::string& name : file_names(folder)) {
    std::error_code ignored;
    out[name] = fs::file_size(folder / name, ignored);
  }
  return out;
}

// What is half written, of requests that broke off.
void remove_parts(const fs::path& folder) {
  std::vector<fs::path> parts;
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(folder, ignored))
    if (entry.path().filename().string().starts_with('.')) parts.push_back(entry.path());
  for (const fs::path& part : parts) fs::remove(part, ignored);
}

}  // namespace

Job held_job(const Service& service, const Call& call) {
  const std::int64_t token = token_of(call);
  Job job = find_job(service, call.captured.at(0));
  if (job.is_held_under(token)) return job;
  throw HttpProblem(409, "not_held", "no worker has the job under this token; leave it");
}

std::unique_ptr<Exchange> begin_delivery(const Service& service, const Call& call) {
  const Job job = held_job(service, call);
  check_space(service, call.request);
  return std::make_unique<Delivery>(service, call, job);
}

Response commit_delivery(const Service& service, const Call& call) {
  const Job job = held_job(service, call);
  const Sizes announced = announced_sizes(call.body);
  const fs::path from = service.folders.delivery(job.id, job.token),
                 to = service.folders.result(job);
  if (sizes_in(to) != announced) {
    remove_parts(from);
    if (sizes_in(from) != announced)
      throw HttpProblem(409, "incomplete",
                        "the files that came are not those of the list; send them again");
    std::error_code error;
    fs::rename(from, to, error);
    if (error) throw_write_error("the result", error.value());
  }
  return text_response(200, "application/json",
                       Json{{"bytes", service.folders.bytes(job.id)}}.dump() + "\n");
}

}  // namespace regarment
