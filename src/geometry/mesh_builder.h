#pragma once

#include <cmath>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "geometry/mesh.h"
#include "geometry/mesh_io.h"

namespace regarment {

/// Where in a file something stands, for messages: "line 12", "byte 4096", "part 2".
struct Place {
  enum class Unit { Line, Byte, Part };
  Unit unit = Unit::Line;
  std::size_t at = 0;
};

/// Collects what a reader finds and holds it to the promises of `Mesh`: finite coordinates, indices
/// in range, limits kept. Every method throws ReadError naming file and place.
class MeshBuilder {
 public:
  MeshBuilder(std::string_view name, const MeshReadLimits& limits);

  /// Throws ReadError "NAME: PLACE: WORDS".
  [[noreturn]] void fail(const Place& place, const std::string& words) const;

  /// To be called before memory is taken for what a file promises.
  void check_vertex_count(std::uint64_t count, const Place& place) const;
  void check_face_count(std::uint64_t count, const Place& place) const;

  void add_vertex(double x, double y, double z, const Place& place) {
    // One comparison refuses NaN, infinities and absurd distances alike.
    if (!(std::abs(x) <= kFarthest && std::abs(y) <= kFarthest && std::abs(z) <= kFarthest)) {
      refuse_vertex(x, y, z, place);
    }
    mesh_.positions.emplace_back(x, y, z);
  }
  /// Scales to unit length; what has no direction becomes zero.
  void add_normal(double x, double y, double z);
  /// `scale` takes the file's values to 0..255; what lies outside is cut off there, NaN is 0.
  void add_colour(double red, double green, double blue, double scale = 1.0) {
    mesh_.colours.push_back({to_byte(red * scale), to_byte(green * scale), to_byte(blue * scale)});
  }

  /// Number of the first vertex in this format, 0 unless told otherwise; for messages.
  void count_from(std::int64_t first_number) { first_number_ = first_number; }
  /// Corners count from 0 here whatever the format says, and may name vertices that come later in
  /// the file. Fans polygons; faces of one or two corners enclose nothing and are passed over.
  void add_face(std::span<const std::int64_t> corners, const Place& place);
  /// Refuses the next face for having more than kMostCorners; for readers that see the count first.
  [[noreturn]] void refuse_corners(std::uint64_t count, const Place& place) const;

  Mesh& mesh() { return mesh_; }
  /// Checks what can only be known at the end and hands the mesh over.
  Mesh finish();

  static constexpr double kFarthest = 1e12;        // file units from the origin
  static constexpr std::size_t kMostCorners = 64;  // of one face

 private:
  static std::uint8_t to_byte(double value) {
    return value >= 255.0 ? 255 : value > 0 ? static_cast<std::uint8_t>(value + 0.5) : 0;
  }
  [[noreturn]] void refuse_vertex(double x, double y, double z, const Place& place) const;

  std::string name_;
  MeshReadLimits limits_;
  Mesh mesh_;
  std::int64_t first_number_ = 0;
  std::size_t faces_ = 0;
  // The largest index any face named, and where, to be checked when the vertices are known.
  std::int64_t largest_ = -1;
  std::size_t largest_face_ = 0;
  Place largest_place_;
};

}  // namespace regarment
