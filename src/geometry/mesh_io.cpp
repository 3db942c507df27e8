#include "geometry/mesh_io.h"

#include "base/error.h"
#include "base/one_line.h"
#include "geometry/mesh_readers.h"

namespace regarment {
namespace {

// Text readers take LF or CR LF. A file of lone CRs would look like one endless line to them.
void refuse_lone_carriage_returns(std::string_view file, std::string_view name) {
  const std::string_view start = file.substr(0, std::size_t{64} << 10U);
  if (start.find('\n') == std::string_view::npos && start.find('\r') != std::string_view::npos) {
    throw ReadError(one_line(name) +
                    ": line 1: its lines end with CR alone; convert them to LF, as mac2unix does");
  }
}

}  // namespace

Mesh parse_mesh(std::span<const std::byte> bytes, MeshFormat format, std::string_view name,
                const MeshReadLimits& limits) {
  const std::string_view file(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  if (file.empty()) throw ReadError(one_line(name) + ": the file is empty; export the scan again");
  if (format == MeshFormat::Ply || format == MeshFormat::Obj || format == MeshFormat::Off) {
    refuse_lone_carriage_returns(file, name);
  }
  MeshBuilder builder(name, limits);
  switch (format) {
    case MeshFormat::Ply:
      read_ply(file, builder);
      break;
    case MeshFormat::Obj:
      read_obj(file, builder);
      break;
    case MeshFormat::Off:
      read_off(file, builder);
      break;
    case MeshFormat::Stl:
      read_stl(file, builder);
      break;
    case MeshFormat::Glb:
    case MeshFormat::Gltf:
      read_gltf(file, builder);
      break;
  }
  return builder.finish();
}

}  // namespace regarment
