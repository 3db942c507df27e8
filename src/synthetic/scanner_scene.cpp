#include "synthetic/scanner_scene.h"

#include "base/error.h"
#include "synthetic/dressed_person.h"
#include "synthetic/scanner_cloth.h"

namespace regarment {

void ScannerScene::add(const Mesh& mesh, std::uint8_t whose) {
  const auto first = static_cast<std::uint32_t>(positions.size());
  positions.insert(positions.end(), mesh.positions.begin(), mesh.positions.end());
  for (const Triangle& t : mesh.triangles)
    triangles.push_back({first + t[0], first + t[1], first + t[2]});
  owner.resize(triangles.size(), whose);
  source.resize(triangles.size(), kNone);
  inner.resize(triangles.size(), 0);
}

ScannerScene make_scene(const DressedPerson& person) {
  if (person.garments.size() >= kOwnerNobody)
    throw InvalidInput("a scanned person wears more than 254 garments: leave some out");
  ScannerScene scene;
  scene.add(person.body, kOwnerPerson);
  for (std::size_t i = 0; i < person.garments.size(); ++i)
    add_cloth(person.garments[i], static_cast<std::uint8_t>(i + 1), scene);
  return scene;
}

}  // namespace regarment
