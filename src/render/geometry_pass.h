#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "render/camera.h"
#include "render/display_mesh.h"

namespace regarment {

/// What one camera sees of one mesh, per pixel, within the rectangle of the picture that the mesh
/// covers. Row by row, top row first; pixel (x, y) of the buffers is pixel (x + left, y + top) of
/// the picture.
struct GeometryBuffers {
  int left = 0, top = 0, width = 0, height = 0;
  std::vector<std::uint32_t> id;  // 1 + triangle of a mesh, 1 + point of a cloud; 0 = nothing
  std::vector<float> depth;       // m, as Camera::pixel_from_body; far away where id is 0
  std::vector<std::array<std::int16_t, 2>> normal;  // x (right), y (up) of the unit normal in the
                                                    // view / 32767; z >= 0 towards the viewer
  std::size_t index(int x, int y) const { return std::size_t(y) * width + x; }
};

/// A display mesh in OpenGL's memory. Belongs to the context of the thread that made it.
class UploadedMesh {
 public:
  /// `mesh` has positions relative to `origin` (body frame, m) and must outlive this object.
  UploadedMesh(const DisplayMesh& mesh, const Vec3& origin);
  ~UploadedMesh();
  UploadedMesh(UploadedMesh&& other) noexcept;
  UploadedMesh& operator=(UploadedMesh&&) = delete;

 private:
  friend class GeometryPass;
  struct State;
  std::unique_ptr<State> state_;
};

/// Draws meshes into id, depth and normal buffers. Uses the thread's context; stay in one thread.
/// Coverage is by pixel centres: for smooth pictures draw larger and scale down.
class GeometryPass {
 public:
  GeometryPass();
  ~GeometryPass();
  GeometryPass(const GeometryPass&) = delete;
  GeometryPass& operator=(const GeometryPass&) = delete;

  /// One pass. Parts of the mesh outside the picture are cut off. Nothing in sight: empty buffers.
  GeometryBuffers draw(const UploadedMesh& mesh, const Camera& camera);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// The same camera with every pixel split into `factor` x `factor`.
Camera supersampled(const Camera& camera, int factor);

}  // namespace regarment
