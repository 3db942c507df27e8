#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>
#include <cstring>
#include <optional>

#include "base/error.h"
#include "base/one_line.h"
#include "geometry/mesh_io.h"

namespace regarment {
namespace {

using namespace std::string_view_literals;

struct Known {
  MeshFormat format;
  std::string_view extension, title;
};
constexpr std::array<Known, 6> kKnown{{{MeshFormat::Ply, ".ply", "PLY"},
                                       {MeshFormat::Obj, ".obj", "OBJ"},
                                       {MeshFormat::Off, ".off", "OFF"},
                                       {MeshFormat::Stl, ".stl", "STL"},
                                       {MeshFormat::Glb, ".glb", "binary glTF"},
                                       {MeshFormat::Gltf, ".gltf", "glTF"}}};

const Known& known(MeshFormat format) {
  return *std::find_if(kKnown.begin(), kKnown.end(),
                       [&](const Known& entry) { return entry.format == format; });
}

// What a file that cannot be a mesh starts with, and what to tell the person who gave it.
struct Stranger {
  std::string_view start, words;
};
constexpr std::array<Stranger, 12> kStrangers{
    {{"\x1f\x8b"sv, "is compressed with gzip; unpack it first"},
     {"PK\x03\x04"sv, "is a zip archive; unpack it first"},
     {"BZh"sv, "is compressed with bzip2; unpack it first"},
     {"\xfd"
      "7zXZ"sv,
      "is compressed with xz; unpack it first"},
     {"\x28\xb5\x2f\xfd"sv, "is compressed with zstd; unpack it first"},
     {"7z\xbc\xaf"sv, "is a 7z archive; unpack it first"},
     {"\xff\xfe"sv, "is UTF-16 text; save it as plain ASCII or UTF-8"},
     {"\xfe\xff"sv, "is UTF-16 text; save it as plain ASCII or UTF-8"},
     {"\xef\xbb\xbf"sv, "begins with a byte order mark; save it as UTF-8 without BOM"},
     {"%PDF"sv, "is a PDF document; give a mesh or a point cloud"},
     {"\x89PNG"sv, "is a picture; give a mesh or a point cloud"},
     {"\xff\xd8\xff"sv, "is a picture; give a mesh or a point cloud"}}};

bool is_binary_stl(std::string_view file) {
  constexpr std::size_t kHeader = 84, kFacet = 50;
  if (file.size() < kHeader) return false;
  std::uint32_t facets = 0;
  std::memcpy(&facets, file.data() + 80, sizeof facets);
  return file.size() == kHeader + kFacet * std::uint64_t{facets};
}

// The words OFF may begin with: texture, colour, normal, homogeneous and dimension prefixes.
bool is_off(std::string_view file) {
  std::string_view word = file.substr(0, file.find_first_of(" \t\r\n#"));
  if (!word.ends_with("OFF")) return false;
  word.remove_suffix(3);
  return word.size() <= 5 && word.find_first_not_of("STCN4n") == std::string_view::npos;
}

std::optional<MeshFormat> by_content(std::string_view file) {
  if (file.starts_with("ply\n") || file.starts_with("ply\r")) return MeshFormat::Ply;
  if (file.starts_with("glTF")) return MeshFormat::Glb;
  if (is_off(file)) return MeshFormat::Off;
  if (is_binary_stl(file)) return MeshFormat::Stl;
  if (file.starts_with("solid") && file.substr(0, 4096).find("facet") != std::string_view::npos) {
    return MeshFormat::Stl;
  }
  const std::size_t first = file.find_first_not_of(" \t\r\n");
  if (first != std::string_view::npos && file[first] == '{' &&
      file.substr(0, std::size_t{64} << 10U).find('"') != std::string_view::npos) {
    return MeshFormat::Gltf;
  }
  return std::nullopt;
}

std::optional<MeshFormat> by_extension(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  for (const Known& entry : kKnown) {
    if (entry.extension == extension) return entry.format;
  }
  return std::nullopt;
}

}  // namespace

MeshFormat recognise_format(std::span<const std::byte> bytes, const std::filesystem::path& path) {
  const std::string_view file(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  const std::string name = one_line(path.filename().string());
  if (file.empty()) throw ReadError(name + ": the file is empty; export the scan again");
  for (const Stranger& stranger : kStrangers) {
    if (file.starts_with(stranger.start)) {
      throw ReadError(name + ": byte 0: the file " + std::string(stranger.words));
    }
  }
  const std::optional<MeshFormat> content = by_content(file);
  const std::optional<MeshFormat> extension = by_extension(path);
  if (content && extension && *content != *extension) {
    throw ReadError(name + ": byte 0: the file is named as " +
                    std::string(known(*extension).title) + " but holds " +
                    std::string(known(*content).title) + "; rename it to " +
                    std::string(known(*content).extension));
  }
  if (content) return *content;
  if (extension == MeshFormat::Ply || extension == MeshFormat::Glb) {
    throw ReadError(name + ": byte 0: the file is named as " +
                    std::string(known(*extension).title) +
                    " but does not begin like one; export the scan again");
  }
  if (extension) return *extension;
  throw ReadError(name + ": byte 0: neither content nor name tells a known format; give " +
                  "PLY, OBJ, OFF, STL, GLB or glTF with its usual extension");
}

}  // namespace regarment
