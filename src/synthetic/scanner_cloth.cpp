#include "synthetic/scanner_cloth.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <map>
#include <utility>

#include "base/error.h"
#include "scan/mesh_normals.h"

namespace regarment {
namespace {

// The middle of the cloth, cut where the band ends.
struct CutCloth {
  std::vector<Vec3> positions, normals;
  std::vector<Triangle> triangles;
  std::vector<std::uint32_t> source;  // triangle of the pattern
  std::vector<std::uint8_t> in_band;  // per triangle
};

// Cuts triangles along the line t = band of the panels. A point of an edge is made once for each
// pair of particles, so that the cut goes on over a seam.
class BandCut {
 public:
  BandCut(const WornGarment& garment, CutCloth& sheet) : garment_(garment), sheet_(sheet) {}

  void add(std::uint32_t t) {
    const Triangle& corners = garment_.pattern.triangles[t];
    int above = 0;
    for (const std::uint32_t v : corners) above += in_band(v);
    if (above == 0 || above == 3)
      return add({particle(corners[0]), particle(corners[1]), particle(corners[2])}, t, above == 3);
    int lone = 0;  // the corner on a side of its own
    while (in_band(corners[lone]) != (above == 1)) ++lone;
    const std::uint32_t a = corners[lone], b = corners[(lone + 1) % 3], c = corners[(lone + 2) % 3];
    const std::uint32_t ab = between(a, b), ca = between(a, c);
    add({particle(a), ab, ca}, t, above == 1);
    add({ab, particle(b), particle(c)}, t, above != 1);
    add({ab, particle(c), ca}, t, above != 1);
  }

 private:
  bool in_band(std::uint32_t vertex) const {
    return garment_.band > 0 && garment_.pattern.flat[vertex].y() < garment_.band;
  }
  std::uint32_t particle(std::uint32_t vertex) const {
    return static_cast<std::uint32_t>(garment_.pattern.particle[vertex]);
  }
  void add(const Triangle& corners, std::uint32_t source, bool band) {
    sheet_.triangles.push_back(corners);
    sheet_.source.push_back(source);
    sheet_.in_band.push_back(band ? 1 : 0);
  }
  std::uint32_t between(std::uint32_t a, std::uint32_t b) {
    const auto [low, high] = std::minmax({particle(a), particle(b)});
    const auto [found, made] =
        cuts_.try_emplace({low, high}, static_cast<std::uint32_t>(sheet_.positions.size()));
    if (made) {
      const double ta = garment_.pattern.flat[a].y(), tb = garment_.pattern.flat[b].y();
      const double share = (garment_.band - ta) / (tb - ta);
      sheet_.positions.push_back((1 - share) * garment_.particles[particle(a)] +
                                 share * garment_.particles[particle(b)]);
    }
    return found->second;
  }

  const WornGarment& garment_;
  CutCloth& sheet_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> cuts_;
};

CutCloth cut_cloth(const WornGarment& garment) {
  CutCloth sheet;
  sheet.positions = garment.particles;
  BandCut cut(garment, sheet);
  for (std::uint32_t t = 0; t < garment.pattern.triangles.size(); ++t) cut.add(t);
  sheet.normals = mesh_normals(sheet.positions, sheet.triangles);
  return sheet;
}

// Adds the triangles that lie in the band, or those that do not, as a closed slab.
void add_slab(const CutCloth& sheet, bool band, double half, std::uint8_t owner,
              ScannerScene& scene) {
  const auto outer = static_cast<std::uint32_t>(scene.positions.size());
  const auto inner = outer + static_cast<std::uint32_t>(sheet.positions.size());
  for (const double off : {half, -half})
    for (std::size_t v = 0; v < sheet.positions.size(); ++v)
      scene.positions.emplace_back(sheet.positions[v] + off * sheet.normals[v]);
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> open;  // edge to source
  const auto add = [&](const Triangle& corners, std::uint32_t source, bool inside) {
    scene.triangles.push_back(corners);
    scene.owner.push_back(owner);
    scene.source.push_back(source);
    scene.inner.push_back(inside ? 1 : 0);
  };
  for (std::size_t i = 0; i < sheet.triangles.size(); ++i) {
    if ((sheet.in_band[i] != 0) != band) continue;
    const Triangle& t = sheet.triangles[i];
    add({outer + t[0], outer + t[1], outer + t[2]}, sheet.source[i], false);
    add({inner + t[0], inner + t[2], inner + t[1]}, sheet.source[i], true);
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t a = t[k], b = t[(k + 1) % 3];
      if (open.erase({b, a}) == 0) open.emplace(std::pair{a, b}, sheet.source[i]);
    }
  }
  for (const auto& [edge, source] : open) {
    const auto [a, b] = edge;
    add({outer + b, outer + a, inner + a}, source, false);
    add({outer + b, inner + a, inner + b}, source, false);
  }
}

}  // namespace

void add_cloth(const WornGarment& garment, std::uint8_t owner, ScannerScene& scene) {
  if (garment.particles.size() != static_cast<std::size_t>(garment.pattern.particle_count))
    throw InvalidInput("garment " + garment.template_name + " has " +
                       std::to_string(garment.particles.size()) + " particles, its pattern has " +
                       std::to_string(garment.pattern.particle_count));
  for (const Vec3& p : garment.particles)
    if (!p.allFinite())
      throw InvalidInput("garment " + garment.template_name + " has a particle that is nowhere");
  const CutCloth sheet = cut_cloth(garment);
  const double half = 0.5 * garment.fabric.thickness;
  add_slab(sheet, false, half, owner, scene);
  if (garment.band > 0) add_slab(sheet, true, 2 * half, owner, scene);
}

}  // namespace regarment
