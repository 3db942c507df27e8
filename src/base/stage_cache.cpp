#include "base/stage_cache.h"

#include <elf.h>
#include <fcntl.h>
#include <link.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <iterator>
#include <span>
#include <system_error>
#include <utility>
#include <vector>

#include "base/error.h"
#include "base/one_line.h"

namespace regarment {
namespace {

namespace fs = std::filesystem;

// Others' files in the folder are left alone.
constexpr std::string_view kEntry = ".stage", kUnfinished = ".stage-new-XXXXXX";

struct Kept {
  fs::file_time_type used;
  fs::path file;
  std::uint64_t bytes = 0;
};

// Entries, and what a process that was killed left of one.
std::vector<Kept> kept_in(const fs::path& folder) {
  std::vector<Kept> out;
  std::error_code error;
  for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
    if (it->path().filename().string().find(kEntry) == std::string::npos) continue;
    std::error_code gone;
    const fs::file_time_type used = it->last_write_time(gone);
    const std::uint64_t bytes = gone ? 0 : it->file_size(gone);
    if (!gone) out.push_back({used, it->path(), bytes});
  }
  return out;
}

bool write_all(int file, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(file, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return true;
}

int find_note(dl_phdr_info* info, std::size_t /*size*/, void* out) {
  constexpr std::size_t kAlign = 4;
  const auto up = [](std::size_t n) { return (n + kAlign - 1) / kAlign * kAlign; };
  for (const ElfW(Phdr) & part : std::span(info->dlpi_phdr, info->dlpi_phnum)) {
    if (part.p_type != PT_NOTE) continue;
    // The loader tells addresses as numbers. NOLINTNEXTLINE(performance-no-int-to-ptr)
    const auto* at = reinterpret_cast<const unsigned char*>(info->dlpi_addr + part.p_vaddr);
    std::span<const unsigned char> rest(at, part.p_memsz);
    while (rest.size() > sizeof(ElfW(Nhdr))) {
      const auto* note = reinterpret_cast<const ElfW(Nhdr)*>(rest.data());
      const std::size_t name = sizeof(*note), text = name + up(note->n_namesz);
      if (text + note->n_descsz > rest.size()) break;
      if (note->n_type == NT_GNU_BUILD_ID) {
        static_cast<std::string*>(out)->assign(reinterpret_cast<const char*>(rest.data() + text),
                                               note->n_descsz);
        return 1;
      }
      rest = rest.subspan(std::min(rest.size(), text + up(note->n_descsz)));
    }
  }
  return 1;  // the first of all is the program itself
}

}  // namespace

StageCache::StageCache(fs::path folder, std::uint64_t most_bytes)
    : folder_(std::move(folder)), most_bytes_(most_bytes) {
  std::error_code error;
  fs::create_directories(folder_, error);
  if (!fs::is_directory(folder_, error) || ::access(folder_.c_str(), W_OK | X_OK) != 0) {
    throw UsageError(one_line(folder_.string(), 300) +
                     ": no folder that can be written to; choose another --cache");
  }
}

std::optional<std::string> StageCache::get(const std::string& name) const {
  const fs::path file = folder_ / (name + std::string(kEntry));
  std::ifstream in(file, std::ios::binary);
  if (!in) return std::nullopt;
  std::string bytes{std::istreambuf_iterator<char>(in), {}};
  if (in.bad()) return std::nullopt;
  std::error_code gone;
  fs::last_write_time(file, fs::file_time_type::clock::now(), gone);
  return bytes;
}

void StageCache::put(const std::string& name, std::string_view bytes) const {
  if (bytes.size() > most_bytes_) return;
  std::string hidden = (folder_ / (name + std::string(kUnfinished))).string();
  const int file = ::mkstemp(hidden.data());
  if (file < 0) return;
  const bool whole = write_all(file, bytes);
  ::close(file);
  const std::string place = (folder_ / (name + std::string(kEntry))).string();
  if (!whole || ::rename(hidden.c_str(), place.c_str()) != 0) ::unlink(hidden.c_str());
  shrink();
}

void StageCache::shrink() const {
  std::vector<Kept> kept = kept_in(folder_);
  std::uint64_t sum = 0;
  for (const Kept& entry : kept) sum += entry.bytes;
  std::sort(kept.begin(), kept.end(), [](const Kept& a, const Kept& b) {
    return std::pair(a.used, a.file) < std::pair(b.used, b.file);
  });
  for (auto it = kept.begin(); it != kept.end() && sum > most_bytes_; ++it) {
    std::error_code gone;
    fs::remove(it->file, gone);
    sum -= it->bytes;
  }
}

std::string build_identity() {
  std::string id;
  ::dl_iterate_phdr(find_note, &id);
  return id;
}

}  // namespace regarment
