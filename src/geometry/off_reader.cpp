#include <algorithm>
#include <array>

#include "base/one_line.h"
#include "geometry/mesh_readers.h"
#include "geometry/text_lines.h"

namespace regarment {
namespace {

constexpr const char* kNoWord = "an OFF file must begin with the word OFF; export it again";

// What the letters before "OFF" announce for each vertex.
struct Announced {
  bool colours = false, normals = false, texture = false;
};

class OffReader {
 public:
  OffReader(std::string_view file, MeshBuilder& builder) : lines_(file), builder_(builder) {}
  void read();

 private:
  [[noreturn]] void fail(const std::string& words) const { builder_.fail(place(), words); }
  Place place() const { return {Place::Unit::Line, lines_.number()}; }
  bool next_row();
  void expect_row(std::string_view what, std::uint64_t row, std::uint64_t count);
  std::int64_t whole(std::string_view what);
  double number();
  void read_keyword();
  void read_counts();
  void read_vertices();
  void add_colours();
  void read_faces();

  LineReader lines_;
  MeshBuilder& builder_;
  Fields fields_{std::string_view()};
  Announced announced_;
  std::uint64_t vertices_ = 0, faces_ = 0;
  std::vector<Vec3> colours_;  // as written, 0..1 or 0..255
};

// The next line that holds more than a comment.
bool OffReader::next_row() {
  while (lines_.next()) {
    fields_ = Fields(lines_.line().substr(0, lines_.line().find('#')));
    if (!fields_.at_end()) return true;
  }
  return false;
}

void OffReader::expect_row(std::string_view what, std::uint64_t row, std::uint64_t count) {
  if (next_row()) return;
  fail("the file ends after " + std::to_string(row) + " of " + std::to_string(count) + " " +
       std::string(what) + "; it is cut off, export it again");
}

std::int64_t OffReader::whole(std::string_view what) {
  std::int64_t value = 0;
  Fields before = fields_;
  const Fields::Outcome outcome = fields_.whole(value);
  if (outcome != Fields::Outcome::Ok) {
    fail(std::string(what) + ": " + describe(outcome, before.word()) + "; export the file again");
  }
  return value;
}

double OffReader::number() {
  double value = 0;
  Fields before = fields_;
  const Fields::Outcome outcome = fields_.number(value);
  if (outcome != Fields::Outcome::Ok) {
    fail(describe(outcome, before.word()) + "; export the file again");
  }
  return value;
}

void OffReader::read_keyword() {
  if (!next_row()) fail(kNoWord);
  std::string_view word = fields_.word();
  if (!word.ends_with("OFF")) fail(kNoWord);
  const std::string_view letters = word.substr(0, word.size() - 3);
  for (const char letter : letters) {
    if (letter == '4' || letter == 'n') {
      fail("the variant '" + one_line(word, 20) +
           "' with other than 3 dimensions is not read; save it as PLY");
    }
  }
  announced_.colours = letters.find('C') != std::string_view::npos;
  announced_.normals = letters.find('N') != std::string_view::npos;
  announced_.texture = letters.find("ST") != std::string_view::npos;
  if (fields_.at_end() && !next_row())
    fail("the counts of vertices and faces are missing; export the file again");
  Fields ahead = fields_;
  if (ahead.word() == "BINARY") fail("binary OFF is not read; save it as text or as PLY");
}

void OffReader::read_counts() {
  const std::int64_t vertices = whole("count of vertices");
  const std::int64_t faces = whole("count of faces");
  // The count of edges follows; nobody fills it in correctly, and nothing needs it.
  if (!fields_.at_end()) whole("count of edges");
  if (!fields_.at_end()) fail("more than three counts; export the file again");
  if (vertices < 0 || faces < 0) fail("a negative count; export the file again");
  vertices_ = static_cast<std::uint64_t>(vertices);
  faces_ = static_cast<std::uint64_t>(faces);
  builder_.check_vertex_count(vertices_, place());
  builder_.check_face_count(faces_, place());
  // A vertex takes three digits and three blanks at least, a face one of each.
  if (6 * vertices_ + 2 * faces_ > lines_.rest().size() + 1) {
    fail(std::to_string(vertices_) + " vertices and " + std::to_string(faces_) +
         " faces do not fit into the " + std::to_string(lines_.rest().size()) +
         " bytes that follow; the file is cut off, export it again");
  }
}

void OffReader::read_vertices() {
  builder_.mesh().positions.reserve(vertices_);
  for (std::uint64_t row = 0; row < vertices_; ++row) {
    expect_row("vertices", row, vertices_);
    const double x = number(), y = number(), z = number();
    builder_.add_vertex(x, y, z, place());
    // Exporters disagree on the order of normals and colours: where both stand, neither is used.
    const bool both = announced_.normals && announced_.colours;
    if (announced_.normals) {
      const double nx = number(), ny = number(), nz = number();
      if (!both) builder_.add_normal(nx, ny, nz);
    }
    if (announced_.colours) {
      const double red = number(), green = number(), blue = number();
      if (!both) colours_.emplace_back(red, green, blue);
      if (fields_.count_rest() % 2 == 1) number();  // alpha; texture coordinates come in pairs
    }
    if (announced_.texture) {
      number();
      number();
    }
    if (!fields_.at_end())
      fail("more numbers than the first word of the file announces; export it again");
  }
}

// Colours are written from 0 to 1 by some and from 0 to 255 by others, for the whole file alike.
void OffReader::add_colours() {
  const bool bytes = std::any_of(colours_.begin(), colours_.end(),
                                 [](const Vec3& colour) { return colour.maxCoeff() > 1.0; });
  for (const Vec3& colour : colours_) {
    builder_.add_colour(colour.x(), colour.y(), colour.z(), bytes ? 1.0 : 255.0);
  }
}

void OffReader::read_faces() {
  builder_.mesh().triangles.reserve(faces_);
  std::array<std::int64_t, MeshBuilder::kMostCorners> face{};
  for (std::uint64_t row = 0; row < faces_; ++row) {
    expect_row("faces", row, faces_);
    const std::int64_t count = whole("count of corners");
    if (count < 0) fail("a face has a negative count of corners; export the file again");
    if (count > std::int64_t{face.size()}) {
      builder_.refuse_corners(static_cast<std::uint64_t>(count), place());
    }
    for (std::int64_t i = 0; i < count; ++i) face[i] = whole("face corner");
    // A colour may follow.
    while (!fields_.at_end()) number();
    builder_.add_face({face.data(), static_cast<std::size_t>(count)}, place());
  }
}

void OffReader::read() {
  read_keyword();
  read_counts();
  read_vertices();
  add_colours();
  read_faces();
  if (next_row()) fail("more rows than the counts announce; export the file again");
}

}  // namespace

void read_off(std::string_view file, MeshBuilder& builder) { OffReader(file, builder).read(); }

}  // namespace regarment
