#include "support/bad_files.h"
#include "support/ply_maker.h"

namespace regarment::test {
namespace {

const std::string kXyz = "property float x\nproperty float y\nproperty float z\n";
const std::string kFaces = "property list uchar int vertex_indices\n";

std::string ascii(const std::string& header, const std::string& body) {
  return "ply\nformat ascii 1.0\n" + header + "end_header\n" + body;
}

// A text file with three good vertices and whatever faces are given.
std::string with_faces(int count, const std::string& rows) {
  return ascii(
      "element vertex 3\n" + kXyz + "element face " + std::to_string(count) + "\n" + kFaces,
      "0 0 0\n1 0 0\n0 1 0\n" + rows);
}

// A text file with three vertices of which the second is given.
std::string with_vertex(const std::string& row) {
  return ascii("element vertex 3\n" + kXyz, "0.0 0.0 0.0\n" + row + "\n0.0 1.0 0.0\n");
}

std::string binary(const std::string& header, const std::string& body) {
  return "ply\nformat binary_little_endian 1.0\n" + header + "end_header\n" + body;
}

// A binary file with three vertices and one face with this many corners, as far as `corners` go.
std::string binary_face(const std::string& count_type, double count,
                        const std::vector<int>& corners) {
  PlyMaker ply(PlyForm::Little);
  ply.header("element vertex 3");
  for (const char* axis : {"x", "y", "z"}) ply.header(std::string("property float ") + axis);
  ply.header("element face 1").header("property list " + count_type + " int vertex_indices");
  ply.header("end_header");
  for (int i = 0; i < 9; ++i) ply.value("float", i);
  ply.value(count_type, count);
  for (const int corner : corners) ply.value("int", corner);
  return ply.text();
}

std::string bytes_of(float value) { return {reinterpret_cast<const char*>(&value), sizeof value}; }

std::string polygon(std::size_t corners) {
  std::string row = std::to_string(corners);
  for (std::size_t i = 0; i < corners; ++i) row += " " + std::to_string(i % 3);
  return row + "\n";
}

}  // namespace

void add_bad_ply_headers(std::vector<BadFile>& files) {
  const auto add = [&](const char* title, const char* says, auto&& make) {
    files.push_back({title, "scan.ply", make, says});
  };
  add("62 bytes without end_header", "ends before end_header", [] {
    return std::string("ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\ncomment");
  });
  add("header cut in the middle of a word", "ends before end_header",
      [] { return std::string("ply\nformat ascii 1.0\nelement ver"); });
  add("nothing but the first line", "ends before end_header", [] { return std::string("ply\n"); });
  add("header over 64 KiB", "no end_header within 64 KiB", [] {
    std::string header;
    while (header.size() < 70'000) header += "comment nothing to see here\n";
    return ascii(header + "element vertex 1\n" + kXyz, "0 0 0\n");
  });
  add("one header line of a megabyte", "no end_header within 64 KiB", [] {
    std::string header = "ply\nformat ascii 1.0\ncomment ";
    return header.append(1'000'000, 'x');
  });
  add("count of two thousand million", "more than the",
      [] { return binary("element vertex 2000000000\n" + kXyz, ""); });
  add("count past 64 bits", "'99999999999999999999' is too large",
      [] { return ascii("element vertex 99999999999999999999\n" + kXyz, ""); });
  add("negative count", "negative count", [] { return ascii("element vertex -3\n" + kXyz, ""); });
  add("count that is a word", "'many' is not a number",
      [] { return ascii("element vertex many\n" + kXyz, ""); });
  add("count missing", "a number is missing", [] { return ascii("element vertex\n" + kXyz, ""); });
  add("vertex element twice", "stands twice (first on line 3)", [] {
    return ascii("element vertex 1\n" + kXyz + "element vertex 1\n" + kXyz, "0 0 0\n0 0 0\n");
  });
  add("no vertex element", "no vertex element",
      [] { return ascii("element face 1\n" + kFaces, "3 0 1 2\n"); });
  add("no property x", "no property 'x'",
      [] { return ascii("element vertex 1\nproperty float y\nproperty float z\n", "0 0\n"); });
  add("x is a list", "'x' is a list", [] {
    return ascii(
        "element vertex 1\nproperty list uchar float x\nproperty float y\nproperty float z\n",
        "1 0 0 0\n");
  });
  add("property twice", "'x' stands twice",
      [] { return ascii("element vertex 1\n" + kXyz + "property float x\n", "0 0 0 0\n"); });
  add("property before any element", "line 3: a property before any element",
      [] { return ascii("property float x\n", ""); });
  add("unknown type", "'float16' is not a type",
      [] { return ascii("element vertex 1\nproperty float16 x\n", "0\n"); });
  add("list length of floating type", "floating-point length", [] {
    return ascii("element vertex 1\n" + kXyz + "property list float int k\n", "0 0 0 0\n");
  });
  add("faces without a list", "no list of whole numbers 'vertex_indices'", [] {
    return ascii("element vertex 1\n" + kXyz + "element face 1\nproperty int a\n", "0 0 0\n0\n");
  });
  add("element without properties", "has no properties",
      [] { return ascii("element vertex 1\n" + kXyz + "element thing 2000000000\n", "0 0 0\n"); });
  add("triangle strips", "triangle strips are not read", [] {
    return ascii("element vertex 1\n" + kXyz + "element tristrips 1\n" + kFaces, "0 0 0\n1 0\n");
  });
  add("no format line", "no format line",
      [] { return "ply\nelement vertex 1\n" + kXyz + "end_header\n0 0 0\n"; });
  add("unknown format", "format 'binary' is not known",
      [] { return "ply\nformat binary 1.0\nelement vertex 1\n" + kXyz + "end_header\n0 0 0\n"; });
  add("unknown version", "version '2.0'",
      [] { return "ply\nformat ascii 2.0\nelement vertex 1\n" + kXyz + "end_header\n0 0 0\n"; });
  add("unknown keyword", "line 3: 'elements' is no keyword",
      [] { return ascii("elements vertex 1\n" + kXyz, "0 0 0\n"); });
  add("control characters in a keyword", "\\x1b[31mred\\x07",
      [] { return ascii("\x1b[31mred\x07 1\n", ""); });
  add("lines that end with CR alone", "end with CR alone", [] {
    std::string text = ascii("element vertex 1\n" + kXyz, "0 0 0\n");
    for (char& c : text) c = c == '\n' ? '\r' : c;
    return text;
  });
  add("no vertices", "holds no vertices", [] { return ascii("element vertex 0\n" + kXyz, ""); });
}

void add_bad_ply_bodies(std::vector<BadFile>& files) {
  const auto add = [&](const char* title, const char* says, auto&& make) {
    files.push_back({title, "scan.ply", make, says});
  };
  add("ten vertices promised, four there", "take at least 12 bytes each, but 48 follow",
      [] { return binary("element vertex 10\n" + kXyz, std::string(48, '\0')); });
  add("a million text rows promised, none there", "do not fit into the 0 bytes that follow",
      [] { return ascii("element vertex 1000000\n" + kXyz, ""); });
  add("text rows cut off", "line 9: the file ends after 2 of 3 rows",
      [] { return ascii("element vertex 3\n" + kXyz, "0.125 0.125 0.125\n1.5 1.5 1.5\n"); });
  add("text row cut short", "line 9: a number is missing", [] { return with_vertex("1 2"); });
  add("text row too long", "line 9: more values", [] { return with_vertex("1 2 3 4"); });
  add("a word for a number", "line 9: 'abc' is not a number",
      [] { return with_vertex("1 abc 3"); });
  add("decimal commas", "line 9: '1,5' is not a number", [] { return with_vertex("1,5 2,5 3,5"); });
  add("text coordinate 1e400", "line 9: '1e400' is too large",
      [] { return with_vertex("1 1e400 3"); });
  add("text coordinate nan", "line 9: vertex 1 has a coordinate that is not a finite number",
      [] { return with_vertex("nan 0 0"); });
  add("text coordinate inf", "line 9: vertex 1 has a coordinate that is not a finite number",
      [] { return with_vertex("0 -inf 0"); });
  add("vertex beyond all distance", "more than 1e12 from the origin",
      [] { return with_vertex("0 0 1e300"); });
  add("binary coordinate nan", "vertex 1 has a coordinate that is not a finite number", [] {
    return binary("element vertex 2\n" + kXyz,
                  std::string(12, '\0') + bytes_of(std::numeric_limits<float>::quiet_NaN()) +
                      std::string(8, '\0'));
  });
  add("face index past the end", "face 1 names vertex 3 (counted from 0), the file has 3",
      [] { return with_faces(2, "3 0 1 2\n3 0 1 3\n"); });
  add("face index negative", "face 0 names vertex -1", [] { return with_faces(1, "3 0 1 -1\n"); });
  add("face index of 2^40", "face 0 names vertex 1099511627776",
      [] { return with_faces(1, "3 0 1 1099511627776\n"); });
  add("face index with a fraction", "'1.5' is not a number",
      [] { return with_faces(1, "3 0 1 1.5\n"); });
  add("binary face index past the end", "face 0 names vertex 77", [] {
    return binary_face("uchar", 3, {0, 1, 77});
  });
  add("binary face index negative", "face 0 names vertex -5", [] {
    return binary_face("uchar", 3, {0, 1, -5});
  });
  add("list length of 2^31", "face 0 has 2147483648 corners", [] {
    return binary_face("uint", 2147483648.0, {0, 1, 2});
  });
  add("list length negative", "negative length -3", [] {
    return binary_face("char", -3, {0, 1, 2});
  });
  add("text list length negative", "negative length -3",
      [] { return with_faces(1, "-3 0 1 2\n"); });
  add("list longer than the file", "the file ends within this row", [] {
    return binary_face("uchar", 4, {0, 1, 2});
  });
  add("unknown list longer than the file", "the file ends within this row", [] {
    return binary("element vertex 1\n" + kXyz + "property list uint double k\n",
                  std::string(12, '\0') + std::string(4, '\xff'));
  });
  add("face of 200,000 corners", "face 0 has 200000 corners, at most 64",
      [] { return with_faces(1, polygon(200'000)); });
  add("face of 65 corners", "face 0 has 65 corners, at most 64",
      [] { return with_faces(1, polygon(65)); });
  add("bytes after the last element", "byte 128: 4 bytes follow the last element",
      [] { return binary("element vertex 1\n" + kXyz, std::string(12, '\0') + "\njunk"); });
  add("rows after the last element", "line 9: more rows than the header declares",
      [] { return ascii("element vertex 1\n" + kXyz, "0 0 0\n1 1 1\n"); });
  add("binary body read as text", "is not a number",
      [] { return ascii("element vertex 1\n" + kXyz, std::string(64, '\x80')); });
}

}  // namespace regarment::test
