#include "jobs/file_names.h"

#include <algorithm>

namespace regarment {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostParts = 8, kLongestPart = 255;

bool is_part(std::string_view part) {
  return !part.empty() && part.size() <= kLongestPart && part[0] != '.' &&
         std::none_of(part.begin(), part.end(), [](char c) {
           return static_cast<unsigned char>(c) < 0x20 || c == 0x7f || c == '\\';
         });
}

}  // namespace

std::vector<std::string> file_names(const fs::path& folder) {
  std::vector<std::string> out;
  std::error_code error;
  fs::recursive_directory_iterator entry(folder, error);
  for (const fs::recursive_directory_iterator end; !error && entry != end; entry.increment(error)) {
    const bool hidden = entry->path().filename().string().starts_with('.');
    if (hidden) entry.disable_recursion_pending();
    std::error_code ignored;
    if (!hidden && fs::is_regular_file(entry->symlink_status(ignored)))
      out.push_back(entry->path().lexically_relative(folder).string());
  }
  std::sort(out.begin(), out.end());
  return out;
}

bool is_file_name(std::string_view name) {
  for (std::size_t parts = 1; parts <= kMostParts; ++parts) {
    const std::size_t slash = name.find('/');
    if (!is_part(name.substr(0, slash))) return false;
    if (slash == std::string_view::npos) return true;
    name.remove_prefix(slash + 1);
  }
  return false;
}

}  // namespace regarment
