#include "exports/garment_obj.h"

#include <cstdio>

#include "base/error.h"
#include "garment/particles.h"

namespace regarment {
namespace {

void put_position(std::string& out, const Vec3& p) {
  char buffer[96];
  std::snprintf(buffer, sizeof buffer, "v %.6f %.6f %.6f\n", p.x(), p.y(), p.z());
  out += buffer;
}

void put_coordinates(std::string& out, const Vec2& flat) {
  char buffer[96];
  std::snprintf(buffer, sizeof buffer, "vt %.6f %.6f\n", flat.x(), -flat.y());
  out += buffer;
}

void put_corner(std::string& out, int particle, std::uint32_t vertex) {
  out += ' ' + std::to_string(particle + 1) + '/' + std::to_string(vertex + 1);
}

}  // namespace

std::string garment_obj(const DressedGarment& garment) {
  const Pattern& pattern = garment.pattern;
  if (garment.draped.size() != pattern.flat.size())
    throw InvalidInput("a garment needs one draped position per vertex of its pattern");
  std::string out =
      "# metres, y up; vt: flat coordinates in metres, (s, -t)\no " + garment.name + "\n";
  for (const Vec3& p : particle_positions(pattern, garment.draped)) put_position(out, p);
  for (const Vec2& flat : pattern.flat) put_coordinates(out, flat);
  for (std::size_t panel = 0; panel < pattern.panel_names.size(); ++panel) {
    out += "g " + pattern.panel_names[panel] + '\n';
    for (const Triangle& t : pattern.triangles) {
      if (static_cast<std::size_t>(pattern.panel[t[0]]) != panel) continue;
      out += 'f';
      for (const std::uint32_t v : t) put_corner(out, pattern.particle[v], v);
      out += '\n';
    }
  }
  return out;
}

}  // namespace regarment
