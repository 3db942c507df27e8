#include "geometry/ply_header.h"

#include <algorithm>
#include <array>
#include <optional>

#include "base/one_line.h"
#include "geometry/text_lines.h"

namespace regarment {
namespace {

constexpr std::size_t kMostHeaderBytes = std::size_t{64} << 10U;

std::string in_quotes(std::string_view word) { return "'" + one_line(word, 40) + "'"; }

std::optional<PlyScalar> scalar_named(std::string_view name) {
  struct Name {
    std::string_view name;
    PlyScalar scalar;
  };
  static constexpr std::array<Name, 16> kNames{{{"char", PlyScalar::Int8},
                                                {"int8", PlyScalar::Int8},
                                                {"uchar", PlyScalar::Uint8},
                                                {"uint8", PlyScalar::Uint8},
                                                {"short", PlyScalar::Int16},
                                                {"int16", PlyScalar::Int16},
                                                {"ushort", PlyScalar::Uint16},
                                                {"uint16", PlyScalar::Uint16},
                                                {"int", PlyScalar::Int32},
                                                {"int32", PlyScalar::Int32},
                                                {"uint", PlyScalar::Uint32},
                                                {"uint32", PlyScalar::Uint32},
                                                {"float", PlyScalar::Float32},
                                                {"float32", PlyScalar::Float32},
                                                {"double", PlyScalar::Float64},
                                                {"float64", PlyScalar::Float64}}};
  const auto* const found = std::find_if(kNames.begin(), kNames.end(),
                                         [&](const Name& known) { return known.name == name; });
  return found == kNames.end() ? std::nullopt : std::optional(found->scalar);
}

// Reads the header line by line; one method per keyword.
class HeaderParser {
 public:
  HeaderParser(std::string_view file, const MeshBuilder& builder)
      : file_(file), lines_(file.substr(0, kMostHeaderBytes)), builder_(builder) {}

  PlyHeader parse();

 private:
  [[noreturn]] void fail(const std::string& words) const {
    builder_.fail({Place::Unit::Line, lines_.number()}, words);
  }
  [[noreturn]] void fail_without_end() const;
  void read_format(Fields fields);
  void read_element(Fields fields);
  void read_property(Fields fields);
  PlyScalar read_scalar(Fields& fields) const;
  void expect_end(Fields& fields) const;
  void check_elements() const;

  std::string_view file_;
  LineReader lines_;
  const MeshBuilder& builder_;
  PlyHeader header_;
  bool has_format_ = false;
};

void HeaderParser::fail_without_end() const {
  if (file_.size() > kMostHeaderBytes) {
    fail("the header has no end_header within 64 KiB; this is no PLY file a program should read");
  }
  fail("the file ends before end_header; it is cut off, export it again");
}

void HeaderParser::expect_end(Fields& fields) const {
  if (fields.at_end()) return;
  fail(in_quotes(fields.word()) + " does not belong on this header line; export the file again");
}

void HeaderParser::read_format(Fields fields) {
  if (has_format_) fail("a second format line; export the file again");
  has_format_ = true;
  const std::string_view encoding = fields.word();
  if (encoding == "ascii") {
    header_.encoding = PlyEncoding::Ascii;
  } else if (encoding == "binary_little_endian") {
    header_.encoding = PlyEncoding::LittleEndian;
  } else if (encoding == "binary_big_endian") {
    header_.encoding = PlyEncoding::BigEndian;
  } else {
    fail("format " + in_quotes(encoding) +
         " is not known; use ascii, binary_little_endian or binary_big_endian");
  }
  const std::string_view version = fields.word();
  if (version != "1.0") fail("version " + in_quotes(version) + " of PLY is not known; use 1.0");
  expect_end(fields);
}

void HeaderParser::read_element(Fields fields) {
  PlyElement element;
  element.name = fields.word();
  element.line = lines_.number();
  Fields again = fields;
  std::int64_t count = 0;
  const Fields::Outcome outcome = fields.whole(count);
  if (element.name.empty() || outcome != Fields::Outcome::Ok) {
    fail("the count of element " + in_quotes(element.name) + ": " +
         describe(outcome, again.word()) + "; export the file again");
  }
  if (count < 0) {
    fail("element " + in_quotes(element.name) + " has a negative count; export the file again");
  }
  expect_end(fields);
  element.count = static_cast<std::uint64_t>(count);
  for (const PlyElement& other : header_.elements) {
    if (other.name == element.name) {
      fail("element " + in_quotes(element.name) + " stands twice (first on line " +
           std::to_string(other.line) + "); export the file again");
    }
  }
  header_.elements.push_back(std::move(element));
}

PlyScalar HeaderParser::read_scalar(Fields& fields) const {
  const std::string_view word = fields.word();
  const std::optional<PlyScalar> scalar = scalar_named(word);
  if (!scalar)
    fail(in_quotes(word) + " is not a type of PLY; use char to double or int8 to float64");
  return *scalar;
}

void HeaderParser::read_property(Fields fields) {
  if (header_.elements.empty()) fail("a property before any element; export the file again");
  PlyProperty property;
  Fields ahead = fields;
  if (ahead.word() == "list") {
    fields = ahead;
    property.is_list = true;
    property.count_type = read_scalar(fields);
    if (is_floating(property.count_type)) {
      fail("a list cannot have a floating-point length; export the file again");
    }
  }
  property.type = read_scalar(fields);
  property.name = fields.word();
  if (property.name.empty()) fail("a property without a name; export the file again");
  expect_end(fields);
  for (const PlyProperty& other : header_.elements.back().properties) {
    if (other.name == property.name) {
      fail("property " + in_quotes(property.name) + " stands twice; export the file again");
    }
  }
  header_.elements.back().properties.push_back(std::move(property));
}

void HeaderParser::check_elements() const {
  bool has_vertices = false;
  for (const PlyElement& element : header_.elements) {
    const Place place{Place::Unit::Line, element.line};
    if (element.name == "vertex") {
      has_vertices = true;
      builder_.check_vertex_count(element.count, place);
    } else if (element.name == "face") {
      builder_.check_face_count(element.count, place);
    } else if (element.name == "tristrips") {
      builder_.fail(place, "triangle strips are not read; save the mesh with a face list");
    }
    if (element.count > 0 && element.properties.empty()) {
      builder_.fail(place, "element " + in_quotes(element.name) +
                               " has no properties; export the file again");
    }
  }
  if (!has_vertices) fail("the header has no vertex element; this PLY file holds no scan");
}

PlyHeader HeaderParser::parse() {
  if (!lines_.next() || lines_.line() != "ply") fail("a PLY file must begin with the line 'ply'");
  while (lines_.next()) {
    // A line that the text's end cut short is no line.
    if (lines_.rest().empty() && !file_.substr(0, kMostHeaderBytes).ends_with('\n')) break;
    Fields fields(lines_.line());
    const std::string_view keyword = fields.word();
    if (keyword == "format") {
      read_format(fields);
    } else if (keyword == "element") {
      read_element(fields);
    } else if (keyword == "property") {
      read_property(fields);
    } else if (keyword == "end_header") {
      expect_end(fields);
      if (!has_format_) fail("the header has no format line; export the file again");
      check_elements();
      header_.lines = lines_.number();
      header_.bytes = static_cast<std::size_t>(lines_.rest().data() - file_.data());
      return std::move(header_);
    } else if (keyword != "comment" && keyword != "obj_info" && !keyword.empty()) {
      fail(in_quotes(keyword) + " is no keyword of a PLY header; export the file again");
    }
  }
  fail_without_end();
}

}  // namespace

PlyHeader parse_ply_header(std::string_view file, const MeshBuilder& builder) {
  return HeaderParser(file, builder).parse();
}

}  // namespace regarment
