#pragma once

#include <atomic>
#include <filesystem>
#include <string>
#include <thread>

namespace regarment {

/// Stands between a PostgreSQL client and its server, on sockets named as the server names its own,
/// and cuts a connection at the next COMMIT once it was told to.
class CuttingProxy {
 public:
  enum class Cut { None, BeforeCommit, AfterCommit };

  /// `server`: folder of the server's socket; `own`: an empty folder for this one's.
  CuttingProxy(const std::filesystem::path& server, const std::filesystem::path& own);
  ~CuttingProxy();
  CuttingProxy(const CuttingProxy&) = delete;
  CuttingProxy& operator=(const CuttingProxy&) = delete;

  /// The next COMMIT does not reach the server; or it does, and its answer does not come back.
  void cut(Cut next) { cut_ = next; }
  /// Whether the cut was made.
  bool was_cut() const { return cut_ == Cut::None; }

 private:
  void serve();
  // Passes bytes both ways until either end goes or the cut is made.
  void pass(int client, int server);

  std::filesystem::path server_;
  int listener_ = -1;
  std::atomic<bool> ending_ = false;
  std::atomic<Cut> cut_ = Cut::None;
  std::thread thread_;
};

}  // namespace regarment
