#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "geometry/mesh.h"

namespace regarment {

/// One question of a benchmark: what is nearest to `point` and faces as `normal` does.
struct Question {
  Vec3 point;
  Vec3 normal;  // unit
};

/// Asks all questions and writes each distance, infinity when nothing was allowed.
/// `min_cosine` > -1 turns the normal filter on.
using AskAll = std::function<void(std::span<const Question> questions, double min_cosine,
                                  std::vector<double>& distances)>;

/// One way to find nearest points, built over a scan.
struct Finder {
  std::string name;
  double build_ms = 0.0;
  AskAll ask;
};

/// Triangles of `mesh` in CGAL's AABB tree over Simple_cartesian<double>.
Finder cgal_finder(const Mesh& mesh);

/// Triangles of `mesh` in Embree, asked by rtcPointQuery.
Finder embree_finder(const Mesh& mesh);

/// The vertices of `mesh`, with its normals, in nanoflann's tree of doubles.
Finder nanoflann_finder(const Mesh& mesh);

/// Processor time of this thread so far, in seconds: other programs disturb it little.
double thread_seconds();

/// Unit normal of each triangle; zero for one without area.
std::vector<Vec3> face_normals(const Mesh& mesh);

/// Halves the longest sides, in both triangles that share one, until there are `least` triangles:
/// the surface stays the same, and closed where it was. The mesh has normals, or none.
void subdivide(Mesh& mesh, std::size_t least);

/// Points `distance` (m) in front of and behind random places of the surface, as its normal points.
std::vector<Question> ask_near(const Mesh& mesh, double distance, std::size_t count);

/// The same in an order in which neighbours follow each other, as the particles of a garment do.
std::vector<Question> in_order(const std::vector<Question>& questions);

}  // namespace regarment
