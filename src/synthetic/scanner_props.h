#pragma once

#include "base/random.h"
#include "synthetic/scanner_scene.h"

namespace regarment {

/// What else stands in a scanner. It is seen, casts shadows, and is nobody's garment.
struct PropOptions {
  int posts = 0;              // 0 .. 8 upright poles, 0.75 to 0.95 m from the person's axis
  double floor_radius = 0.0;  // m, 0 .. 1.2: a round piece of floor under the feet; 0: none
  int islands = 0;            // 0 .. 20 pieces of something, 2 to 6 cm, afloat beside the person

  void check() const;  // throws InvalidInput naming the field and its value
};

/// Adds the props to a scene. `height` is the person's, m; `columns_yaw` the angle of one column
/// of cameras and `columns` their number (scanner_rig.h): posts stand between columns, where they
/// hide least. Islands keep 4 cm away from everything that was in the scene.
void add_props(const PropOptions& options, double height, int columns, double columns_yaw,
               Random& random, ScannerScene& scene);

}  // namespace regarment
