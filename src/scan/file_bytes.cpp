#include "scan/file_bytes.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <new>
#include <string>
#include <system_error>

#include "base/error.h"
#include "base/one_line.h"

namespace regarment {
namespace {

constexpr std::size_t kLongestPath = 4096;

class OpenFile {
 public:
  // Without O_NONBLOCK the opening of a pipe would wait for its writer.
  explicit OpenFile(const char* path) : fd_(open(path, O_RDONLY | O_NONBLOCK | O_CLOEXEC)) {}
  ~OpenFile() {
    if (fd_ >= 0) close(fd_);
  }
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;
  int fd() const { return fd_; }

 private:
  int fd_;
};

std::string reason(int error) { return std::generic_category().message(error); }

std::string kind_of(mode_t mode) {
  if (S_ISDIR(mode)) return "a directory";
  if (S_ISFIFO(mode)) return "a pipe";
  if (S_ISSOCK(mode)) return "a socket";
  return "a device";
}

std::unique_ptr<std::byte[]> take_memory(std::size_t size, const std::string& name) try {
  return std::make_unique_for_overwrite<std::byte[]>(size);
} catch (const std::bad_alloc&) {
  throw TemporaryError(name + ": no memory for its " + std::to_string(size >> 20U) +
                       " MiB; close other programs or thin the scan out");
}

}  // namespace

FileBytes read_file_bytes(const std::filesystem::path& path, std::uintmax_t most) {
  const std::string name = one_line(path.string(), kLongestPath);
  if (path.native().find('\0') != std::string::npos) {
    throw ReadError(name + ": a file name cannot hold a zero byte; check the name");
  }
  const OpenFile file(path.c_str());
  struct stat status {};
  if (file.fd() < 0 || fstat(file.fd(), &status) != 0) {
    throw ReadError(name + ": the file cannot be opened (" + reason(errno) +
                    "); check its name and permissions");
  }
  if (!S_ISREG(status.st_mode)) {
    throw ReadError(name + ": it is " + kind_of(status.st_mode) +
                    ", not a file; give the scan file itself");
  }
  const auto size = static_cast<std::uintmax_t>(status.st_size);
  if (size > most) {
    throw ReadError(name + ": the file has " + std::to_string(size) + " bytes, at most " +
                    std::to_string(most) + " are read; thin the scan out or save it as binary PLY");
  }
  FileBytes bytes;
  bytes.data = take_memory(size, name);
  while (bytes.size < size) {
    const ssize_t got = read(file.fd(), bytes.data.get() + bytes.size, size - bytes.size);
    if (got == 0) break;  // it became shorter meanwhile
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) {
      throw ReadError(name + ": byte " + std::to_string(bytes.size) + ": reading failed (" +
                      reason(errno) + "); check the disk");
    }
    bytes.size += static_cast<std::size_t>(got);
  }
  return bytes;
}

}  // namespace regarment
