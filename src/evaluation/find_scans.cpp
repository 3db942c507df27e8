#include "evaluation/find_scans.h"

#include <algorithm>
#include <array>

namespace regarment {
namespace {

namespace fs = std::filesystem;

bool is_file(const fs::path& path) {
  std::error_code ignored;
  return fs::is_regular_file(path, ignored);
}

bool is_mesh_name(const fs::path& path) {
  std::string extension = path.extension().string();
  for (char& c : extension) c = static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
  constexpr std::array kKnown = {".ply", ".obj", ".off", ".stl", ".glb", ".gltf"};
  return std::find(kKnown.begin(), kKnown.end(), extension) != kKnown.end();
}

std::vector<fs::path> with_stem(const std::string& stem, const fs::path& folder) {
  std::vector<fs::path> out;
  std::error_code error;
  for (fs::directory_iterator i(folder, error), end; !error && i != end; i.increment(error)) {
    const fs::path& path = i->path();
    const bool named = path.filename().string().starts_with(stem + ".");
    if (named && is_mesh_name(path) && is_file(path)) out.push_back(path);
  }
  std::sort(out.begin(), out.end());
  return out;
}

}  // namespace

std::vector<fs::path> find_scans(const std::string& written, const fs::path& table_folder,
                                 const std::optional<fs::path>& scans) {
  if (is_file(table_folder / written)) return {(table_folder / written).lexically_normal()};
  const fs::path name = fs::path(written).filename();
  if (scans) {
    for (const fs::path& path : {*scans / written, *scans / name}) {
      if (is_file(path)) return {path.lexically_normal()};
    }
    std::vector<fs::path> found = with_stem(name.string(), *scans);
    if (!found.empty()) return found;
  }
  return with_stem(name.string(), (table_folder / written).parent_path());
}

std::optional<fs::path> find_labels(const std::string& written, const fs::path& scan,
                                    const fs::path& table_folder,
                                    const std::optional<fs::path>& scans) {
  if (!written.empty()) {
    const fs::path seen = table_folder / written;
    return !is_file(seen) && scans && is_file(*scans / written) ? *scans / written : seen;
  }
  const fs::path name = scan.stem().string() + ".labels.u8";
  for (const fs::path& folder : {table_folder, scan.parent_path()}) {
    if (is_file(folder / name)) return folder / name;
  }
  return std::nullopt;
}

}  // namespace regarment
