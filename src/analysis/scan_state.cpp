#include "analysis/scan_state.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "analysis/state_bytes.h"
#include "analysis/state_facts.h"
#include "base/sha256.h"

namespace regarment {
namespace {

constexpr std::string_view kMagic = "regarment.state\n";
constexpr std::uint32_t kVersion = 1;
constexpr std::size_t kDigest = 64;
constexpr std::size_t kMostText = 4096;
constexpr std::size_t kMostNames = 1000;
constexpr std::size_t kMostVertices = 1U << 31U;
constexpr double kNormalSteps = 32767;
constexpr double kFarthest = 1000;  // m from the origin, of a vertex that is no outlier
constexpr double kTallest = 100;    // m

std::string digest_of(std::string_view bytes) {
  return sha256_hex(std::as_bytes(std::span(bytes.data(), bytes.size())));
}

std::int16_t step_of(double v) {
  return static_cast<std::int16_t>(std::lround(std::clamp(v, -1.0, 1.0) * kNormalSteps));
}

/// A direction as a point of the square that an octahedron unfolds to.
void write_normal(const Vec3& n, StateWriter& out) {
  const double sum = n.cwiseAbs().sum();
  // No direction at all has the corner that no direction unfolds to.
  if (!(sum > 0)) {
    out.value(std::int16_t{-32768}), out.value(std::int16_t{-32768});
    return;
  }
  double x = n.x() / sum, y = n.y() / sum;
  if (n.z() < 0) {
    const double folded = (1 - std::abs(y)) * (x < 0 ? -1 : 1);
    y = (1 - std::abs(x)) * (y < 0 ? -1 : 1);
    x = folded;
  }
  out.value(step_of(x)), out.value(step_of(y));
}

Vec3 read_normal(StateReader& in) {
  const auto a = in.value<std::int16_t>(), b = in.value<std::int16_t>();
  if (a == -32768 || b == -32768) return Vec3::Zero();
  const double x = a / kNormalSteps, y = b / kNormalSteps;
  const double z = 1 - std::abs(x) - std::abs(y);
  if (z >= 0) return Vec3(x, y, z).normalized();
  return Vec3((1 - std::abs(y)) * (x < 0 ? -1 : 1), (1 - std::abs(x)) * (y < 0 ? -1 : 1), z)
      .normalized();
}

void write_marks(const std::vector<std::uint8_t>& marks, StateWriter& out) {
  for (std::size_t i = 0; i < marks.size(); i += 8) {
    unsigned byte = 0;
    for (std::size_t k = i; k < std::min(i + 8, marks.size()); ++k)
      byte |= (marks[k] != 0 ? 1U : 0U) << (k - i);
    out.value(static_cast<std::uint8_t>(byte));
  }
}

std::vector<std::uint8_t> read_marks(std::size_t n, StateReader& in) {
  std::vector<std::uint8_t> out(n);
  for (std::size_t i = 0; i < n; i += 8) {
    const unsigned byte = in.value<std::uint8_t>();
    for (std::size_t k = i; k < std::min(i + 8, n); ++k) out[k] = (byte >> (k - i)) & 1U;
  }
  return out;
}

/// Corners as differences: neighbours in a file mostly have neighbouring numbers.
void write_triangles(const std::vector<Triangle>& triangles, StateWriter& out) {
  std::int64_t last = 0;
  for (const Triangle& t : triangles) {
    for (const std::uint32_t corner : t) {
      out.difference(static_cast<std::int64_t>(corner) - last);
      last = corner;
    }
    last = t[0];
  }
}

std::vector<Triangle> read_triangles(std::size_t count, std::size_t vertices, StateReader& in) {
  std::vector<Triangle> out(count);
  std::int64_t last = 0;
  for (Triangle& t : out) {
    for (std::uint32_t& corner : t) {
      const std::int64_t difference = in.difference();
      // Both lie far inside of what 64 bits hold, or the sum could overflow.
      if (std::abs(difference) > static_cast<std::int64_t>(kMostVertices))
        in.refuse("a triangle names a vertex it does not have");
      last += difference;
      if (last < 0 || last >= static_cast<std::int64_t>(vertices))
        in.refuse("a triangle names a vertex it does not have");
      corner = static_cast<std::uint32_t>(last);
    }
    last = t[0];
  }
  return out;
}

void write_positions(const std::vector<Vec3>& positions, StateWriter& out) {
  for (const Vec3& p : positions)
    for (const double v : {p.x(), p.y(), p.z()}) out.value(static_cast<float>(v));
}

std::vector<Vec3> read_positions(std::size_t n, StateReader& in) {
  std::vector<Vec3> out(n);
  for (Vec3& p : out)
    for (int k = 0; k < 3; ++k) p[k] = static_cast<double>(in.value<float>());
  return out;
}

void check_sizes(const Scan& scan) {
  const std::size_t n = scan.mesh.positions.size();
  const bool fine = scan.outlier.size() == n &&
                    (scan.invented.empty() || scan.invented.size() == n) &&
                    (scan.mesh.colours.empty() || scan.mesh.colours.size() == n) &&
                    scan.mesh.normals.size() == n && n < kMostVertices &&
                    (!scan.thin || scan.thin->of_vertex.size() == n);
  if (!fine) throw InvalidInput("write_state: the scan has not one entry per vertex everywhere");
}

void write_scan(const Scan& scan, StateWriter& out) {
  check_sizes(scan);
  write_facts(scan.facts, out);
  for (int column = 0; column < 4; ++column)
    for (int row = 0; row < 3; ++row) out.value(scan.file_from_body.matrix()(row, column));
  out.number(scan.mesh.positions.size());
  write_positions(scan.mesh.positions, out);
  write_marks(scan.outlier, out);
  out.value(static_cast<std::uint8_t>(!scan.invented.empty()));
  write_marks(scan.invented, out);
  out.value(static_cast<std::uint8_t>(!scan.mesh.colours.empty()));
  for (const Colour& c : scan.mesh.colours)
    for (const std::uint8_t v : c) out.value(v);
  out.number(scan.mesh.triangles.size());
  write_triangles(scan.mesh.triangles, out);
  out.value(static_cast<std::uint8_t>(scan.thin != nullptr));
  if (!scan.thin) {
    for (const Vec3& n : scan.mesh.normals) write_normal(n, out);
    return;
  }
  for (const std::uint32_t at : scan.thin->of_vertex) out.value(at);
  write_scan(scan.thin->scan, out);
}

void check_places(const Scan& scan, const StateReader& in) {
  for (std::size_t v = 0; v < scan.mesh.positions.size(); ++v) {
    const Vec3& p = scan.mesh.positions[v];
    if (!p.allFinite() || (scan.outlier[v] == 0 && p.norm() > kFarthest))
      in.refuse("a vertex lies nowhere near a person");
  }
  const Eigen::Matrix4d m = scan.file_from_body.matrix();
  const double scale = scan.file_from_body.linear().col(0).norm();
  if (!m.allFinite() || !(scale > 1e-9 && scale < 1e9) ||
      !(std::abs(scan.file_from_body.linear().determinant()) > 0.5 * scale * scale * scale))
    in.refuse("its frame is no frame");
}

Scan read_scan(StateReader& in, bool whole);

/// The thin copy, and the normals of the whole scan, which are the copy's.
void read_thin(Scan& scan, StateReader& in) {
  auto thin = std::make_shared<ThinScan>();
  thin->of_vertex.resize(scan.mesh.positions.size());
  for (std::uint32_t& at : thin->of_vertex) at = in.value<std::uint32_t>();
  thin->scan = read_scan(in, false);
  scan.mesh.normals.assign(scan.mesh.positions.size(), Vec3::UnitY());
  for (std::size_t v = 0; v < thin->of_vertex.size(); ++v) {
    const std::uint32_t at = thin->of_vertex[v];
    if (at == ThinScan::kNone) continue;
    if (at >= thin->scan.mesh.positions.size()) in.refuse("a vertex stands for none");
    scan.mesh.normals[v] = thin->scan.mesh.normals[at];
  }
  scan.thin = std::move(thin);
}

Scan read_scan(StateReader& in, bool whole) {
  Scan scan;
  scan.facts = read_facts(in);
  scan.file_from_body.setIdentity();
  for (int column = 0; column < 4; ++column)
    for (int row = 0; row < 3; ++row)
      scan.file_from_body.matrix()(row, column) = in.value<double>();
  const std::size_t n = in.count(3 * sizeof(float));
  if (n == 0 || n >= kMostVertices) in.refuse("its number of vertices is no person's");
  scan.mesh.positions = read_positions(n, in);
  scan.outlier = read_marks(n, in);
  if (in.value<std::uint8_t>() != 0) scan.invented = read_marks(n, in);
  if (in.value<std::uint8_t>() != 0) {
    scan.mesh.colours.resize(n);
    for (Colour& c : scan.mesh.colours)
      for (std::uint8_t& v : c) v = in.value<std::uint8_t>();
  }
  scan.mesh.triangles = read_triangles(in.count(3), n, in);
  check_places(scan, in);
  if (in.value<std::uint8_t>() != 0) {
    if (!whole) in.refuse("a thin copy of a thin copy");
    read_thin(scan, in);
    return scan;
  }
  scan.mesh.normals.resize(n);
  for (Vec3& normal : scan.mesh.normals) normal = read_normal(in);
  return scan;
}

void write_heights(const std::map<std::string, double>& heights, StateWriter& out) {
  out.number(heights.size());
  for (const auto& [name, height] : heights) out.text(name), out.value(height);
}

std::map<std::string, double> read_heights(StateReader& in) {
  std::map<std::string, double> out;
  const std::size_t n = in.count(1);
  if (n > kMostNames) in.refuse("too many heights");
  for (std::size_t i = 0; i < n; ++i) {
    const std::string name = in.text(kMostText);
    const double height = in.value<double>();
    if (!(height > 0 && height < kTallest)) in.refuse("a height above every person");
    out[name] = height;
  }
  return out;
}

}  // namespace

std::string write_state(const ScanState& state) {
  const std::size_t n = state.scan.mesh.positions.size();
  if (!state.true_labels.empty() && state.true_labels.size() != n)
    throw InvalidInput("write_state: there is not one true label per vertex");
  StateWriter body;
  body.reserve(32 * n + 65536);
  write_scan(state.scan, body);
  write_heights(state.placement.landmarks, body);
  write_heights(state.placement.edges, body);
  body.number(state.true_labels.size());
  for (const std::uint8_t label : state.true_labels) body.value(label);
  const std::string rest = body.take();
  StateWriter head;
  for (const char c : kMagic) head.value(c);
  head.value(kVersion);
  head.value(static_cast<std::uint64_t>(rest.size()));
  for (const char c : digest_of(rest)) head.value(c);
  return head.take() + rest;
}

ScanState read_state(std::string_view bytes, const std::string& name) {
  if (!bytes.starts_with(kMagic))
    throw ReadError(name + ": is no state of a fit; run 'regarment fit' again");
  StateReader in(bytes.substr(kMagic.size()), name);
  if (const auto version = in.value<std::uint32_t>(); version != kVersion)
    throw ReadError(name + ": is of version " + std::to_string(version) +
                    ", this program reads version " + std::to_string(kVersion) +
                    "; run 'regarment fit' again");
  const auto length = in.value<std::uint64_t>();
  std::string digest(kDigest, '\0');
  for (char& c : digest) c = in.value<char>();
  if (in.rest().size() != length)
    in.refuse("it has " + std::to_string(in.rest().size()) + " bytes in place of " +
              std::to_string(length));
  if (digest_of(in.rest()) != digest) in.refuse("its digest is another");
  ScanState state;
  state.scan = read_scan(in, true);
  state.placement.landmarks = read_heights(in);
  state.placement.edges = read_heights(in);
  const std::size_t labels = in.count(1);
  if (labels != 0 && labels != state.scan.mesh.positions.size()) in.refuse("labels are missing");
  for (std::size_t i = 0; i < labels; ++i) state.true_labels.push_back(in.value<std::uint8_t>());
  if (!in.at_end()) in.refuse("it goes on after its end");
  return state;
}

}  // namespace regarment
