#include <algorithm>
#include <array>
#include <charconv>

#include "base/one_line.h"
#include "geometry/mesh_readers.h"
#include "geometry/text_lines.h"

namespace regarment {
namespace {

// Statements that change no vertex and no face. What they name (materials, other files) stays shut.
constexpr std::array<std::string_view, 38> kPassedOver{
    "vt",         "vp",        "p",      "l",      "g",     "s",        "mg",       "o",
    "mtllib",     "usemtl",    "maplib", "usemap", "bevel", "c_interp", "d_interp", "lod",
    "cstype",     "deg",       "bmat",   "step",   "curv",  "curv2",    "surf",     "parm",
    "trim",       "hole",      "scrv",   "sp",     "end",   "con",      "ctech",    "stech",
    "shadow_obj", "trace_obj", "call",   "csh",    "bzp",   "bsp"};

class ObjReader {
 public:
  ObjReader(std::string_view file, MeshBuilder& builder) : lines_(file), builder_(builder) {}
  void read();

 private:
  [[noreturn]] void fail(const std::string& words) const { builder_.fail(place_, words); }
  std::string_view joined_line();
  void read_statement(std::string_view line);
  void read_vertex(Fields fields);
  void read_normal(Fields fields);
  void read_face(Fields fields);
  std::int64_t read_corner(std::string_view field);
  std::int64_t resolve(std::int64_t index, std::size_t count, std::string_view field) const;
  double number(Fields& fields) const;

  LineReader lines_;
  MeshBuilder& builder_;
  Place place_;
  std::string joined_;
  std::vector<Vec3> normals_;
  // Normals are taken over only when corner and normal always have the same index.
  bool normals_match_ = true;
};

// A statement goes on after a backslash at the end of its line; a comment does not, or a Windows
// path in it would swallow the next statement.
std::string_view ObjReader::joined_line() {
  if (!lines_.line().ends_with('\\') || lines_.line().starts_with('#')) return lines_.line();
  joined_.clear();
  do {
    joined_.append(lines_.line());
    joined_.back() = ' ';
  } while (lines_.next() && lines_.line().ends_with('\\'));
  if (!lines_.line().ends_with('\\')) joined_.append(lines_.line());
  return joined_;
}

double ObjReader::number(Fields& fields) const {
  double value = 0;
  Fields before = fields;
  const Fields::Outcome outcome = fields.number(value);
  if (outcome != Fields::Outcome::Ok) {
    fail(describe(outcome, before.word()) + "; export the file again");
  }
  return value;
}

// x y z, then nothing, a weight, a colour, or both.
void ObjReader::read_vertex(Fields fields) {
  std::array<double, 7> value{};
  std::size_t count = 0;
  while (count < value.size() && !fields.at_end()) value[count++] = number(fields);
  if (!fields.at_end() || count < 3 || count == 5) {
    fail(
        "a vertex has x y z and perhaps a colour, this one has another count of numbers; export it "
        "again");
  }
  builder_.check_vertex_count(builder_.mesh().positions.size() + 1, place_);
  builder_.add_vertex(value[0], value[1], value[2], place_);
  if (count >= 6) builder_.add_colour(value[count - 3], value[count - 2], value[count - 1], 255.0);
}

void ObjReader::read_normal(Fields fields) {
  const double x = number(fields), y = number(fields), z = number(fields);
  normals_.emplace_back(x, y, z);
}

std::int64_t ObjReader::resolve(std::int64_t index, std::size_t count,
                                std::string_view field) const {
  if (index > 0) return index - 1;
  const std::int64_t resolved = static_cast<std::int64_t>(count) + index;
  if (index == 0 || resolved < 0) {
    fail("the face corner '" + one_line(field, 40) + "' names no vertex: " +
         (index == 0 ? std::string("OBJ counts from 1")
                     : "only " + std::to_string(count) + " stand before it") +
         "; export the mesh again");
  }
  return resolved;
}

// "v", "v/vt", "v//vn" or "v/vt/vn".
std::int64_t ObjReader::read_corner(std::string_view field) {
  std::array<std::int64_t, 3> index{};
  const char* at = field.data();
  const char* const end = at + field.size();
  for (std::size_t part = 0; part < index.size() && at != end; ++part) {
    const bool may_be_empty = part == 1 && *at == '/';
    if (!may_be_empty) {
      const auto [stop, error] = std::from_chars(at, end, index[part]);
      if (error != std::errc() || (part > 0 && index[part] == 0)) break;
      at = stop;
    }
    if (at == end) {
      const std::int64_t vertex = resolve(index[0], builder_.mesh().positions.size(), field);
      normals_match_ =
          normals_match_ && (part < 2 || resolve(index[2], normals_.size(), field) == vertex);
      return vertex;
    }
    if (*at++ != '/') break;
  }
  fail("the face corner '" + one_line(field, 40) +
       "' is not of the form v, v/vt, v//vn or v/vt/vn; export the mesh again");
}

void ObjReader::read_face(Fields fields) {
  std::array<std::int64_t, MeshBuilder::kMostCorners> face{};
  std::size_t count = 0;
  for (std::string_view field = fields.word(); !field.empty(); field = fields.word()) {
    if (count == face.size()) builder_.refuse_corners(count + 1 + fields.count_rest(), place_);
    face[count++] = read_corner(field);
  }
  builder_.add_face({face.data(), count}, place_);
}

void ObjReader::read_statement(std::string_view line) {
  Fields fields(line);
  const std::string_view keyword = fields.word();
  if (keyword == "v") {
    read_vertex(fields);
  } else if (keyword == "f") {
    read_face(fields);
  } else if (keyword == "vn") {
    read_normal(fields);
  } else if (!keyword.starts_with('#') &&
             std::find(kPassedOver.begin(), kPassedOver.end(), keyword) == kPassedOver.end()) {
    fail("'" + one_line(keyword, 40) + "' is no OBJ statement; is this an OBJ file?");
  }
}

void ObjReader::read() {
  builder_.count_from(1);
  while (lines_.next_filled()) {
    place_ = {Place::Unit::Line, lines_.number()};
    read_statement(joined_line());
  }
  if (normals_match_ && normals_.size() == builder_.mesh().positions.size()) {
    for (const Vec3& n : normals_) builder_.add_normal(n.x(), n.y(), n.z());
  }
}

}  // namespace

void read_obj(std::string_view file, MeshBuilder& builder) { ObjReader(file, builder).read(); }

}  // namespace regarment
