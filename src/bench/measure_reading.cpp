#include <array>
#include <charconv>
#include <span>

#include "bench/measures.h"
#include "geometry/mesh_io.h"
#include "geometry/ply_writer.h"

namespace regarment {
namespace {

constexpr int kRounds = 5;
constexpr double kBinary = 200, kAscii = 60;  // MB/s, what is aimed at

template <typename Number>
void append(std::string& out, Number value) {
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
  out.append(text.data(), end).append(" ");
}

std::string ascii_ply(const Mesh& mesh) {
  std::string out = "ply\nformat ascii 1.0\nelement vertex " +
                    std::to_string(mesh.positions.size()) +
                    "\nproperty float x\nproperty float y\nproperty float z\nelement face " +
                    std::to_string(mesh.triangles.size()) +
                    "\nproperty list uchar int vertex_indices\nend_header\n";
  for (const Vec3& p : mesh.positions) {
    for (int c = 0; c < 3; ++c) append(out, static_cast<float>(p[c]));
    out.back() = '\n';
  }
  for (const Triangle& t : mesh.triangles) {
    out += "3 ";
    for (const std::uint32_t v : t) append(out, v);
    out.back() = '\n';
  }
  return out;
}

BenchRow row_of(const std::string& name, const std::string& bytes, double aim) {
  const auto span = std::as_bytes(std::span(bytes));
  const double seconds =
      best_in_turn({[&] { parse_mesh(span, MeshFormat::Ply, "benchmark.ply"); }}, kRounds)[0];
  return {.group = "Reading",
          .name = name,
          .value = static_cast<double>(bytes.size()) / 1e6 / seconds,
          .unit = "MB/s",
          .at_least = aim};
}

}  // namespace

void measure_reading(const Mesh& mesh, Bench& bench) {
  const std::string binary =
      PlyWriter(mesh.positions.size()).positions(mesh.positions).triangles(mesh.triangles).bytes();
  bench.rows.push_back(row_of("binary PLY", binary, kBinary));
  bench.rows.push_back(row_of("ascii PLY", ascii_ply(mesh), kAscii));
}

}  // namespace regarment
