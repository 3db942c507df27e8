// Prints how much of the invented surface of scans with true labels is recognised, and how much of
// what is recognised was invented: pairs of a mesh and its labels, of which 255 is invented.
#include <cstdio>
#include <fstream>
#include <span>
#include <vector>

#include "base/error.h"
#include "geometry/mesh_io.h"
#include "scan/make_scan.h"

namespace {

using namespace regarment;

std::vector<char> read_all(const char* file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

struct Tally {
  std::size_t right = 0, marked = 0, invented = 0;

  void print(const char* name) const {
    const auto share = [](std::size_t part, std::size_t of) {
      return of == 0 ? 1.0 : static_cast<double>(part) / static_cast<double>(of);
    };
    std::printf("%-40s precision %.2f  recall %.2f  (%zu marked, %zu invented)\n", name,
                share(right, marked), share(right, invented), marked, invented);
  }
};

Tally judge(const char* file, const char* labels_file) {
  const std::vector<char> content = read_all(file), labels = read_all(labels_file);
  const auto bytes = std::as_bytes(std::span(content));
  const Scan scan = make_scan(parse_mesh(bytes, recognise_format(bytes, file), file));
  if (labels.size() != scan.mesh.positions.size()) {
    throw ReadError(std::string(labels_file) + ": has not one label per vertex of " + file);
  }
  Tally tally;
  for (std::size_t v = 0; v < scan.invented.size(); ++v) {
    const bool truth = static_cast<unsigned char>(labels[v]) == 255;
    tally.marked += scan.invented[v];
    tally.invented += truth ? 1 : 0;
    tally.right += truth ? scan.invented[v] : 0;
  }
  return tally;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 3 || argc % 2 == 0) {
    std::printf("usage: invented_benchmark MESH LABELS [MESH LABELS ...]\n");
    return 2;
  }
  try {
    Tally all;
    for (int i = 1; i < argc; i += 2) {
      const Tally tally = judge(argv[i], argv[i + 1]);
      tally.print(argv[i]);
      all.right += tally.right;
      all.marked += tally.marked;
      all.invented += tally.invented;
    }
    all.print("all");
  } catch (const Error& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return error.exit_status();
  }
}
