#include "scan/make_scan.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <optional>

#include "base/error.h"
#include "geometry/parallel.h"
#include "scan/body_frame.h"
#include "scan/file_axis.h"
#include "scan/file_flaws.h"
#include "scan/find_front.h"
#include "scan/find_units.h"
#include "scan/find_up.h"
#include "scan/finish_surface.h"
#include "scan/invented_surface.h"
#include "scan/made_scan.h"
#include "scan/separate_body.h"
#include "scan/surroundings.h"
#include "scan/weld.h"

namespace regarment {
namespace {

constexpr std::size_t kFewestPoints = 300;         // of a cloud that can show a person
constexpr std::size_t kFewestCorners = 60;         // of a mesh, whose triangles fill the gaps
constexpr double kSmallest = 0.1, kLargest = 1e4;  // file units, of anything that can be a person
constexpr double kUnsureLead = 1.0;                // likeness, of 7
constexpr double kUnsureFront = 0.9;
constexpr double kUnlikeSides = 0.015;  // mirror mismatch, body heights
constexpr double kDegrees = 180 / 3.14159265358979323846;

std::string text(double value, int digits) {
  std::array<char, 40> buffer{};
  std::snprintf(buffer.data(), buffer.size(), "%.*g", digits, value);
  return buffer.data();
}

std::optional<Vec3> given_axis(const std::string& name) {
  if (name == "auto") return std::nullopt;
  return axis_vector(name);
}

void check_triangles(const Mesh& mesh) {
  for (const Triangle& t : mesh.triangles) {
    if (*std::max_element(t.begin(), t.end()) >= mesh.positions.size()) {
      throw InvalidInput("make_scan: a triangle names a vertex the mesh does not have");
    }
  }
  if (!mesh.normals.empty() && mesh.normals.size() != mesh.positions.size()) {
    throw InvalidInput("make_scan: the mesh has not one normal per vertex");
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
  if (sample.size() < 2) {
    throw NoPersonError("nearly all points of the file lie at one place: check the export");
  }
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
  // Whoever gives an axis has seen a person.
  if (likeness.is_person() || (up && likeness.total() >= 1.0)) return found;
  throw NoPersonError("the shape does not look like a standing person (" +
                      std::string(likeness.head < 0.3 ? "no head on shoulders" : "a head") +
                      (likeness.legs < 0.4 ? ", no pair of legs" : ", a pair of legs") + " with " +
                      found.name +
                      " up): " + (up ? "give another --up" : "check the file, or give --up"));
}

void note_up(const UpAxis& up, bool guessed, std::vector<Finding>& findings) {
  if (up.name == "free") {
    const double tilt = std::acos(std::min(up.direction.cwiseAbs().maxCoeff(), 1.0)) * kDegrees;
    findings.push_back({"tilted", Severity::Note,
                        "The scan is tilted: up is " + text(tilt, 2) + " degrees off " +
                            nearest_axis(up.direction),
                        "The person was set upright", "Give --up if the person leans"});
  }
  if (guessed && up.lead < kUnsureLead) {
    findings.push_back({"unsure_up", Severity::Problem, "It is unsure that " + up.name + " is up",
                        "", "Look at the pictures; give --up"});
  }
  if (up.likeness.head < 0.3) {
    findings.push_back({"missing_head", Severity::Advice, "No head is seen",
                        "The height found is that of the part that is there",
                        "Scan the whole person"});
  }
}

Front front_of(const BodySample& sample, const UpAxis& up, const ScanOptions& options,
               std::vector<Finding>& findings) {
  if (const auto given = given_axis(options.front)) {
    return {(*given - given->dot(up.direction) * up.direction).normalized(), 1.0, 0.0};
  }
  const UprightView view(up);
  Front front = find_front(view.from_file(sample.points), up.likeness);
  front.direction = view.direction_in_file(front.direction);
  if (front.confidence < kUnsureFront) {
    findings.push_back(
        {"unsure_front", Severity::Problem,
         "It is unsure where the person faces (confidence " + text(front.confidence, 2) + ")", "",
         "Look at the pictures; give --front"});
  } else if (front.mismatch > kUnlikeSides) {
    findings.push_back({"uneven_sides", Severity::Note, "Left and right side are held very unlike",
                        "Where the person faces is approximate", ""});
  }
  return front;
}

/// The file axis nearest to where the person faces, across the up axis where that is one.
std::string name_of_front(const Vec3& front, const UpAxis& up) {
  std::string best = nearest_axis(front);
  double most = -2;
  for (const std::string_view name : kFileAxes) {
    const Vec3 axis = axis_vector(name);
    const bool along_up = up.name != "free" && std::abs(axis.dot(up.direction)) > 0.5;
    if (along_up || axis.dot(front) <= most) continue;
    most = axis.dot(front);
    best = name;
  }
  return best;
}

Vec3 mean_of(std::span<const Vec3> points) {
  Vec3 sum = Vec3::Zero();
  for (const Vec3& p : points) sum += p;
  return sum / static_cast<double>(points.size());
}

/// Finds unit, up and front, and says so in `facts`. The origin is the middle of the body; the
/// floor is not known yet.
BodyFrame find_frame(const BodySample& sample, const ScanOptions& options, ScanFacts& facts) {
  facts.units_guessed = options.units == "auto";
  facts.up_guessed = options.up == "auto";
  facts.front_guessed = options.front == "auto";
  const UpAxis up = up_of(sample, options);
  note_up(up, facts.up_guessed, facts.findings);
  const FileUnit unit = facts.units_guessed ? find_unit(up.slices.height, up.likeness)
                                            : given_unit(options.units, up.slices.height);
  if (!unit.doubt.empty()) {
    facts.findings.push_back(
        {"unsure_units", Severity::Advice, unit.doubt, "", "If it is not, give --units"});
  }
  const Front front = front_of(sample, up, options, facts.findings);
  facts.units = unit.name;
  facts.up = up.name;
  facts.front = name_of_front(front.direction, up);
  facts.front_confidence = front.confidence;

  BodyFrame frame;
  frame.metres = unit.metres;
  frame.turn.row(0) = up.direction.cross(front.direction);
  frame.turn.row(1) = up.direction;
  frame.turn.row(2) = front.direction;
  frame.origin = mean_of(sample.points);
  return frame;
}

std::vector<std::uint8_t> stray_positions(const SeparatedBody& separated) {
  std::vector<std::uint8_t> stray(separated.belongs.size());
  std::transform(separated.belongs.begin(), separated.belongs.end(), stray.begin(),
                 [](Belongs belongs) { return belongs == Belongs::Body ? 0 : 1; });
  return stray;
}

/// Moves points of the file's frame into the body frame, the frame's origin to the floor: the
/// scanned one, or where the feet end.
void put_on_floor(std::span<const Triangle> triangles, const SeparatedBody& separated,
                  std::span<const std::uint8_t> stray, BodyFrame& frame,
                  std::vector<Vec3>& positions, ScanFacts& facts) {
  const std::optional<double> sheet = sheet_floor(separated.sheets, frame);
  for (Vec3& p : positions) p = frame.from_file(p);
  const Reach reach = find_reach(positions, triangles, stray);
  const double floor = sheet.value_or(reach.floor);
  frame.origin += frame.turn.row(1).transpose() * floor / frame.metres;
  for (Vec3& p : positions) p.y() -= floor;
  facts.height = reach.top - floor;
}

/// Gives the vertices their places in the body frame; those without any go to the origin.
void move_vertices(const Welded& welded, const BodyFrame& frame, Mesh& mesh) {
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    const std::uint32_t at = welded.of_vertex[v];
    mesh.positions[v] = at == Welded::kNone ? Vec3(Vec3::Zero()) : welded.positions[at];
  }
  for (Vec3& n : mesh.normals) n = (frame.turn * n).eval();
}

}  // namespace

MadeScan make_scan_itself(Mesh mesh_in_file_frame, Welded welded, const ScanOptions& options) {
  MadeScan made;
  Scan& scan = made.scan;
  scan.mesh = std::move(mesh_in_file_frame);
  check_enough(welded, scan.mesh.is_cloud());
  const std::vector<Triangle> triangles = weld_triangles(scan.mesh.triangles, welded);
  const SeparatedBody separated = separate_body(welded.positions, triangles);
  const BodySample& sample = separated.sample;
  check_size(sample.points);

  BodyFrame frame = find_frame(sample, options, scan.facts);
  RawSurface raw{welded, stray_positions(separated), {}, sample.cell * frame.metres};
  put_on_floor(triangles, separated, raw.stray, frame, welded.positions, scan.facts);
  for (const Vec3& p : sample.points) raw.sample.push_back(frame.from_file(p));
  move_vertices(welded, frame, scan.mesh);
  scan.file_from_body = frame.to_file();
  finish_surface(raw, scan);
  made.belongs = belongs_of_vertices(separated, welded);
  made.sheets = separated.sheets;
  return made;
}

namespace {

/// Per vertex, where the mesh tells. `triangles`: welded; none for a cloud.
std::vector<std::uint8_t> invented_vertices(const std::vector<Triangle>& triangles,
                                            const Welded& welded) {
  std::vector<std::uint8_t> out;
  if (triangles.empty()) return out;
  const std::vector<std::uint8_t> found = find_invented(welded.positions, triangles);
  for (const std::uint32_t at : welded.of_vertex)
    out.push_back(at == Welded::kNone ? 0 : found[at]);
  return out;
}

void note_invented(const Scan& scan, std::vector<Finding>& findings) {
  const auto count =
      static_cast<std::size_t>(std::count(scan.invented.begin(), scan.invented.end(), 1));
  if (count == 0) return;
  const double share = static_cast<double>(count) / static_cast<double>(scan.invented.size());
  findings.push_back({"invented_surface", Severity::Note,
                      "Part of the surface was made up where the scanner saw nothing (" +
                          counted(count, "vertex", "vertices") + ", " + percent(share) +
                          ", by their density)",
                      "", ""});
}

}  // namespace

Scan make_scan(Mesh mesh_in_file_frame, const ScanOptions& options) {
  options.check();
  check_triangles(mesh_in_file_frame);
  Welded welded = weld(mesh_in_file_frame.positions);
  const FileFlaws flaws = find_file_flaws(mesh_in_file_frame, welded);
  std::vector<std::uint8_t> invented;
  MadeScan made;
  const auto find = [&, triangles = weld_triangles(mesh_in_file_frame.triangles, welded)] {
    invented = invented_vertices(triangles, welded);
  };
  if (mesh_in_file_frame.positions.size() > options.most_vertices) {
    run_together(
        {[&] { made = make_scan_by_thinning(std::move(mesh_in_file_frame), options); }, find});
  } else {
    find();
    made = make_scan_itself(std::move(mesh_in_file_frame), std::move(welded), options);
  }
  Scan& scan = made.scan;
  const double metres = 1 / scan.file_from_body.linear().col(0).norm();
  note_file_flaws(flaws, metres, scan.facts.findings);
  note_surroundings(made.belongs, made.sheets, scan);
  note_sampling(scan, scan.facts.findings);
  scan.invented = std::move(invented);
  for (std::size_t v = 0; v < scan.invented.size(); ++v) {
    if (scan.outlier[v] != 0) scan.invented[v] = 0;
  }
  note_invented(scan, scan.facts.findings);
  return std::move(scan);
}

}  // namespace regarment
