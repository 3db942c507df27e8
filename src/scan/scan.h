#pragma once

#include <Eigen/Geometry>
#include <memory>
#include <string>
#include <vector>

#include "geometry/mesh.h"
#include "scan/finding.h"

namespace regarment {

/// What is known about the file a scan came from, and how much of it was guessed.
struct ScanFacts {
  std::string file;    // name without folder
  std::string sha256;  // of the file's bytes, hexadecimal
  std::string units;   // "mm", "cm", "m" or "inch"
  std::string up;      // file axis that points up: "+x" ... "-z", or "free" when no axis does
  std::string front;   // file axis nearest to where the person faces, same form
  bool units_guessed = true, up_guessed = true, front_guessed = true;
  double front_confidence = 1.0;  // 0.5 (could be either way round) .. 1
  double noise = 0.0;             // m, standard deviation of points about the local surface
  double spacing = 0.0;           // m, median distance from a vertex to its nearest neighbour
  double height = 0.0;            // m, floor to top of head
  std::size_t outliers = 0;       // vertices far from any surface
  std::size_t holes = 0;          // boundary loops of an open mesh, 0 for a cloud
  std::vector<Finding> findings;  // what was noticed, in the order it was looked for
};

struct ThinScan;

/// A scan of a person in the body frame: metres, +y up, +z where the person faces, +x to the
/// person's left, floor at y = 0, the body's centre of area over the origin.
/// Vertices keep the file's order. All vectors have one entry per vertex of the file.
struct Scan {
  ScanFacts facts;
  Mesh mesh;                           // normals are filled in for all, outward, unit
  std::vector<std::uint8_t> outlier;   // 1: far from any surface, kept out of every measurement
  std::vector<std::uint8_t> invented;  // 1: made up by a reconstruction where there was no data, as
                                       // far as the density tells; empty: nothing known
  Eigen::Affine3d file_from_body;      // rotation, uniform scale and shift back to the file's frame
  std::shared_ptr<const ThinScan> thin;  // what is worked on; null: the scan itself
};

/// A copy of a scan with very many vertices that has fewer, in the same body frame.
struct ThinScan {
  static constexpr std::uint32_t kNone = 0xffffffff;

  Scan scan;
  std::vector<std::uint32_t> of_vertex;  // which of its vertices stands for each of the whole
                                         // scan's; kNone for one that is not finite
};

}  // namespace regarment
