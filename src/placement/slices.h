#pragma once

#include <vector>

#include "geometry/surface_samples.h"

namespace regarment {

/// One connected piece of a horizontal slice.
struct SliceCluster {
  double x_min = 0, x_max = 0, z_min = 0, z_max = 0;  // m, body frame
  double area = 0;                                    // m^2 of surface in the slice
  std::vector<int> samples;                           // indices of the samples in it, ascending

  double width() const { return x_max - x_min; }
  double depth() const { return z_max - z_min; }
};

/// The scan cut into horizontal slices of equal height.
struct Slices {
  double height = 0.01;  // m, of one slice; slice i spans [i, i+1) * height
  std::vector<std::vector<SliceCluster>> levels;  // clusters of each level, largest area first
};

/// Cuts samples (body frame, y up, floor at 0) into slices of `height` metres and joins samples of
/// a slice whose cells of `cell` metres touch. Samples below the floor go to slice 0.
Slices slice_body(const SurfaceSamples& samples, double height = 0.01, double cell = 0.012);

}  // namespace regarment
