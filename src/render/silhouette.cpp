#include "render/silhouette.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <tuple>
#include <utility>

#include "base/error.h"
#include "render/clip_matrix.h"
#include "render/context.h"
#include "render/gl.h"
#include "render/shader.h"

namespace regarment {
namespace {

void check_mesh(std::span<const Triangle> triangles, std::size_t vertex_count, int size) {
  if (size < 1 || size > 4096) {
    throw InvalidInput("silhouettes of " + std::to_string(size) + " pixels, must be 1..4096");
  }
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const std::uint32_t largest = *std::max_element(triangles[t].begin(), triangles[t].end());
    if (largest < vertex_count) continue;
    throw InvalidInput("triangle " + std::to_string(t) + " names vertex " +
                       std::to_string(largest) + ", there are " + std::to_string(vertex_count));
  }
}

/// True when both look along one line from opposite ends, so that their pictures are mirror images:
/// right is left, up is up, and the pictures' middles are the same point.
bool opposite(const Camera& a, const Camera& b) {
  return a.centre == b.centre && a.pixels_per_metre == b.pixels_per_metre &&
         a.view_from_body.row(0) == -b.view_from_body.row(0) &&
         a.view_from_body.row(1) == b.view_from_body.row(1);
}

/// The pixels whose centres a vertex may lie on or beside: from the first that is not before it to
/// the last that is not behind it, each way, give and take what OpenGL may move it by.
struct Centres {
  int first_column = 0, last_column = 0, first_row = 0, last_row = 0;
};

constexpr double kMoved = 1.0 / 16;   // pixels; no finer grid is promised: GL_SUBPIXEL_BITS >= 4
constexpr double kRelative = 1e-6;    // of its distance from the middle, in single precision
constexpr double kFarthest = 100000;  // pixels; beyond, nearer places serve as well

std::pair<int, int> centres_beside(double pixels, double middle) {
  const double at = std::clamp(pixels, -kFarthest, kFarthest) + middle - 0.5;
  const double moved = kMoved + kRelative * std::abs(pixels);
  return {static_cast<int>(std::ceil(at - moved)), static_cast<int>(std::floor(at + moved))};
}

// Whether a triangle may have the centre of a pixel in it. Of a fine scan, few have.
bool may_show(const Centres& a, const Centres& b, const Centres& c) {
  return std::min({a.first_column, b.first_column, c.first_column}) <=
             std::max({a.last_column, b.last_column, c.last_column}) &&
         std::min({a.first_row, b.first_row, c.first_row}) <=
             std::max({a.last_row, b.last_row, c.last_row});
}

Silhouette mirrored(Silhouette silhouette) {
  auto& pixels = silhouette.covered;
  for (auto row = pixels.begin(); row != pixels.end(); row += silhouette.size)
    std::reverse(row, row + silhouette.size);
  return silhouette;
}

}  // namespace

std::size_t Silhouette::area() const {
  return std::size_t(std::count(covered.begin(), covered.end(), std::uint8_t(1)));
}

struct SilhouetteRenderer::State {
  Context& context = Context::of_this_thread();
  Shader shader{"silhouette"};
  GlFramebuffer framebuffer;
  GlRenderbuffer mask;
  GlBuffer positions, indices;
  GlVertexArray array;
  std::size_t vertex_count = 0;
  int size = 0;
  std::vector<Triangle> triangles;
  std::vector<Eigen::Vector3f> staged;  // positions relative to the first camera's centre
  std::vector<Centres> centres;         // of each vertex, in the picture that is drawn
  std::vector<Triangle> shown;

  void stage(std::span<const Vec3> points, const Vec3& origin);
  void choose(std::span<const Vec3> points, const Camera& camera);
  Silhouette draw(std::span<const Vec3> points, const Camera& camera, const Vec3& origin);
};

SilhouetteRenderer::SilhouetteRenderer(std::span<const Triangle> triangles,
                                       std::size_t vertex_count, int size) {
  check_mesh(triangles, vertex_count, size);
  state_ = std::make_unique<State>();
  State& s = *state_;
  s.vertex_count = vertex_count;
  s.size = size;
  s.triangles.assign(triangles.begin(), triangles.end());
  s.centres.resize(vertex_count);
  s.staged.resize(vertex_count);
  glBindFramebuffer(GL_FRAMEBUFFER, s.framebuffer.name());
  glBindRenderbuffer(GL_RENDERBUFFER, s.mask.name());
  glRenderbufferStorage(GL_RENDERBUFFER, GL_R8, size, size);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, s.mask.name());
  if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
    throw Error(1,
                "cannot draw: OpenGL refuses a silhouette of " + std::to_string(size) + " pixels");
  }
  glBindVertexArray(s.array.name());
  glBindBuffer(GL_ARRAY_BUFFER, s.positions.name());
  glBufferData(GL_ARRAY_BUFFER, GLsizeiptr(vertex_count * sizeof(Eigen::Vector3f)), nullptr,
               GL_DYNAMIC_DRAW);
  glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, sizeof(Eigen::Vector3f), nullptr);
  glEnableVertexAttribArray(0);
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, s.indices.name());
  s.context.check("preparing silhouettes");
}

SilhouetteRenderer::~SilhouetteRenderer() = default;

void SilhouetteRenderer::State::stage(std::span<const Vec3> points, const Vec3& origin) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    check_drawable(points[i], i);
    staged[i] = (points[i] - origin).cast<float>();
  }
  glBindBuffer(GL_ARRAY_BUFFER, positions.name());
  glBufferSubData(GL_ARRAY_BUFFER, 0, GLsizeiptr(staged.size() * sizeof(Eigen::Vector3f)),
                  staged.data());
}

void SilhouetteRenderer::State::choose(std::span<const Vec3> points, const Camera& camera) {
  const Vec3 right = camera.pixels_per_metre * camera.view_from_body.row(0).transpose();
  const Vec3 up = camera.pixels_per_metre * camera.view_from_body.row(1).transpose();
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vec3 p = points[i] - camera.centre;
    Centres& c = centres[i];
    std::tie(c.first_column, c.last_column) = centres_beside(right.dot(p), 0.5 * camera.width);
    std::tie(c.first_row, c.last_row) = centres_beside(up.dot(p), 0.5 * camera.height);
  }
  shown.clear();
  for (const Triangle& t : triangles)
    if (may_show(centres[t[0]], centres[t[1]], centres[t[2]])) shown.push_back(t);
  glBufferData(GL_ELEMENT_ARRAY_BUFFER, GLsizeiptr(std::span(shown).size_bytes()), shown.data(),
               GL_STREAM_DRAW);
}

Silhouette SilhouetteRenderer::State::draw(std::span<const Vec3> points, const Camera& camera,
                                           const Vec3& origin) {
  choose(points, camera);
  // Depth does not count: the mesh is flattened so that nothing is cut off in front or behind.
  Eigen::Matrix4f flat = clip_from_body(camera, origin);
  flat.row(2).setZero();
  shader.set("clip_from_body", flat);
  constexpr std::array<GLfloat, 4> kNothing = {0, 0, 0, 0};
  glClearBufferfv(GL_COLOR, 0, kNothing.data());
  glDrawElements(GL_TRIANGLES, GLsizei(3 * shown.size()), GL_UNSIGNED_INT, nullptr);
  Silhouette silhouette{size, std::vector<std::uint8_t>(std::size_t(size) * std::size_t(size))};
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadBuffer(GL_COLOR_ATTACHMENT0);
  glReadPixels(0, 0, size, size, GL_RED, GL_UNSIGNED_BYTE, silhouette.covered.data());
  for (std::uint8_t& pixel : silhouette.covered) pixel = pixel != 0 ? 1 : 0;
  return silhouette;
}

std::vector<Silhouette> SilhouetteRenderer::draw(std::span<const Vec3> positions,
                                                 std::span<const Camera> cameras) {
  State& s = *state_;
  if (positions.size() != s.vertex_count) {
    throw InvalidInput("a silhouette of " + std::to_string(s.vertex_count) + " vertices got " +
                       std::to_string(positions.size()));
  }
  std::vector<Silhouette> silhouettes;
  if (cameras.empty()) return silhouettes;
  const Vec3 origin = cameras.front().centre;
  glBindFramebuffer(GL_FRAMEBUFFER, s.framebuffer.name());
  glBindVertexArray(s.array.name());
  glDisable(GL_SCISSOR_TEST);
  glDisable(GL_DEPTH_TEST);
  glViewport(0, 0, s.size, s.size);
  s.stage(positions, origin);
  s.shader.use();
  for (std::size_t c = 0; c < cameras.size(); ++c) {
    const Camera& camera = cameras[c];
    if (camera.width != s.size || camera.height != s.size) {
      throw InvalidInput("a silhouette of " + std::to_string(s.size) + " pixels got a camera of " +
                         std::to_string(camera.width) + " x " + std::to_string(camera.height));
    }
    const auto drawn = std::find_if(cameras.begin(), cameras.begin() + c,
                                    [&](const Camera& other) { return opposite(camera, other); });
    silhouettes.push_back(drawn == cameras.begin() + c
                              ? s.draw(positions, camera, origin)
                              : mirrored(silhouettes[drawn - cameras.begin()]));
  }
  s.context.check("silhouettes");
  return silhouettes;
}

std::vector<Silhouette> four_silhouettes(const Mesh& mesh, const Box& box, int size) {
  SilhouetteRenderer renderer(mesh.triangles, mesh.positions.size(), size);
  Framing framing;
  framing.width = framing.height = size;
  return renderer.draw(mesh.positions, frame_views(box, four_sides(), framing));
}

}  // namespace regarment
