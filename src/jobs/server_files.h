#pragma once

#include <chrono>
#include <string>

#include "http/client.h"
#include "jobs/job_files.h"
#include "jobs/scratch_folder.h"
#include "jobs/service_config.h"

namespace regarment {

/// How a worker reaches the server of its jobs' files.
struct FileServer {
  HttpAddress address;
  ClientOptions client;                        // its key has the scope "work"
  std::chrono::milliseconds patience{60'000};  // with a server that gives nothing
};

/// As the config has it. Throws UsageError for an address that is none.
FileServer file_server(const ServiceConfig& config);

/// Files fetched from a server over HTTP, and results delivered to it, by the routes /v1/work of
/// schemas/openapi.json. What is fetched has the SHA-256 that was announced for it; what broke off
/// is taken up where it did. Only names of the forms that job_inputs gives are taken from a server.
class ServerFiles : public JobFiles {
 public:
  /// Keeps files in a scratch folder below `data`. Throws as ScratchFolder and HttpClient do.
  ServerFiles(FileServer server, const std::filesystem::path& data);

  const JobFolders& folders() const override { return folders_; }
  /// Asks the server at the first call, and after it was away.
  void check(const KeepGoing& go) override;
  void fetch(const Claim& claim, JobStore& store, const KeepGoing& go) override;
  std::uint64_t deliver(const Claim& claim, const KeepGoing& go) override;
  void forget(const Claim& claim) override;

 private:
  class Download;

  ClientAnswer ask(const ClientRequest& request, const KeepGoing& go);
  void fetch_file(const Claim& claim, const std::string& name, std::uint64_t bytes,
                  const std::string& sha256, const KeepGoing& go);
  template <class Act>
  auto patiently(const KeepGoing& go, const Act& act);

  FileServer server_;
  ScratchFolder scratch_;
  JobFolders folders_;
  HttpClient client_;
  bool in_doubt_ = true;       // whether the server is there
  std::uint64_t arrived_ = 0;  // bytes of files, ever
};

/// The version of the server, for whoever may work for it. Throws as JobFiles::check.
std::string server_version(HttpClient& client, const KeepGoing& go);

}  // namespace regarment
