#pragma once

#include <cstdint>

#include "synthetic/dressed_person.h"
#include "synthetic/scanner_scene.h"

namespace regarment {

/// Adds a garment to a scene as what it is, a slab: its particles are the middle of the cloth, and
/// the two sides lie half of SheetFabric::thickness off it along the normals, with walls along the
/// free edges, so that every hem, waist and cuff is a step of the cloth's thickness. The strip of
/// WornGarment::band along the top edge (flat t from 0) is twice as thick, a slab of its own whose
/// lower end is cut exactly there. `owner` is 1 for the outermost garment. Throws InvalidInput when
/// the garment has not one finite particle per particle of its pattern.
void add_cloth(const WornGarment& garment, std::uint8_t owner, ScannerScene& scene);

}  // namespace regarment
