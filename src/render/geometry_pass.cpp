#include "render/geometry_pass.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "base/error.h"
#include "render/clip_matrix.h"
#include "render/context.h"
#include "render/fill_holes.h"
#include "render/gl.h"
#include "render/shader.h"
#include "render/visible_points.h"

namespace regarment {
namespace {

// In spacings. Larger discs leave fewer holes to fill, but take longer and blur outlines.
constexpr double kDiscRadius = 1.0;

struct PixelRectangle {
  int left = 0, top = 0, right = 0, bottom = 0;  // right and bottom are the first pixels outside
  int width() const { return right - left; }
  int height() const { return bottom - top; }
  bool empty() const { return width() <= 0 || height() <= 0; }
};

// What is drawn into: three attachments that grow to the largest picture asked for.
struct Target {
  GlFramebuffer framebuffer;
  GlRenderbuffer id, normal, depth;
  int width = 0, height = 0;

  void reserve(int wanted_width, int wanted_height) {
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer.name());
    if (wanted_width <= width && wanted_height <= height) return;
    width = std::max(width, wanted_width);
    height = std::max(height, wanted_height);
    attach(id, GL_R32UI, GL_COLOR_ATTACHMENT0);
    attach(normal, GL_RG16_SNORM, GL_COLOR_ATTACHMENT1);
    attach(depth, GL_DEPTH_COMPONENT32F, GL_DEPTH_ATTACHMENT);
    constexpr std::array<GLenum, 2> kTargets = {GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1};
    glDrawBuffers(2, kTargets.data());
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
      throw Error(1, "cannot draw: OpenGL refuses a picture of " + std::to_string(width) + " x " +
                         std::to_string(height) + " pixels with ids and normals");
    }
  }

  void attach(const GlRenderbuffer& buffer, GLenum format, GLenum attachment) const {
    glBindRenderbuffer(GL_RENDERBUFFER, buffer.name());
    glRenderbufferStorage(GL_RENDERBUFFER, format, width, height);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, attachment, GL_RENDERBUFFER, buffer.name());
  }

  static void clear(const PixelRectangle& area) {
    constexpr std::array<GLuint, 4> kNoId = {0, 0, 0, 0};
    constexpr std::array<GLfloat, 4> kNoNormal = {0, 0, 0, 0};
    constexpr GLfloat kFar = 1.0F;
    glEnable(GL_SCISSOR_TEST);
    glScissor(0, 0, area.width(), area.height());
    glClearBufferuiv(GL_COLOR, 0, kNoId.data());
    glClearBufferfv(GL_COLOR, 1, kNoNormal.data());
    glClearBufferfv(GL_DEPTH, 0, &kFar);
  }

  static GeometryBuffers read(const PixelRectangle& area, double depth_range) {
    GeometryBuffers buffers;
    buffers.left = area.left, buffers.top = area.top;
    buffers.width = area.width(), buffers.height = area.height();
    const std::size_t count = std::size_t(area.width()) * std::size_t(area.height());
    buffers.id.resize(count);
    buffers.normal.resize(count);
    buffers.depth.resize(count);
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    glReadBuffer(GL_COLOR_ATTACHMENT0);
    glReadPixels(0, 0, area.width(), area.height(), GL_RED_INTEGER, GL_UNSIGNED_INT,
                 buffers.id.data());
    glReadBuffer(GL_COLOR_ATTACHMENT1);
    glReadPixels(0, 0, area.width(), area.height(), GL_RG, GL_SHORT, buffers.normal.data());
    glReadPixels(0, 0, area.width(), area.height(), GL_DEPTH_COMPONENT, GL_FLOAT,
                 buffers.depth.data());
    const auto range = static_cast<float>(depth_range);
    for (float& depth_value : buffers.depth) depth_value = (2.0F * depth_value - 1.0F) * range;
    return buffers;
  }
};

PixelRectangle covered_pixels(const std::vector<Eigen::Vector3f>& positions, const Vec3& origin,
                              const Camera& camera, double reach) {
  const Eigen::Vector3f right = camera.view_from_body.row(0).cast<float>();
  const Eigen::Vector3f up = camera.view_from_body.row(1).cast<float>();
  Eigen::Array2f low = Eigen::Array2f::Constant(1e30F), high = -low;
  for (const Eigen::Vector3f& position : positions) {
    const Eigen::Array2f point(right.dot(position), -up.dot(position));
    low = low.min(point), high = high.max(point);
  }
  if (positions.empty()) return {};
  const Eigen::Array2d shift = camera.pixel_from_body(origin).head<2>().array();
  const double scale = camera.pixels_per_metre;
  // A pixel more on each side than arithmetic in float could need.
  const Eigen::Array2d first = low.cast<double>() * scale + shift - reach - 1.0;
  const Eigen::Array2d last = high.cast<double>() * scale + shift + reach + 2.0;
  const auto clamp = [](double value, int size) {
    return int(std::clamp(value, 0.0, double(size)));
  };
  return {clamp(first.x(), camera.width), clamp(first.y(), camera.height),
          clamp(last.x(), camera.width), clamp(last.y(), camera.height)};
}

template <typename Element>
void upload(GLenum target, const GlBuffer& buffer, const std::vector<Element>& elements) {
  glBindBuffer(target, buffer.name());
  glBufferData(target, GLsizeiptr(elements.size() * sizeof(Element)), elements.data(),
               GL_STATIC_DRAW);
}

void bind_floats(GLuint attribute, const GlBuffer& buffer, std::size_t stride, std::size_t offset) {
  glBindBuffer(GL_ARRAY_BUFFER, buffer.name());
  glVertexAttribPointer(attribute, 3, GL_FLOAT, GL_FALSE, GLsizei(stride),
                        reinterpret_cast<const void*>(offset));
  glEnableVertexAttribArray(attribute);
}

// One of the three corners of the triangle round a disc.
struct DiscCorner {
  Eigen::Vector3f position, normal;
  std::uint32_t point;
};

}  // namespace

struct UploadedMesh::State {
  const DisplayMesh& mesh;
  Vec3 origin;
  GlBuffer positions{}, normals{}, indices{};  // of a mesh; a cloud is uploaded view by view
  GlVertexArray array{};
};

UploadedMesh::UploadedMesh(const DisplayMesh& mesh, const Vec3& origin)
    : state_((Context::of_this_thread(), new State{mesh, origin})) {
  const State& s = *state_;
  glBindVertexArray(s.array.name());
  if (mesh.is_cloud()) {
    bind_floats(0, s.positions, sizeof(DiscCorner), offsetof(DiscCorner, position));
    bind_floats(1, s.positions, sizeof(DiscCorner), offsetof(DiscCorner, normal));
    glVertexAttribIPointer(2, 1, GL_UNSIGNED_INT, sizeof(DiscCorner),
                           reinterpret_cast<const void*>(offsetof(DiscCorner, point)));
    glEnableVertexAttribArray(2);
    return;
  }
  bind_floats(0, s.positions, sizeof(Eigen::Vector3f), 0);
  bind_floats(1, s.normals, sizeof(Eigen::Vector3f), 0);
  upload(GL_ARRAY_BUFFER, s.positions, mesh.positions);
  upload(GL_ARRAY_BUFFER, s.normals, mesh.normals);
  upload(GL_ELEMENT_ARRAY_BUFFER, s.indices, mesh.triangles);
}

UploadedMesh::~UploadedMesh() = default;
UploadedMesh::UploadedMesh(UploadedMesh&&) noexcept = default;

struct GeometryPass::State {
  Context& context = Context::of_this_thread();
  Shader mesh_shader{"mesh"};
  Shader splat_shader{"splat"};
  Target target;

  void draw_mesh(const UploadedMesh::State& uploaded, const Camera& camera) const;
  void draw_discs(const UploadedMesh::State& uploaded, const Camera& camera, double radius) const;
};

void GeometryPass::State::draw_mesh(const UploadedMesh::State& uploaded,
                                    const Camera& camera) const {
  mesh_shader.use();
  mesh_shader.set("clip_from_body", clip_from_body(camera, uploaded.origin));
  mesh_shader.set("view_from_body", Eigen::Matrix3f(camera.view_from_body.cast<float>()));
  glBindVertexArray(uploaded.array.name());
  glDrawElements(GL_TRIANGLES, GLsizei(3 * uploaded.mesh.triangles.size()), GL_UNSIGNED_INT,
                 nullptr);
}

void GeometryPass::State::draw_discs(const UploadedMesh::State& uploaded, const Camera& camera,
                                     double radius) const {
  const DisplayMesh& mesh = uploaded.mesh;
  const double hidden_behind = 6.0 * mesh.spacing;  // m, more than neighbouring discs are apart
  std::vector<DiscCorner> corners;
  for (const std::uint32_t i :
       visible_points(mesh.positions, uploaded.origin, camera, 2.0 * radius, hidden_behind)) {
    corners.insert(corners.end(), 3, {mesh.positions[i], mesh.normals[i], i});
  }
  splat_shader.use();
  splat_shader.set("clip_from_body", clip_from_body(camera, uploaded.origin));
  splat_shader.set("view_from_body", Eigen::Matrix3f(camera.view_from_body.cast<float>()));
  splat_shader.set("radius", Eigen::Vector2f(float(2.0 * radius / camera.width),
                                             float(-2.0 * radius / camera.height)));
  splat_shader.set("radius_in_depth",
                   float(0.5 * radius / (camera.pixels_per_metre * camera.depth_range)));
  glBindVertexArray(uploaded.array.name());
  upload(GL_ARRAY_BUFFER, uploaded.positions, corners);
  glDrawArrays(GL_TRIANGLES, 0, GLsizei(corners.size()));
}

GeometryPass::GeometryPass() : state_(std::make_unique<State>()) {}
GeometryPass::~GeometryPass() = default;

GeometryBuffers GeometryPass::draw(const UploadedMesh& uploaded, const Camera& camera) {
  State& s = *state_;
  const UploadedMesh::State& u = *uploaded.state_;
  const bool cloud = u.mesh.is_cloud();
  // A disc is at least two pixels wide, or points between pixel centres would be lost.
  const double radius = std::max(kDiscRadius * u.mesh.spacing * camera.pixels_per_metre, 1.0);
  const PixelRectangle area =
      covered_pixels(u.mesh.positions, u.origin, camera, cloud ? radius : 0.0);
  if (area.empty()) return {};
  s.target.reserve(area.width(), area.height());
  Target::clear(area);
  glViewport(-area.left, -area.top, camera.width, camera.height);
  glEnable(GL_DEPTH_TEST);
  if (cloud) {
    s.draw_discs(u, camera, radius);
  } else {
    s.draw_mesh(u, camera);
  }
  GeometryBuffers buffers = Target::read(area, camera.depth_range);
  s.context.check("the geometry pass");
  if (cloud) fill_holes(buffers, int(std::ceil(2.0 * radius)), 3.0 * u.mesh.spacing);
  return buffers;
}

Camera supersampled(const Camera& camera, int factor) {
  Camera larger = camera;
  larger.width *= factor;
  larger.height *= factor;
  larger.pixels_per_metre *= factor;
  return larger;
}

}  // namespace regarment
