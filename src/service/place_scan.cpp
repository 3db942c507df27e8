#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/error.h"
#include "geometry/mesh_io.h"
#include "service/submit.h"

namespace regarment {
namespace {

namespace fs = std::filesystem;

/// The bytes of a file as they lie on the disk: looking at the first ones reads only these.
class MappedFile {
 public:
  explicit MappedFile(const fs::path& file) {
    const int descriptor = ::open(file.c_str(), O_RDONLY | O_CLOEXEC);
    struct stat facts {};
    if (descriptor >= 0 && ::fstat(descriptor, &facts) == 0 && facts.st_size > 0) {
      size_ = static_cast<std::size_t>(facts.st_size);
      bytes_ = ::mmap(nullptr, size_, PROT_READ, MAP_PRIVATE, descriptor, 0);
    }
    if (descriptor >= 0) ::close(descriptor);
    if (bytes_ == MAP_FAILED) throw TemporaryError("the upload cannot be read back");
  }
  ~MappedFile() {
    if (bytes_ != nullptr) ::munmap(bytes_, size_);
  }
  MappedFile(const MappedFile&) = delete;
  MappedFile& operator=(const MappedFile&) = delete;

  std::span<const std::byte> bytes() const {
    return {static_cast<const std::byte*>(bytes_), size_};
  }

 private:
  void* bytes_ = nullptr;
  std::size_t size_ = 0;
};

const char* extension_of(MeshFormat format) {
  switch (format) {
    case MeshFormat::Ply:
      return ".ply";
    case MeshFormat::Obj:
      return ".obj";
    case MeshFormat::Off:
      return ".off";
    case MeshFormat::Stl:
      return ".stl";
    case MeshFormat::Glb:
      return ".glb";
    case MeshFormat::Gltf:
      return ".gltf";
  }
  return ".ply";
}

MeshFormat format_of(const fs::path& file, const std::string& name) try {
  const MappedFile mapped(file);
  return recognise_format(mapped.bytes(), name.empty() ? "scan" : name);
} catch (const ReadError& error) {
  const bool empty = fs::file_size(file) == 0;
  throw HttpProblem(empty ? 422 : 415, empty ? "empty_scan" : "unknown_format", error.what());
}

}  // namespace

void place_scan(const Upload& upload, const std::string& name, const fs::path& to) {
  const fs::path file = upload.file(name);
  const MeshFormat format = format_of(file, upload.filename(name));
  fs::rename(file, fs::path(to) += extension_of(format));
}

}  // namespace regarment
