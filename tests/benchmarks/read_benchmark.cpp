// Prints how fast meshes are read: the parsers alone in MB/s, and a scan of usual size end to end.
#include <chrono>
#include <cstdio>
#include <fstream>
#include <random>
#include <span>

#include "base/sha256.h"
#include "geometry/mesh_io.h"
#include "geometry/ply_writer.h"
#include "scan/read_sandboxed.h"

namespace {

using namespace regarment;
using Clock = std::chrono::steady_clock;

constexpr std::size_t kVertices = 130'000;

// A point cloud with colours, coordinates in millimetres.
Mesh made_scan() {
  std::mt19937 random(1);
  const auto below = [&](std::uint32_t end) { return static_cast<std::uint32_t>(random()) % end; };
  Mesh mesh;
  for (std::size_t i = 0; i < kVertices; ++i) {
    mesh.positions.emplace_back(below(1'000'000) / 1000.0, below(1'800'000) / 1000.0,
                                below(500'000) / 1000.0);
    mesh.colours.push_back({static_cast<std::uint8_t>(below(256)),
                            static_cast<std::uint8_t>(below(256)),
                            static_cast<std::uint8_t>(below(256))});
    const auto corner = [&] { return below(kVertices); };
    mesh.triangles.push_back({corner(), corner(), corner()});
    mesh.triangles.push_back({corner(), corner(), corner()});
  }
  return mesh;
}

std::string ascii_ply(const Mesh& mesh) {
  std::ostringstream out;
  out << "ply\nformat ascii 1.0\nelement vertex " << mesh.positions.size()
      << "\nproperty float x\nproperty float y\nproperty float z\nproperty uchar red\n"
         "property uchar green\nproperty uchar blue\nelement face "
      << mesh.triangles.size() << "\nproperty list uchar int vertex_indices\nend_header\n";
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const Vec3& p = mesh.positions[i];
    const Colour& c = mesh.colours[i];
    out << p.x() << ' ' << p.y() << ' ' << p.z() << ' ' << +c[0] << ' ' << +c[1] << ' ' << +c[2]
        << '\n';
  }
  for (const Triangle& t : mesh.triangles)
    out << "3 " << t[0] << ' ' << t[1] << ' ' << t[2] << '\n';
  return out.str();
}

std::string obj(const Mesh& mesh) {
  std::ostringstream out;
  for (const Vec3& p : mesh.positions) out << "v " << p.x() << ' ' << p.y() << ' ' << p.z() << '\n';
  for (const Triangle& t : mesh.triangles) {
    out << "f " << t[0] + 1 << ' ' << t[1] + 1 << ' ' << t[2] + 1 << '\n';
  }
  return out.str();
}

// The best of several runs, seconds: what the code takes when nothing else runs.
template <class Action>
double best_time(Action&& action) {
  double best = 1e9;
  for (int run = 0; run < 10; ++run) {
    const auto start = Clock::now();
    action();
    best = std::min(best, std::chrono::duration<double>(Clock::now() - start).count());
  }
  return best;
}

void report(const char* what, const std::string& bytes, double seconds) {
  std::printf("%-24s %7.1f MB %8.1f ms %8.0f MB/s\n", what, static_cast<double>(bytes.size()) / 1e6,
              seconds * 1e3, static_cast<double>(bytes.size()) / 1e6 / seconds);
}

void report_parser(const char* what, const std::string& bytes, MeshFormat format) {
  const auto span = std::as_bytes(std::span(bytes));
  report(what, bytes, best_time([&] { parse_mesh(span, format, what); }));
}

}  // namespace

int main() {
  const Mesh scan = made_scan();
  const std::string binary = PlyWriter(kVertices)
                                 .positions(scan.positions)
                                 .colours(scan.colours)
                                 .triangles(scan.triangles)
                                 .bytes();
  report_parser("binary PLY", binary, MeshFormat::Ply);
  report_parser("ascii PLY", ascii_ply(scan), MeshFormat::Ply);
  report_parser("OBJ", obj(scan), MeshFormat::Obj);
  report("SHA-256", binary, best_time([&] { sha256_hex(std::as_bytes(std::span(binary))); }));

  const auto path = std::filesystem::temp_directory_path() / "regarment_read_benchmark.ply";
  std::ofstream(path, std::ios::binary) << binary;
  report("sandboxed, end to end", binary, best_time([&] { read_mesh_sandboxed(path); }));
  std::filesystem::remove(path);
}
