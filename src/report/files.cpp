#include "report/files.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <span>
#include <utility>

#include "base/error.h"
#include "base/sha256.h"

namespace regarment {
namespace {

// Closes on every way out; `close` tells what the last writes came to.
class File {
 public:
  File(const std::filesystem::path& path, int flags)
      : descriptor_(::open(path.c_str(), flags | O_CLOEXEC, 0666)) {}
  ~File() {
    if (descriptor_ >= 0) ::close(descriptor_);
  }
  File(const File&) = delete;
  File& operator=(const File&) = delete;

  bool is_open() const { return descriptor_ >= 0; }
  int get() const { return descriptor_; }
  bool close() { return ::close(std::exchange(descriptor_, -1)) == 0; }

 private:
  int descriptor_;
};

void check_regular(const File& file, const std::filesystem::path& path) {
  struct stat status {};
  if (!file.is_open()) {
    throw ReadError(path.string() + ": cannot be opened (" + std::strerror(errno) +
                    "); check the name and its permissions");
  }
  if (::fstat(file.get(), &status) != 0 || !S_ISREG(status.st_mode)) {
    throw ReadError(path.string() + ": is not a regular file; give a file");
  }
}

}  // namespace

std::string read_file(const std::filesystem::path& path, std::size_t max_bytes) {
  // Not blocking: opening a pipe nobody writes to must not hang.
  File file(path, O_RDONLY | O_NONBLOCK);
  check_regular(file, path);
  std::string bytes;
  std::array<char, 1 << 16> block;
  while (bytes.size() < max_bytes) {
    const ssize_t got =
        ::read(file.get(), block.data(), std::min(block.size(), max_bytes - bytes.size()));
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) throw ReadError(path.string() + ": reading failed: " + std::strerror(errno));
    if (got == 0) break;
    bytes.append(block.data(), static_cast<std::size_t>(got));
  }
  return bytes;
}

void write_file(const std::filesystem::path& path, std::string_view bytes) {
  File file(path, O_WRONLY | O_CREAT | O_EXCL);
  if (!file.is_open()) throw_write_error(path, errno);
  while (!bytes.empty()) {
    const ssize_t put = ::write(file.get(), bytes.data(), bytes.size());
    if (put < 0 && errno == EINTR) continue;
    if (put < 0) throw_write_error(path, errno);
    bytes.remove_prefix(static_cast<std::size_t>(put));
  }
  if (!file.close()) throw_write_error(path, errno);
}

void replace_file(const std::filesystem::path& path, std::string_view bytes) {
  const std::filesystem::path hidden =
      path.parent_path() / ("." + path.filename().string() + ".part");
  std::error_code error;
  std::filesystem::remove(hidden, error);
  write_file(hidden, bytes);
  std::filesystem::rename(hidden, path, error);
  if (!error) return;
  const int why = error.value();
  std::filesystem::remove(hidden, error);
  throw_write_error(path, why);
}

std::string file_sha256(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  Sha256 sha;
  std::array<char, 1 << 16> block;
  while (stream.read(block.data(), block.size()) || stream.gcount() > 0) {
    sha.add(std::as_bytes(std::span(block.data(), static_cast<std::size_t>(stream.gcount()))));
  }
  return stream.eof() ? sha.hex() : "";
}

void throw_write_error(const std::filesystem::path& file, int error) {
  const std::string what = file.string() + ": cannot be written (" + std::strerror(error) + "); ";
  const bool temporary = error == ENOSPC || error == EDQUOT || error == EIO || error == ENOMEM ||
                         error == EMFILE || error == ENFILE || error == EFBIG || error == ESTALE;
  if (temporary) throw TemporaryError(what + "make room and try again");
  throw UsageError(what + "choose a place you may write to");
}

}  // namespace regarment
