#include "scan/read_sandboxed.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>
#include <new>
#include <stdexcept>

#include "base/error.h"
#include "base/one_line.h"
#include "base/sha256.h"
#include "scan/file_bytes.h"
#include "scan/sandbox.h"

namespace regarment {
namespace {

constexpr std::size_t kLongestMessage = 2000;

enum class Outcome : std::uint32_t { None, Mesh, ReadError, OutOfMemory, TooLarge, Other };

// The start of the shared memory; the arrays of the mesh follow, in the order of `for_each_array`,
// largest alignment first, so that each begins where its elements may stand.
struct alignas(16) Answer {
  Outcome outcome;
  MeshFormat format;
  std::uint64_t positions, normals, triangles, colours;
  char message[kLongestMessage + 1];
};

template <class Action>
void for_each_array(Mesh& mesh, Action&& action) {
  action(mesh.positions);
  action(mesh.normals);
  action(mesh.triangles);
  action(mesh.colours);
}

// Large enough for any mesh within the limits, unless the file is too small to describe so much.
std::size_t answer_bytes(std::size_t file_bytes, const MeshReadLimits& limits) {
  constexpr std::size_t kSmallest = std::size_t{256} << 20U, kPerByte = 64;
  const std::size_t largest = limits.max_vertices * (2 * sizeof(Vec3) + sizeof(Colour)) +
                              limits.max_triangles * sizeof(Triangle);
  return sizeof(Answer) + std::min(largest, std::max(kSmallest, kPerByte * file_bytes));
}

// A byte of a mesh file takes up to 24 bytes while it is parsed (glTF's small indices do).
SandboxLimits sandbox_limits(std::size_t file_bytes) {
  constexpr std::uint64_t kMost = std::uint64_t{6} << 30U;
  constexpr std::size_t kBytesPerSecond = 10'000'000;
  SandboxLimits limits;
  limits.memory = std::min(kMost, limits.memory + 24 * std::uint64_t{file_bytes});
  const auto more = static_cast<unsigned>(file_bytes / kBytesPerSecond);
  limits.cpu_seconds += more;
  limits.clock_seconds += 10 * more;
  return limits;
}

void say(Answer& answer, Outcome outcome, const char* message) {
  std::strncpy(answer.message, message, kLongestMessage);
  answer.outcome = outcome;
}

void give_mesh(Mesh& mesh, std::span<std::byte> memory, Answer& answer) {
  std::size_t at = sizeof(Answer);
  bool fits = true;
  for_each_array(mesh, [&]<class Element>(const std::vector<Element>& array) {
    fits = fits && array.size() <= (memory.size() - at) / sizeof(Element);
    if (!fits) return;
    std::uninitialized_copy(array.begin(), array.end(),
                            reinterpret_cast<Element*>(memory.data() + at));
    at += array.size() * sizeof(Element);
  });
  answer.positions = mesh.positions.size();
  answer.normals = mesh.normals.size();
  answer.triangles = mesh.triangles.size();
  answer.colours = mesh.colours.size();
  answer.outcome = fits ? Outcome::Mesh : Outcome::TooLarge;
}

// What the child does. Nothing may be thrown out of it.
void parse_into(std::span<std::byte> memory, std::span<const std::byte> file,
                const std::filesystem::path& path, const MeshReadLimits& limits) noexcept {
  auto& answer = *reinterpret_cast<Answer*>(memory.data());
  try {
    answer.format = recognise_format(file, path);
    Mesh mesh = parse_mesh(file, answer.format, path.filename().string(), limits);
    give_mesh(mesh, memory, answer);
  } catch (const ReadError& error) {
    say(answer, Outcome::ReadError, error.what());
  } catch (const std::bad_alloc&) {
    answer.outcome = Outcome::OutOfMemory;
  } catch (const std::length_error&) {
    answer.outcome = Outcome::OutOfMemory;
  } catch (const std::exception& error) {
    say(answer, Outcome::Other, error.what());
  }
}

[[noreturn]] void fail_unfinished(const std::string& name, const SandboxEnd& end,
                                  const SandboxLimits& limits) {
  switch (end.kind) {
    case SandboxEnd::Kind::CpuLimit:
    case SandboxEnd::Kind::TimeLimit:
      throw ReadError(name + ": reading took more than the " + std::to_string(limits.cpu_seconds) +
                      " s a file of its size may take; export the scan again, best as binary PLY");
    case SandboxEnd::Kind::Killed:
      throw ReadError(name +
                      ": reading was ended by the system, which ran out of memory or time; "
                      "export the scan again, best as binary PLY");
    case SandboxEnd::Kind::NotStarted:
      throw TemporaryError(name + ": the process that reads files could not be started (" +
                           end.detail + "); allow seccomp and new processes");
    default:
      throw ReadError(name + ": the file broke its reader (" + end.detail +
                      "); it is malformed, export the scan again, best as binary PLY");
  }
}

// The child may have fallen to a hostile file, so nothing it says is believed unchecked.
class AnswerReader {
 public:
  AnswerReader(std::span<const std::byte> memory, const std::string& name)
      : memory_(memory), name_(name) {
    std::memcpy(&answer_, memory.data(), sizeof answer_);
  }

  MeshFormat format() const {
    check(answer_.format >= MeshFormat::Ply && answer_.format <= MeshFormat::Gltf);
    return answer_.format;
  }

  Mesh mesh(const MeshReadLimits& limits) {
    refuse_failure();
    const std::uint64_t n = answer_.positions;
    check(n > 0 && n <= limits.max_vertices && answer_.triangles <= limits.max_triangles);
    check(answer_.normals == 0 || answer_.normals == n);
    check(answer_.colours == 0 || answer_.colours == n);
    Mesh mesh;
    take(mesh.positions, n);
    take(mesh.normals, answer_.normals);
    take(mesh.triangles, answer_.triangles);
    take(mesh.colours, answer_.colours);
    for (const Vec3& p : mesh.positions) check(p.allFinite());
    for (const Vec3& n_unit : mesh.normals) check(n_unit.allFinite());
    for (const Triangle& t : mesh.triangles) check(t[0] < n && t[1] < n && t[2] < n);
    return mesh;
  }

 private:
  void check(bool right) const {
    if (!right) throw ReadError(name_ + ": the file broke its reader; export the scan again");
  }
  void refuse_failure() const {
    const std::string message =
        one_line({answer_.message, strnlen(answer_.message, kLongestMessage)}, kLongestMessage);
    switch (answer_.outcome) {
      case Outcome::Mesh:
        return;
      case Outcome::ReadError:
        throw ReadError(message);
      case Outcome::OutOfMemory:
      case Outcome::TooLarge:
        throw ReadError(name_ +
                        ": reading takes more memory than a file of its size justifies; "
                        "export the scan again, best as binary PLY");
      default:
        throw ReadError(name_ + ": the file broke its reader (" + message +
                        "); export the scan again, best as binary PLY");
    }
  }
  template <class Element>
  void take(std::vector<Element>& array, std::uint64_t count) {
    check(count <= (memory_.size() - at_) / sizeof(Element));
    const auto* const first = reinterpret_cast<const Element*>(memory_.data() + at_);
    array.assign(first, first + count);
    at_ += count * sizeof(Element);
  }

  std::span<const std::byte> memory_;
  std::string name_;
  Answer answer_;
  std::size_t at_ = sizeof(Answer);
};

}  // namespace

ReadMesh read_mesh_sandboxed(const std::filesystem::path& path, const ReadLimits& limits,
                             const Progress& progress) {
  progress.report("read", 0.0);
  const FileBytes file = read_file_bytes(path, limits.file_bytes);
  const SharedMemory memory(answer_bytes(file.size, limits.mesh));
  const SandboxLimits sandbox = sandbox_limits(file.size);
  const std::string name = one_line(path.filename().string());
  ReadMesh result;
  const SandboxEnd end =
      run_sandboxed([&] { parse_into(memory.span(), file.span(), path, limits.mesh); }, sandbox,
                    progress, [&] { result.sha256 = sha256_hex(file.span()); });
  if (end.kind != SandboxEnd::Kind::Finished) fail_unfinished(name, end, sandbox);
  AnswerReader answer(memory.span(), name);
  result.mesh = answer.mesh(limits.mesh);
  result.format = answer.format();
  progress.report("read", 1.0);
  return result;
}

}  // namespace regarment
