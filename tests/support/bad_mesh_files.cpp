#include "support/bad_files.h"
#include "support/gltf_maker.h"
#include "support/stl_maker.h"

namespace regarment::test {
namespace {

const std::string kThree = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

GltfMaker triangle(const std::string& node = "\"mesh\":0",
                   const std::vector<std::uint16_t>& indices = {0, 1, 2}) {
  GltfMaker maker;
  maker.mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, indices);
  maker.node(node);
  return maker;
}

std::string replaced(std::string text, const std::string& what, const std::string& with) {
  return text.replace(text.find(what), what.size(), with);
}

}  // namespace

void add_bad_text_meshes(std::vector<BadFile>& files) {
  const auto obj = [&](const char* title, const char* says, const std::string& text) {
    files.push_back({title, "scan.obj", [text] { return text; }, says});
  };
  obj("OBJ index past the end", "line 4: face 0 names vertex 4 (counted from 1), the file has 3",
      kThree + "f 1 2 4\n");
  obj("OBJ index zero", "line 4: the face corner '0' names no vertex: OBJ counts from 1",
      kThree + "f 0 1 2\n");
  obj("OBJ index too far back", "only 3 stand before it", kThree + "f -4 -2 -1\n");
  obj("OBJ index of 2^70", "'1180591620717411303424' is not of the form",
      kThree + "f 1180591620717411303424 1 2\n");
  obj("OBJ corner of nonsense", "'1/x/2' is not of the form", kThree + "f 1/x/2 2 3\n");
  obj("OBJ vertex of two numbers", "line 1: a vertex has x y z", "v 1 2\n");
  obj("OBJ vertex of words", "line 1: 'a' is not a number", "v a b c\n");
  obj("OBJ vertex nan", "line 2: vertex 1 has a coordinate that is not a finite",
      "v 0 0 0\nv nan 0 0\n");
  obj("OBJ vertex 1e400", "'1e400' is too large", "v 0 0 1e400\n");
  obj("OBJ without vertices", "holds no vertices", "# nothing\ng none\n");
  obj("OBJ that is a letter", "line 1: 'Dear' is no OBJ statement",
      "Dear Madam,\nwith best wishes\n");
  obj("OBJ of zero bytes in a row", "is no OBJ statement", std::string(1000, '\0'));
  obj("OBJ with CR alone", "end with CR alone", "v 0 0 0\rv 1 0 0\rv 0 1 0\r");
  std::string many = "f";
  for (int i = 0; i < 200'000; ++i) many += " 1";
  obj("OBJ face of 200,000 corners", "face 0 has 200000 corners", kThree + many + "\n");

  const auto off = [&](const char* title, const char* says, const std::string& text) {
    files.push_back({title, "scan.off", [text] { return text; }, says});
  };
  const std::string points = "0 0 0\n1 0 0\n0 1 0\n";
  off("OFF with counts past the file", "do not fit into the", "OFF\n2000000 2000000 0\n" + points);
  off("OFF with a negative count", "negative count", "OFF\n-3 0 0\n" + points);
  off("OFF with counts past all limits", "more than the", "OFF\n2000000000 1 0\n" + points);
  off("OFF without counts", "counts of vertices and faces are missing", "OFF\n# nothing\n");
  off("OFF with a word as count", "count of vertices: 'three' is not a number", "OFF\nthree 0 0\n");
  off("OFF cut off in its vertices", "ends after 2 of 3 vertices",
      "OFF\n3 0 0\n0.125 0.125 0.125\n0.5 0.5 0.5\n");
  off("OFF cut off in its faces", "ends after 1 of 2 faces", "OFF\n3 2 0\n" + points + "3 0 1 2\n");
  off("OFF index past the end", "face 0 names vertex 3", "OFF\n3 1 0\n" + points + "3 0 1 3\n");
  off("OFF face shorter than it says", "face corner: a number is missing",
      "OFF\n3 1 0\n" + points + "4 0 1 2\n");
  off("OFF face of 2^31 corners", "face 0 has 2147483648 corners",
      "OFF\n3 1 0\n" + points + "2147483648 0 1 2\n");
  off("OFF with more rows than counted", "more rows than the counts", "OFF\n2 0 0\n" + points);
  off("OFF in four dimensions", "other than 3 dimensions", "4OFF\n1 0 0\n1 2 3 4\n");
  off("OFF in binary", "binary OFF is not read", "OFF BINARY\n" + std::string(12, '\0'));
  off("OFF without its first word", "must begin with the word OFF", "3 0 0\n" + points);
}

void add_bad_other_meshes(std::vector<BadFile>& files) {
  const auto add = [&](const char* title, const char* name, const char* says, std::string bytes) {
    files.push_back({title, name, [bytes = std::move(bytes)] { return bytes; }, says});
  };
  const std::string stl = binary_stl({Facet{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}, Facet{}});
  add("STL cut off", "scan.stl", "byte 80: 2 facets take 184 bytes, the file has 154",
      stl.substr(0, stl.size() - 30));
  add("STL that promises 2^32 facets", "scan.stl", "byte 80: 4294967295 facets take 214748364834",
      stl.substr(0, 80) + std::string(4, '\xff') + stl.substr(84));
  add("STL without facets", "scan.stl", "holds no vertices", binary_stl({}));
  add("STL with a coordinate that is no number", "scan.stl",
      "byte 84: vertex 1 has a coordinate that is not a finite number",
      binary_stl({Facet{{{0, 0, 0}, {std::numeric_limits<float>::quiet_NaN(), 0, 0}, {0, 1, 0}}}}));
  const std::string facet =
      "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 "
      "0\nendloop\nendfacet\n";
  add("STL text cut off in a facet", "scan.stl", "line 6: the file ends within a facet",
      "solid a\n" + facet.substr(0, facet.find("endloop")));
  add("STL text cut off after a facet", "scan.stl", "line 8: the file ends without endsolid",
      "solid a\n" + facet);
  add("STL text with junk between facets", "scan.stl",
      "line 9: 'junk' stands where facet or endsolid",
      "solid a\n" + facet + "junk\n" + facet + "endsolid a\n");
  add("STL text with four corners", "scan.stl", "line 7: 'vertex' stands where endloop is due",
      "solid a\n" + replaced(facet, "endloop", "vertex 5 5 5\nendloop") + "endsolid a\n");
  add("STL text with words for numbers", "scan.stl", "line 5: 'one' is not a number",
      "solid a\n" + replaced(facet, "1 0 0", "one 0 0") + "endsolid a\n");

  const std::string passwd = triangle().json("0", "/etc/passwd");
  add("glTF that reads /etc/passwd", "scan.gltf", "another file, which is never opened", passwd);
  add("glTF that climbs out of its folder", "scan.gltf", "another file, which is never opened",
      triangle().json("0", "../../../../etc/passwd"));
  add("glTF with a file address", "scan.gltf",
      "scan.gltf: ", triangle().json("0", "file:///etc/passwd"));
  add("glTF with a web address", "scan.gltf",
      "scan.gltf: ", triangle().json("0", "http://127.0.0.1/a.bin"));
  add("glTF whose nodes form a ring", "scan.gltf",
      "scan.gltf: ", triangle("\"mesh\":0,\"children\":[0]").gltf("0"));
  add("glTF with an index past the end", "scan.glb",
      "scan.glb: ", triangle("\"mesh\":0", {0, 1, 9}).glb("0"));
  add("glTF with a huge count", "scan.gltf",
      "scan.gltf: ", replaced(triangle().gltf("0"), "\"count\":3", "\"count\":2000000000"));
  add("glTF with a huge buffer", "scan.gltf", "scan.gltf: ",
      replaced(triangle().gltf("0"), "\"byteLength\":36", "\"byteLength\":4000000000"));
  add("glTF with a scene that is not there", "scan.gltf",
      "scan.gltf: ", replaced(triangle().gltf("0"), "\"scene\":0", "\"scene\":7"));
  add("glTF that is broken JSON", "scan.gltf", "scan.gltf: ", "{\"asset\":{\"version\":\"2.0\"");
  add("glTF of 100,000 brackets", "scan.gltf",
      "scan.gltf: ", "{\"asset\":" + std::string(100'000, '['));
  add("glTF without a mesh", "scan.gltf",
      "scan.gltf: ", "{\"asset\":{\"version\":\"2.0\"},\"scene\":0,\"scenes\":[{\"nodes\":[]}]}");
  add("glTF compressed by Draco", "scan.gltf", "geometry is compressed",
      replaced(triangle().gltf("0"), "{\"asset\"",
               "{\"extensionsRequired\":[\"KHR_draco_mesh_compression\"],\"asset\""));
  const std::string glb = triangle().glb("0");
  add("GLB cut off", "scan.glb", "scan.glb: ", glb.substr(0, glb.size() / 2));
  add("GLB of twelve bytes", "scan.glb", "scan.glb: ", glb.substr(0, 12));
}

}  // namespace regarment::test
