#include "render/silhouette.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "base/error.h"

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

// Corners lie on a grid of so many lines a pixel, so that sides that meet do so without gaps, and
// what a picture's size reckons is exact.
constexpr double kParts = 256;

struct Corner {
  double x = 0, y = 0;  // from the picture's upper left corner, in parts of a pixel
};

/// Which pixel's centre is the first that does not lie before, each way; the picture's size for
/// none.
struct Cell {
  int column = 0, row = 0;
};

/// To the nearest whole number; far beyond any picture, to a near one.
double rounded(double x) {
  constexpr double kWhole = 0x1.8p52;  // numbers beside it have no fraction
  return (x + kWhole) - kWhole;
}

int first_centre(double x, int size) {
  const double centres = x / kParts - 0.5;
  if (!(centres > 0)) return 0;
  if (!(centres < size)) return size;
  const int whole = static_cast<int>(centres);
  return whole + (whole < centres ? 1 : 0);
}

/// A side of a triangle whose inside is where this is positive. Of two triangles that share a side,
/// the one below or to the right has the centres on it.
struct Side {
  double x, y, along_x, along_y;
  bool owns;

  Side(const Corner& from, const Corner& to)
      : x(from.x),
        y(from.y),
        along_x(to.x - from.x),
        along_y(to.y - from.y),
        owns(along_y < 0 || (along_y == 0 && along_x > 0)) {}
  bool inside(double at_x, double at_y) const {
    const double value = along_x * (at_y - y) - along_y * (at_x - x);
    return value > 0 || (owns && value == 0);
  }
};

/// Marks the centres inside a triangle, of those from `low` up to before `high`.
void cover(std::array<Corner, 3> at, const Cell& low, const Cell& high, Silhouette& out) {
  const double twice =
      (at[1].x - at[0].x) * (at[2].y - at[0].y) - (at[2].x - at[0].x) * (at[1].y - at[0].y);
  if (twice == 0) return;
  if (twice < 0) std::swap(at[1], at[2]);
  const Side a(at[0], at[1]), b(at[1], at[2]), c(at[2], at[0]);
  for (int row = low.row; row < high.row; ++row) {
    std::uint8_t* pixels = &out.covered[std::size_t(row) * std::size_t(out.size)];
    const double y = kParts * (row + 0.5);
    for (int column = low.column; column < high.column; ++column) {
      if (pixels[column] != 0) continue;
      const double x = kParts * (column + 0.5);
      pixels[column] = a.inside(x, y) && b.inside(x, y) && c.inside(x, y) ? 1 : 0;
    }
  }
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
  std::vector<Triangle> triangles;
  std::size_t vertex_count = 0;
  int size = 0;
  // Per vertex of the picture that is drawn.
  std::vector<Corner> corners;
  std::vector<Cell> cells;

  void place(std::span<const Vec3> positions, const Camera& camera);
  Silhouette draw(std::span<const Vec3> positions, const Camera& camera);
};

SilhouetteRenderer::SilhouetteRenderer(std::span<const Triangle> triangles,
                                       std::size_t vertex_count, int size) {
  check_mesh(triangles, vertex_count, size);
  state_ = std::make_unique<State>();
  state_->triangles.assign(triangles.begin(), triangles.end());
  state_->vertex_count = vertex_count;
  state_->size = size;
  state_->corners.resize(vertex_count);
  state_->cells.resize(vertex_count);
}

SilhouetteRenderer::~SilhouetteRenderer() = default;

void SilhouetteRenderer::State::place(std::span<const Vec3> positions, const Camera& camera) {
  const double scale = kParts * camera.pixels_per_metre;
  const Vec3 right = scale * camera.view_from_body.row(0).transpose(),
             down = -scale * camera.view_from_body.row(1).transpose();
  const double middle_x = kParts * 0.5 * camera.width, middle_y = kParts * 0.5 * camera.height;
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const Vec3 p = positions[i] - camera.centre;
    corners[i] = {rounded(middle_x + right.dot(p)), rounded(middle_y + down.dot(p))};
    cells[i] = {first_centre(corners[i].x, size), first_centre(corners[i].y, size)};
  }
}

Silhouette SilhouetteRenderer::State::draw(std::span<const Vec3> positions, const Camera& camera) {
  place(positions, camera);
  Silhouette out{size, std::vector<std::uint8_t>(std::size_t(size) * std::size_t(size))};
  for (const Triangle& t : triangles) {
    const Cell &a = cells[t[0]], &b = cells[t[1]], &c = cells[t[2]];
    const Cell low{std::min({a.column, b.column, c.column}), std::min({a.row, b.row, c.row})};
    const Cell high{std::max({a.column, b.column, c.column}), std::max({a.row, b.row, c.row})};
    // Of a fine scan, most triangles lie between the centres.
    if (low.column == high.column || low.row == high.row) continue;
    cover({corners[t[0]], corners[t[1]], corners[t[2]]}, low, high, out);
  }
  return out;
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
  for (std::size_t i = 0; i < positions.size(); ++i) check_drawable(positions[i], i);
  for (std::size_t c = 0; c < cameras.size(); ++c) {
    const Camera& camera = cameras[c];
    if (camera.width != s.size || camera.height != s.size) {
      throw InvalidInput("a silhouette of " + std::to_string(s.size) + " pixels got a camera of " +
                         std::to_string(camera.width) + " x " + std::to_string(camera.height));
    }
    const auto drawn = std::find_if(cameras.begin(), cameras.begin() + c,
                                    [&](const Camera& other) { return opposite(camera, other); });
    silhouettes.push_back(drawn == cameras.begin() + c
                              ? s.draw(positions, camera)
                              : mirrored(silhouettes[drawn - cameras.begin()]));
  }
  return silhouettes;
}

std::vector<Silhouette> four_silhouettes(const Mesh& mesh, const Box& box, int size) {
  SilhouetteRenderer renderer(mesh.triangles, mesh.positions.size(), size);
  Framing framing;
  framing.width = framing.height = size;
  return renderer.draw(mesh.positions, frame_views(box, four_sides(), framing));
}

}  // namespace regarment
