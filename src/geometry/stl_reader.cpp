#include <array>
#include <cstdint>
#include <cstring>

#include "base/one_line.h"
#include "geometry/mesh_readers.h"
#include "geometry/text_lines.h"

namespace regarment {
namespace {

constexpr std::size_t kHeaderBytes = 84, kFacetBytes = 50, kNormalBytes = 12;

std::uint64_t announced_facets(std::string_view file) {
  std::uint32_t facets = 0;
  std::memcpy(&facets, file.data() + kHeaderBytes - sizeof facets, sizeof facets);
  return facets;
}

// Many binary files begin with the word "solid" too, so their length decides.
bool is_binary(std::string_view file) {
  if (file.size() < kHeaderBytes) return false;
  return file.size() == kHeaderBytes + kFacetBytes * announced_facets(file) ||
         file.substr(0, 4096).find('\0') != std::string_view::npos;
}

void add_triangle(MeshBuilder& builder, const Place& place) {
  const auto end = static_cast<std::int64_t>(builder.mesh().positions.size());
  const std::array<std::int64_t, 3> corners{end - 3, end - 2, end - 1};
  builder.add_face(corners, place);
}

void read_binary(std::string_view file, MeshBuilder& builder) {
  const std::uint64_t facets = announced_facets(file);
  const Place count_place{Place::Unit::Byte, kHeaderBytes - 4};
  if (file.size() != kHeaderBytes + kFacetBytes * facets) {
    builder.fail(count_place, std::to_string(facets) + " facets take " +
                                  std::to_string(kHeaderBytes + kFacetBytes * facets) +
                                  " bytes, the file has " + std::to_string(file.size()) +
                                  "; it is cut off, export it again");
  }
  builder.check_vertex_count(3 * facets, count_place);
  builder.check_face_count(facets, count_place);
  builder.mesh().positions.reserve(3 * facets);
  builder.mesh().triangles.reserve(facets);
  for (std::uint64_t facet = 0; facet < facets; ++facet) {
    const Place place{Place::Unit::Byte, kHeaderBytes + kFacetBytes * facet};
    std::array<float, 9> c{};
    std::memcpy(c.data(), file.data() + place.at + kNormalBytes, sizeof c);
    for (std::size_t i = 0; i < c.size(); i += 3) {
      builder.add_vertex(static_cast<double>(c[i]), static_cast<double>(c[i + 1]),
                         static_cast<double>(c[i + 2]), place);
    }
    add_triangle(builder, place);
  }
}

// Facets of text: each statement must be the one that may follow the last.
class TextReader {
 public:
  TextReader(std::string_view file, MeshBuilder& builder) : lines_(file), builder_(builder) {}

  void read() {
    expect("solid");
    while (next_statement()) {
      if (word_ == "facet") {
        read_facet();
      } else if (word_ == "endsolid") {
        if (!next_statement()) return;
        if (word_ != "solid") fail_for("solid");
      } else {
        fail_for("facet or endsolid");
      }
    }
    builder_.fail(place(), "the file ends without endsolid; it is cut off, export it again");
  }

 private:
  Place place() const { return {Place::Unit::Line, lines_.number()}; }
  [[noreturn]] void fail_for(std::string_view wanted) const {
    builder_.fail(place(), "'" + one_line(word_, 40) + "' stands where " + std::string(wanted) +
                               " is due; export the file again");
  }
  bool next_statement() {
    if (!lines_.next_filled()) return false;
    fields_ = Fields(lines_.line());
    word_ = fields_.word();
    // Some write it all in capitals.
    for (char& c : word_) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    return true;
  }
  void expect(std::string_view wanted) {
    if (!next_statement()) {
      builder_.fail(place(), "the file ends within a facet; it is cut off, export it again");
    }
    if (word_ != wanted) fail_for(wanted);
  }
  double number() {
    double value = 0;
    Fields before = fields_;
    const Fields::Outcome outcome = fields_.number(value);
    if (outcome == Fields::Outcome::Ok) return value;
    builder_.fail(place(), describe(outcome, before.word()) + "; export the file again");
  }
  void read_facet() {
    const Place start = place();
    builder_.check_vertex_count(builder_.mesh().positions.size() + 3, start);
    expect("outer");
    for (int corner = 0; corner < 3; ++corner) {
      expect("vertex");
      const double x = number(), y = number(), z = number();
      builder_.add_vertex(x, y, z, place());
    }
    expect("endloop");
    expect("endfacet");
    add_triangle(builder_, start);
  }

  LineReader lines_;
  Fields fields_{std::string_view()};
  std::string word_;
  MeshBuilder& builder_;
};

}  // namespace

void read_stl(std::string_view file, MeshBuilder& builder) {
  if (is_binary(file)) {
    read_binary(file, builder);
  } else {
    TextReader(file, builder).read();
  }
}

}  // namespace regarment
