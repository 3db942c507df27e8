#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <string>

#include "base/sha256.h"
#include "http/multipart.h"
#include "service/route.h"
#include "service/service.h"

namespace regarment {

/// What a request brought: files in the folder of an upload, and texts. The folder is removed with
/// it unless `keep` was called.
class Upload : public FormReceiver {
 public:
  /// `files`: largest size of each part that becomes a file, by name. All other parts are texts of
  /// at most 64 KiB. With `hashed` every part is, for an Idempotency-Key.
  Upload(const JobFolders& folders, std::map<std::string, std::uint64_t> files, bool hashed);
  ~Upload() override;
  Upload(const Upload&) = delete;
  Upload& operator=(const Upload&) = delete;

  // As a form brings it. They throw HttpProblem: 400 "bad_part" for a name that is given twice, 413
  // "too_large"; TemporaryError when the disk is full.
  void begin_part(const FormPart& part) override;
  void take_data(std::string_view bytes) override;
  void end_part() override;

  /// From here on every part with a file name becomes a file, at most `most` bytes each.
  void take_other_files(std::uint64_t most) { other_files_ = most; }
  /// A part that the request says in another way.
  void add_text(const std::string& name, std::string_view text);
  /// Moves the folder among the jobs (JobFolders::accept_upload); it is still removed without
  /// `keep`.
  void accept() { folders_.accept_upload(id_); }

  const std::string& id() const { return id_; }
  const std::filesystem::path& folder() const { return folder_; }
  std::vector<std::string> part_names() const;
  bool has(const std::string& name) const { return names_.count(name) != 0; }
  /// A text; empty when it did not come.
  std::string text(const std::string& name) const;
  /// What the sender calls a file; empty when it does not say.
  std::string filename(const std::string& name) const { return names_.at(name); }
  /// Where the file of a part is, until it is moved.
  std::filesystem::path file(const std::string& name) const;
  /// One hash of the names and bytes of all parts, whatever their order. Empty unless `hashed`.
  std::string hash() const;

  void keep() { kept_ = true; }

 private:
  const JobFolders& folders_;
  std::map<std::string, std::uint64_t> files_;
  std::uint64_t other_files_ = 0;  // largest size of a file of another name; 0: there are none
  bool hashed_, kept_ = false;
  std::string id_;
  std::filesystem::path folder_;
  std::map<std::string, std::string> names_, texts_, hashes_;  // by part
  std::vector<std::string> order_;                             // of the parts

  // Of the part at hand.
  std::string part_;
  std::uint64_t left_ = 0;  // bytes it may still bring
  int descriptor_ = -1;     // of its file; -1: a text
  Sha256 sha_;
};

/// An exchange that reads a form, or a raw body as its part `raw` with the query's parameters as
/// the other parts, and then calls `answer`. Throws HttpProblem 415 "bad_media_type".
std::unique_ptr<Exchange> begin_upload(Call call, std::unique_ptr<Upload> upload,
                                       const std::string& raw, std::uint64_t limit,
                                       std::function<Response(const Call&, Upload&)> answer);

}  // namespace regarment
