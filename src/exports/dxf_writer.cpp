#include "exports/dxf_writer.h"

#include <array>
#include <cstdio>

namespace regarment {
namespace {

void pair(std::string& out, int code, std::string_view value) {
  char buffer[8];
  std::snprintf(buffer, sizeof buffer, "%3d", code);
  out.append(buffer).append("\r\n").append(value).append("\r\n");
}

void number(std::string& out, int code, double value) {
  char buffer[64];
  std::snprintf(buffer, sizeof buffer, "%.6f", value);
  const std::string_view text = buffer;
  pair(out, code, text == "-0.000000" ? "0.000000" : text);
}

void whole(std::string& out, int code, int value) { pair(out, code, std::to_string(value)); }

void position(std::string& out, int code, const Vec2& p) {
  number(out, code, p.x());
  number(out, code + 10, p.y());
}

void entity(std::string& out, std::string_view kind, std::string_view layer) {
  pair(out, 0, kind);
  pair(out, 8, layer);
}

std::string ascii(std::string_view text) {
  std::string out;
  for (const char c : text) out += c >= ' ' && c <= '~' ? c : '?';
  return out;
}

void begin_section(std::string& out, std::string_view name) {
  pair(out, 0, "SECTION");
  pair(out, 2, name);
}

void end_section(std::string& out) { pair(out, 0, "ENDSEC"); }

void header(std::string& out, const Vec2& low, const Vec2& high) {
  begin_section(out, "HEADER");
  pair(out, 9, "$ACADVER");
  pair(out, 1, "AC1009");
  pair(out, 9, "$EXTMIN");
  position(out, 10, low);
  number(out, 30, 0.0);
  pair(out, 9, "$EXTMAX");
  position(out, 10, high);
  number(out, 30, 0.0);
  end_section(out);
}

void begin_table(std::string& out, std::string_view name, int entries) {
  pair(out, 0, "TABLE");
  pair(out, 2, name);
  whole(out, 70, entries);
}

void line_types(std::string& out) {
  begin_table(out, "LTYPE", 1);
  pair(out, 0, "LTYPE");
  pair(out, 2, "CONTINUOUS");
  whole(out, 70, 64);
  pair(out, 3, "Solid line");
  whole(out, 72, 65);
  whole(out, 73, 0);
  number(out, 40, 0.0);
  pair(out, 0, "ENDTAB");
}

void layer_table(std::string& out, const std::vector<std::string>& layers) {
  begin_table(out, "LAYER", static_cast<int>(layers.size()));
  int colour = 0;
  for (const std::string& layer : layers) {
    pair(out, 0, "LAYER");
    pair(out, 2, layer);
    whole(out, 70, 64);
    whole(out, 62, 1 + colour++ % 7);
    pair(out, 6, "CONTINUOUS");
  }
  pair(out, 0, "ENDTAB");
}

void text_styles(std::string& out) {
  begin_table(out, "STYLE", 1);
  pair(out, 0, "STYLE");
  pair(out, 2, "STANDARD");
  whole(out, 70, 64);
  number(out, 40, 0.0);
  number(out, 41, 1.0);
  number(out, 50, 0.0);
  whole(out, 71, 0);
  number(out, 42, 1.0);
  pair(out, 3, "txt");
  pair(out, 4, "");
  pair(out, 0, "ENDTAB");
}

}  // namespace

void DxfWriter::begin_block(std::string_view name) {
  in_block_ = true;
  entity(blocks_, "BLOCK", "0");
  pair(blocks_, 2, name);
  whole(blocks_, 70, 0);
  position(blocks_, 10, Vec2::Zero());
  number(blocks_, 30, 0.0);
  pair(blocks_, 3, name);
}

void DxfWriter::end_block() {
  entity(blocks_, "ENDBLK", "0");
  in_block_ = false;
}

void DxfWriter::insert(std::string_view block, const Vec2& at) {
  entity(entities_, "INSERT", "1");
  pair(entities_, 2, block);
  position(entities_, 10, at);
}

void DxfWriter::line(std::string_view layer, const Vec2& a, const Vec2& b) {
  entity(target(), "LINE", layer);
  position(target(), 10, a);
  position(target(), 11, b);
}

void DxfWriter::polyline(std::string_view layer, const std::vector<Vec2>& points, bool closed) {
  std::string& out = target();
  entity(out, "POLYLINE", layer);
  whole(out, 66, 1);
  position(out, 10, Vec2::Zero());
  number(out, 30, 0.0);
  whole(out, 70, closed ? 1 : 0);
  for (const Vec2& p : points) {
    entity(out, "VERTEX", layer);
    position(out, 10, p);
    number(out, 30, 0.0);
  }
  entity(out, "SEQEND", layer);
}

void DxfWriter::point(std::string_view layer, const Vec2& at) {
  entity(target(), "POINT", layer);
  position(target(), 10, at);
}

void DxfWriter::notch(std::string_view layer, const Vec2& at, double degrees, double depth) {
  point(layer, at);
  number(target(), 39, depth);
  number(target(), 50, degrees);
}

void DxfWriter::text(std::string_view layer, const Vec2& at, double height, std::string_view text) {
  entity(target(), "TEXT", layer);
  position(target(), 10, at);
  number(target(), 40, height);
  pair(target(), 1, ascii(text));
}

std::string DxfWriter::bytes(const Vec2& low, const Vec2& high) const {
  std::string out;
  header(out, low, high);
  begin_section(out, "TABLES");
  line_types(out);
  layer_table(out, layers_);
  text_styles(out);
  end_section(out);
  begin_section(out, "BLOCKS");
  out += blocks_;
  end_section(out);
  begin_section(out, "ENTITIES");
  out += entities_;
  end_section(out);
  pair(out, 0, "EOF");
  return out;
}

}  // namespace regarment
