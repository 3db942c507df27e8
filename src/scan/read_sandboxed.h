#pragma once

#include <filesystem>
#include <string>

#include "base/progress.h"
#include "geometry/mesh.h"
#include "geometry/mesh_io.h"

namespace regarment {

/// What reading a file may cost. Memory and CPU time are derived from the file's size.
struct ReadLimits {
  std::uintmax_t file_bytes = std::uintmax_t{2} << 30U;  // larger files are refused unread
  MeshReadLimits mesh;
};

struct ReadMesh {
  Mesh mesh;
  MeshFormat format = MeshFormat::Ply;
  std::string sha256;  // of the file's bytes, hexadecimal
};

/// Reads a mesh or point cloud of any known format from an untrusted file. The file is taken into
/// memory here and parsed in a child process that can touch nothing but memory (scan/sandbox.h);
/// what comes back is checked again. Throws ReadError when the file is missing, no regular file,
/// too large, malformed, or needs more memory or time than its size justifies; TemporaryError when
/// this machine has no memory or process left; Stopped when `progress` says so.
///
/// Forks: call it before threads are started where that can be helped. Several threads may call it.
ReadMesh read_mesh_sandboxed(const std::filesystem::path& path, const ReadLimits& limits = {},
                             const Progress& progress = {});

}  // namespace regarment
