#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "geometry/mesh.h"
#include "render/camera.h"

namespace regarment {

/// The outline of a mesh as a filled mask.
struct Silhouette {
  int size = 0;                       // the mask has size x size pixels
  std::vector<std::uint8_t> covered;  // row by row, top row first: 1 where the pixel's centre lies
                                      // inside the projected mesh, else 0
  std::size_t area() const;           // covered pixels
};

/// Draws silhouettes of a mesh whose triangles stay and whose vertices move, as the paper's
/// silhouette error asks for at every step (Hasler et al. 2007, sec. 3.5). Hands OpenGL only the
/// triangles that may have the centre of a pixel in them. Keeps one framebuffer and one vertex
/// buffer. Uses the thread's context; stay in one thread.
class SilhouetteRenderer {
 public:
  /// Masks of `size` x `size` pixels, 1..4096. Throws InvalidInput for another size or a triangle
  /// that names a vertex >= `vertex_count`.
  SilhouetteRenderer(std::span<const Triangle> triangles, std::size_t vertex_count, int size = 256);
  ~SilhouetteRenderer();
  SilhouetteRenderer(const SilhouetteRenderer&) = delete;
  SilhouetteRenderer& operator=(const SilhouetteRenderer&) = delete;

  /// One mask per camera, whose pictures must be size x size. `positions`: body frame, m, one per
  /// vertex. Edges are placed to a 256th of a pixel; a centre exactly on an edge counts once.
  /// Everything is drawn whatever its depth. A camera opposite to one before it gets that one's
  /// mask mirrored: seen from the other end, the outline is the same. Throws InvalidInput for
  /// another count of positions, one that cannot be drawn, or a camera of another size.
  std::vector<Silhouette> draw(std::span<const Vec3> positions, std::span<const Camera> cameras);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// The four sides of one mesh, framed by `box` at one scale, in the order of `four_sides()`.
std::vector<Silhouette> four_silhouettes(const Mesh& mesh, const Box& box, int size = 256);

}  // namespace regarment
