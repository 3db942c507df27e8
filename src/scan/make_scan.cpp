#include "scan/make_scan.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <optional>

#include "base/error.h"
#include "scan/body_sample.h"
#include "scan/file_axis.h"
#include "scan/find_front.h"
#include "scan/find_units.h"
#include "scan/find_up.h"
#include "scan/finish_surface.h"
#include "scan/robust.h"
#include "scan/weld.h"

namespace regarment {
namespace {

constexpr std::size_t kFewestPoints = 300;         // of a cloud that can show a person
constexpr std::size_t kFewestCorners = 60;         // of a mesh, whose triangles fill the gaps
constexpr double kSmallest = 0.1, kLargest = 1e4;  // file units, of anything that can be a person
constexpr double kFloorShare = 0.0003;             // of the area may lie below the floor: noise
constexpr double kTopShare = 0.0002;               // of the area may lie above the head
constexpr double kUnsureLead = 1.0;                // likeness, of 7
constexpr double kUnsureFront = 0.9;
constexpr double kUnlikeSides = 0.015;  // mirror mismatch, body heights

std::string text(double value, int digits) {
  std::array<char, 40> buffer{};
  std::snprintf(buffer.data(), buffer.size(), "%.*g", digits, value);
  return buffer.data();
}

std::optional<Vec3> given_axis(const std::string& name) {
  if (name == "auto") return std::nullopt;
  return axis_vector(name);
}

void check_option(const char* name, const std::string& value, void (*check)(const std::string&)) {
  try {
    if (value != "auto") check(value);
  } catch (const UsageError& error) {
    throw UsageError(std::string(name) + ": " + error.what() + ", or auto");
  }
}

void check_triangles(const Mesh& mesh) {
  for (const Triangle& t : mesh.triangles) {
    if (*std::max_element(t.begin(), t.end()) >= mesh.positions.size()) {
      throw InvalidInput("make_scan: a triangle names a vertex the mesh does not have");
    }
  }
}

void check_enough(const Welded& welded, bool is_cloud) {
  const std::size_t fewest = is_cloud ? kFewestPoints : kFewestCorners;
  if (welded.positions.size() >= fewest) return;
  throw NoPersonError("the file has " + std::to_string(welded.positions.size()) +
                      " different points, a person needs " + std::to_string(fewest) +
                      " at least: check that the right file was exported");
}

void check_size(std::span<const Vec3> sample) {
  Vec3 low = sample[0], high = low;
  for (const Vec3& p : sample) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const double longest = (high - low).maxCoeff();
  if (longest >= kSmallest && longest <= kLargest) return;
  throw NoPersonError("the shape is " + text(longest, 3) +
                      " file units large: no person in m, cm, mm or inch; scale the file");
}

UpAxis up_of(const BodySample& sample, const ScanOptions& options) {
  const auto up = given_axis(options.up);
  UpAxis found =
      up ? look_along(sample, *up, options.up) : find_up(sample, given_axis(options.front));
  const PersonLikeness& likeness = found.likeness;
  if (likeness.is_person() || (up && likeness.total() >= 1.0)) return found;
  throw NoPersonError("the shape does not look like a standing person: " +
                      std::string(likeness.head < 0.3 ? "no head on shoulders" : "a head") +
                      (likeness.legs < 0.4 ? ", no pair of legs" : ", legs") + " with " +
                      found.name + " up" +
                      (up ? "; give another --up" : "; check the file, or give --up"));
}

/// Turns points to +y up in body heights, floor at 0; x and z are any two horizontal directions.
struct Upright {
  Vec3 x, y, z;  // in the file's frame
  double low, height;

  explicit Upright(const UpAxis& up)
      : x(up.direction.unitOrthogonal()),
        y(up.direction),
        z(x.cross(y)),
        low(up.slices.low),
        height(up.slices.height) {}

  std::vector<Vec3> from_file(std::span<const Vec3> points) const {
    std::vector<Vec3> upright(points.size());
    std::transform(points.begin(), points.end(), upright.begin(), [&](const Vec3& p) -> Vec3 {
      const Vec3 d = p - low * y;
      return Vec3(x.dot(d), y.dot(d), z.dot(d)) / height;
    });
    return upright;
  }
  Vec3 to_file(const Vec3& direction) const {
    return direction.x() * x + direction.y() * y + direction.z() * z;
  }
};

struct Facing {
  Vec3 direction;  // in the file's frame
  double confidence = 1.0;
};

Facing front_of(const BodySample& sample, const UpAxis& up, const ScanOptions& options,
                std::vector<std::string>& warnings) {
  if (const auto given = given_axis(options.front)) {
    return {(*given - given->dot(up.direction) * up.direction).normalized(), 1.0};
  }
  const Upright upright(up);
  const Front front = find_front(upright.from_file(sample.points), up.likeness);
  if (front.confidence < kUnsureFront) {
    warnings.push_back("it is unsure where the person faces (confidence " +
                       text(front.confidence, 2) + "): look at the pictures, give --front");
  } else if (front.mismatch > kUnlikeSides) {
    warnings.emplace_back(
        "left and right side are held very unlike: where the person faces is approximate");
  }
  return {upright.to_file(front.direction), front.confidence};
}

/// The file axis nearest to where the person faces, across the up axis where that is one.
std::string name_of_front(const Vec3& front, const UpAxis& up) {
  std::string best = nearest_axis(front);
  if (up.name == "free") return best;
  double most = -2;
  for (const std::string_view name : kFileAxes) {
    const Vec3 axis = axis_vector(name);
    if (std::abs(axis.dot(up.direction)) > 0.5 || axis.dot(front) <= most) continue;
    most = axis.dot(front);
    best = name;
  }
  return best;
}

void warn_about_up(const UpAxis& up, bool given, std::vector<std::string>& warnings) {
  if (up.name == "free") {
    const double cosine = up.direction.cwiseAbs().maxCoeff();
    warnings.push_back("the scan is tilted: up is " +
                       text(std::acos(std::min(cosine, 1.0)) * 57.29577951308232, 2) +
                       " degrees off " + nearest_axis(up.direction) + "; give --up if it is not");
  }
  if (!given && up.lead < kUnsureLead) {
    warnings.push_back("it is unsure that " + up.name + " is up: look at the pictures, give --up");
  }
  if (up.likeness.head < 0.3) {
    warnings.emplace_back("no head is seen: the height found is that of the part that is there");
  }
}

/// Area a position stands for: a third of its triangles in a mesh, the same for all in a cloud.
std::vector<double> areas_of(const std::vector<Vec3>& positions,
                             const std::vector<Triangle>& triangles) {
  if (triangles.empty()) return std::vector<double>(positions.size(), 1.0);
  std::vector<double> areas(positions.size(), 0.0);
  for (const auto& [a, b, c] : triangles) {
    const double area = (positions[b] - positions[a]).cross(positions[c] - positions[a]).norm() / 6;
    for (const std::uint32_t v : {a, b, c}) areas[v] += area;
  }
  return areas;
}

/// Heights below which `floor` and above which `top` of the area lie, outliers left out.
std::pair<double, double> floor_and_top(const RawSurface& raw, const std::vector<double>& areas,
                                        const std::vector<std::uint8_t>& outlier) {
  std::vector<std::pair<double, double>> heights;
  double total = 0;
  for (std::size_t i = 0; i < raw.positions.size(); ++i) {
    if (outlier[i] != 0) continue;
    heights.emplace_back(raw.positions[i].y(), areas[i]);
    total += areas[i];
  }
  if (!(total > 0)) return {0.0, 0.0};
  std::sort(heights.begin(), heights.end());
  double sum = 0;
  std::size_t low = 0;
  while (low + 1 < heights.size() && (sum += heights[low].second) < kFloorShare * total) ++low;
  sum = 0;
  std::size_t high = heights.size() - 1;
  while (high > 0 && (sum += heights[high].second) < kTopShare * total) --high;
  return {heights[low].first, heights[high].first};
}

Vec3 mean_of(std::span<const Vec3> points) {
  Vec3 sum = Vec3::Zero();
  for (const Vec3& p : points) sum += p;
  return sum / static_cast<double>(points.size());
}

/// Rotation, scale and shift from the file's frame into one whose origin is `origin` of the file.
struct Frame {
  Eigen::Matrix3d turn;  // rows: left, up, front in the file's frame
  double metres;
  Vec3 origin;  // in the file's frame

  Vec3 from_file(const Vec3& p) const { return turn * (p - origin) * metres; }

  std::vector<Vec3> from_file(std::span<const Vec3> points) const {
    std::vector<Vec3> result(points.size());
    std::transform(points.begin(), points.end(), result.begin(),
                   [this](const Vec3& p) { return from_file(p); });
    return result;
  }
};

}  // namespace

void ScanOptions::check() const {
  check_option("--units", units, [](const std::string& unit) { metres_of(unit); });
  check_option("--up", up, [](const std::string& axis) { axis_vector(axis); });
  check_option("--front", front, [](const std::string& axis) { axis_vector(axis); });
  if (up == "auto" || front == "auto") return;
  if (axis_vector(up).dot(axis_vector(front)) != 0.0) {
    throw UsageError("--front " + front + " is not perpendicular to --up " + up +
                     ": give two different axes");
  }
}

Scan make_scan(const Mesh& mesh_in_file_frame, const ScanOptions& options) {
  options.check();
  check_triangles(mesh_in_file_frame);
  const Welded welded = weld(mesh_in_file_frame.positions);
  check_enough(welded, mesh_in_file_frame.is_cloud());
  const std::vector<Triangle> triangles = weld_triangles(mesh_in_file_frame.triangles, welded);
  const BodySample sample = sample_body(welded.positions, triangles);
  if (sample.points.size() < 2) {
    throw NoPersonError("nearly all points of the file lie at one place: check the export");
  }
  check_size(sample.points);

  Scan scan;
  ScanFacts& facts = scan.facts;
  const UpAxis up = up_of(sample, options);
  facts.up = up.name;
  facts.up_guessed = options.up == "auto";
  warn_about_up(up, !facts.up_guessed, facts.warnings);
  const FileUnit unit = options.units == "auto" ? find_unit(up.slices.height, up.likeness)
                                                : given_unit(options.units, up.slices.height);
  facts.units = unit.name;
  facts.units_guessed = options.units == "auto";
  if (!unit.doubt.empty()) facts.warnings.push_back(unit.doubt);
  const Facing facing = front_of(sample, up, options, facts.warnings);
  facts.front = name_of_front(facing.direction, up);
  facts.front_guessed = options.front == "auto";
  facts.front_confidence = facing.confidence;

  Frame frame;
  frame.metres = unit.metres;
  frame.turn.row(0) = up.direction.cross(facing.direction);
  frame.turn.row(1) = up.direction;
  frame.turn.row(2) = facing.direction;
  frame.origin = mean_of(sample.points);

  RawSurface raw{welded,
                 frame.from_file(welded.positions),
                 {},
                 frame.from_file(sample.points),
                 sample.cell * unit.metres};
  raw.stray.resize(welded.positions.size());
  std::transform(welded.positions.begin(), welded.positions.end(), raw.stray.begin(),
                 [&](const Vec3& p) { return sample.covers(p) ? 0 : 1; });
  const auto [floor, top] = floor_and_top(raw, areas_of(raw.positions, triangles), raw.stray);
  frame.origin += up.direction * floor / unit.metres;
  facts.height = top - floor;
  const auto put_on_floor = [floor = floor](Vec3& p) { p.y() -= floor; };
  std::for_each(raw.positions.begin(), raw.positions.end(), put_on_floor);
  std::for_each(raw.sample.begin(), raw.sample.end(), put_on_floor);

  scan.mesh = mesh_in_file_frame;
  std::size_t not_finite = 0;
  for (std::size_t v = 0; v < scan.mesh.positions.size(); ++v) {
    const std::uint32_t at = welded.of_vertex[v];
    not_finite += at == Welded::kNone ? 1 : 0;
    scan.mesh.positions[v] = at == Welded::kNone ? Vec3(Vec3::Zero()) : raw.positions[at];
  }
  for (Vec3& n : scan.mesh.normals) n = frame.turn * n;
  if (not_finite > 0) {
    facts.warnings.push_back(std::to_string(not_finite) +
                             " vertices have coordinates that are no numbers: they are left out");
  }
  finish_surface(raw, scan);
  scan.file_from_body.linear() = frame.turn.transpose() / unit.metres;
  scan.file_from_body.translation() = frame.origin;
  return scan;
}

}  // namespace regarment
