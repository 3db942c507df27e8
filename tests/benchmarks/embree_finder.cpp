#include <embree3/rtcore.h>

#include <cmath>
#include <limits>

#include "base/error.h"
#include "bench/closest_point_rivals.h"

namespace regarment {
namespace {

using Vec3f = Eigen::Vector3f;

// Owns the scene and its own float copy of the scan.
struct Scene {
  std::vector<Vec3f> corners;  // three per triangle, in a row
  std::vector<Vec3f> normals;
  RTCDevice device = nullptr;
  RTCScene scene = nullptr;

  Scene() = default;
  Scene(const Scene&) = delete;
  Scene& operator=(const Scene&) = delete;
  ~Scene() {
    if (scene != nullptr) rtcReleaseScene(scene);
    if (device != nullptr) rtcReleaseDevice(device);
  }
};

// The nearest point of a triangle by regions, as in Embree's own example (Ericson 2005, 5.1.5).
Vec3f nearest_on(const Vec3f& p, const Vec3f& a, const Vec3f& b, const Vec3f& c) {
  const Vec3f ab = b - a, ac = c - a, ap = p - a;
  const float d1 = ab.dot(ap), d2 = ac.dot(ap);
  if (d1 <= 0 && d2 <= 0) return a;
  const Vec3f bp = p - b;
  const float d3 = ab.dot(bp), d4 = ac.dot(bp);
  if (d3 >= 0 && d4 <= d3) return b;
  const Vec3f cp = p - c;
  const float d5 = ab.dot(cp), d6 = ac.dot(cp);
  if (d6 >= 0 && d5 <= d6) return c;
  const float vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return a + d1 / (d1 - d3) * ab;
  const float vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return a + d2 / (d2 - d6) * ac;
  const float va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0)
    return b + (d4 - d3) / ((d4 - d3) + (d5 - d6)) * (c - b);
  const float scale = 1 / (va + vb + vc);
  return a + vb * scale * ab + vc * scale * ac;
}

struct Search {
  const Scene* scene = nullptr;
  Vec3f point, normal;
  float min_cosine = -1;
};

bool visit(RTCPointQueryFunctionArguments* call) {
  const auto& search = *static_cast<const Search*>(call->userPtr);
  const unsigned t = call->primID;
  if (search.min_cosine > -1 && search.scene->normals[t].dot(search.normal) < search.min_cosine)
    return false;
  const Vec3f* corner = &search.scene->corners[3 * std::size_t{t}];
  const float distance =
      (nearest_on(search.point, corner[0], corner[1], corner[2]) - search.point).norm();
  if (!(distance < call->query->radius)) return false;
  call->query->radius = distance;
  return true;
}

void ask(const Scene& scene, std::span<const Question> questions, double min_cosine,
         std::vector<double>& distances) {
  for (std::size_t i = 0; i < questions.size(); ++i) {
    Search search{&scene, questions[i].point.cast<float>(), questions[i].normal.cast<float>(),
                  static_cast<float>(min_cosine)};
    RTCPointQuery query{search.point.x(), search.point.y(), search.point.z(), 0,
                        std::numeric_limits<float>::infinity()};
    RTCPointQueryContext context;
    rtcInitPointQueryContext(&context);
    rtcPointQuery(scene.scene, &query, &context, visit, &search);
    distances[i] = static_cast<double>(query.radius);
  }
}

void build(Scene& scene, const Mesh& mesh) {
  scene.device = rtcNewDevice("threads=1");
  scene.scene = rtcNewScene(scene.device);
  rtcSetSceneBuildQuality(scene.scene, RTC_BUILD_QUALITY_HIGH);
  RTCGeometry geometry = rtcNewGeometry(scene.device, RTC_GEOMETRY_TYPE_TRIANGLE);
  auto* vertices = static_cast<float*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0,
                                                               RTC_FORMAT_FLOAT3, 3 * sizeof(float),
                                                               mesh.positions.size()));
  auto* indices = static_cast<unsigned*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0,
                                                                 RTC_FORMAT_UINT3, sizeof(Triangle),
                                                                 mesh.triangles.size()));
  if (vertices == nullptr || indices == nullptr)
    throw TemporaryError("embree: no memory for the scan; free some and try again");
  for (const Vec3& p : mesh.positions)
    for (int axis = 0; axis < 3; ++axis) *vertices++ = static_cast<float>(p[axis]);
  for (const Triangle& triangle : mesh.triangles)
    for (const std::uint32_t vertex : triangle) *indices++ = vertex;
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(scene.scene, geometry);
  rtcReleaseGeometry(geometry);
  rtcCommitScene(scene.scene);
}

}  // namespace

Finder embree_finder(const Mesh& mesh) {
  const auto scene = std::make_shared<Scene>();
  for (const Vec3& normal : face_normals(mesh)) scene->normals.push_back(normal.cast<float>());
  for (const Triangle& triangle : mesh.triangles)
    for (const std::uint32_t vertex : triangle)
      scene->corners.push_back(mesh.positions[vertex].cast<float>());
  const double start = thread_seconds();
  build(*scene, mesh);
  const double build_ms = (thread_seconds() - start) * 1e3;
  return {"Embree", build_ms, [scene](auto questions, double min_cosine, auto& distances) {
            ask(*scene, questions, min_cosine, distances);
          }};
}

}  // namespace regarment
