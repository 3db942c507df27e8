#include "service/upload.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>

#include "base/one_line.h"
#include "report/files.h"

namespace regarment {
namespace {

constexpr std::uint64_t kLongestText = 64U << 10U;

bool is_raw(std::string_view type) {
  return type.empty() || same_ignoring_case(type, "application/octet-stream") ||
         type.starts_with("model/") || same_ignoring_case(type, "text/plain");
}

class UploadExchange : public Exchange {
 public:
  UploadExchange(Call call, std::unique_ptr<Upload> upload, std::uint64_t limit,
                 std::function<Response(const Call&, Upload&)> answer)
      : call_(std::move(call)),
        upload_(std::move(upload)),
        limit_(limit),
        answer_(std::move(answer)) {}

  void read_form(const std::string& boundary) { form_.emplace(boundary, *upload_); }
  void read_raw(const std::string& part) {
    for (const auto& [name, value] : call_.request.query) {
      if (name == part || name == "filename") continue;
      upload_->add_text(name, value);
    }
    const auto name = call_.request.query.find("filename");
    upload_->begin_part(
        {part, name == call_.request.query.end() ? std::string() : name->second, {}});
  }

  std::uint64_t body_limit() const override { return limit_; }
  void take(std::string_view bytes) override {
    form_ ? form_->take(bytes) : upload_->take_data(bytes);
  }
  Response finish() override {
    form_ ? form_->finish() : upload_->end_part();
    return answer_(call_, *upload_);
  }

 private:
  Call call_;
  std::unique_ptr<Upload> upload_;
  std::uint64_t limit_;
  std::function<Response(const Call&, Upload&)> answer_;
  std::optional<FormParser> form_;
};

}  // namespace

Upload::Upload(const JobFolders& folders, std::map<std::string, std::uint64_t> files, bool hashed)
    : folders_(folders),
      files_(std::move(files)),
      hashed_(hashed),
      id_(new_job_id()),
      folder_(folders.begin_upload(id_)) {}

Upload::~Upload() {
  if (descriptor_ >= 0) ::close(descriptor_);
  if (!kept_) folders_.remove(id_);
}

void Upload::begin_part(const FormPart& part) {
  if (!names_.emplace(part.name, part.filename.value_or("")).second)
    throw HttpProblem(400, "bad_part", "'" + one_line(part.name, 60) + "' is given twice");
  part_ = part.name;
  order_.push_back(part_);
  sha_ = {};
  const auto named = files_.find(part_);
  const bool other = named == files_.end() && part.filename && other_files_ > 0;
  left_ = named != files_.end() ? named->second : other ? other_files_ : kLongestText;
  if (named == files_.end() && !other) {
    texts_[part_];
    return;
  }
  constexpr mode_t kOwnerOnly = 0600;
  descriptor_ = ::open(file(part_).c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, kOwnerOnly);
  if (descriptor_ < 0) throw_write_error("the upload", errno);
}

void Upload::take_data(std::string_view bytes) {
  if (bytes.size() > left_)
    throw HttpProblem(413, "too_large", "'" + one_line(part_, 60) + "' is too large; send less");
  left_ -= bytes.size();
  if (hashed_) sha_.add(std::as_bytes(std::span(bytes)));
  if (descriptor_ < 0) {
    texts_[part_].append(bytes);
    return;
  }
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) throw_write_error("the upload", errno);
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
}

void Upload::end_part() {
  if (hashed_) hashes_[part_] = sha_.hex();
  if (descriptor_ < 0) return;
  // What the store will promise must be on the disk.
  const bool safe = ::fsync(descriptor_) == 0;
  const int error = errno;
  ::close(std::exchange(descriptor_, -1));
  if (!safe) throw_write_error("the upload", error);
}

void Upload::add_text(const std::string& name, std::string_view text) {
  begin_part({name, {}, {}});
  take_data(text);
  end_part();
}

std::vector<std::string> Upload::part_names() const { return order_; }

// Numbered: what a sender calls a part must not become part of a path.
std::filesystem::path Upload::file(const std::string& name) const {
  const auto place = std::find(order_.begin(), order_.end(), name) - order_.begin();
  return folder_ / (std::to_string(place) + ".part");
}

std::string Upload::text(const std::string& name) const {
  const auto found = texts_.find(name);
  return found == texts_.end() ? "" : found->second;
}

std::string Upload::hash() const {
  if (!hashed_) return {};
  std::string all;
  for (const auto& [name, hash] : hashes_) {
    // Names may hold anything; their hashes cannot run into one another.
    all += sha256_hex(std::as_bytes(std::span(name))) + hash +
           sha256_hex(std::as_bytes(std::span(names_.at(name))));
  }
  return sha256_hex(std::as_bytes(std::span(all)));
}

std::unique_ptr<Exchange> begin_upload(Call call, std::unique_ptr<Upload> upload,
                                       const std::string& raw, std::uint64_t limit,
                                       std::function<Response(const Call&, Upload&)> answer) {
  const std::string type(call.request.headers.get("Content-Type"));
  const std::string_view plain = trimmed(std::string_view(type).substr(0, type.find(';')));
  auto exchange = std::make_unique<UploadExchange>(std::move(call), std::move(upload), limit,
                                                   std::move(answer));
  if (same_ignoring_case(plain, "multipart/form-data"))
    exchange->read_form(form_boundary(type));
  else if (is_raw(plain))
    exchange->read_raw(raw);
  else
    throw HttpProblem(415, "bad_media_type",
                      "send multipart/form-data, or the scan as application/octet-stream");
  return exchange;
}

}  // namespace regarment
