#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "geometry/mesh.h"
#include "render/camera.h"
#include "render/heat_map.h"
#include "render/image.h"

namespace regarment {

/// A garment of a scene. Views into the caller's data, which must outlive the scene. `placed` and
/// `draped` are positions in the body frame, m, one per vertex of `triangles`; either may be empty.
struct SceneGarment {
  std::span<const Triangle> triangles;  // counter-clockwise seen from outside
  std::span<const Vec3> placed;         // shown by Look::Placement
  std::span<const Vec3> draped;         // shown by Look::Drape
  int layer = 1;                        // 1 = outermost; sets the colour, see garment_colour
};

/// What figures are made of. Views into the caller's data, which must outlive the call. Everything
/// is in the body frame, metres. Optional parts are empty or have one entry per vertex of the scan.
struct Scene {
  const Mesh& scan;                         // mesh, or cloud when it has no triangles; normals and
                                            // colours are used when there, else computed
  std::span<const std::uint8_t> labels;     // per vertex: 0 person, i = i-th garment
  std::span<const float> values;            // per vertex: scalar for Look::Deviation, NaN = no data
  std::span<const std::uint8_t> cap;        // per triangle: 1 = invented surface
  std::span<const std::uint8_t> outlier;    // per vertex: 1 = not shown
  std::vector<SceneGarment> garments;       // outermost first
  std::span<const float> probability = {};  // per vertex: how sure its label is
  std::vector<std::span<const Vec3>> border_lines = {};  // closed, along the borders of labels
};

/// What a figure shows.
enum class Look {
  Scan,          // the scan in its own colours, or as clay when it has none
  Clay,          // the scan as clay, whatever its colours
  Segmentation,  // person neutral, garments coloured, caps hatched, unsure labels shaded; the
                 // border lines drawn or, without any, lines where labels meet
  Placement,     // the placed garments, translucent with their wires, over the scan
  Drape,         // the draped garments as cloth, over the scan
  Deviation,     // `values` by a colour scale, grey where there is no data
};

/// "scan", "clay", "segmentation", "placement", "drape", "deviation".
std::string_view look_name(Look look);

struct FigureOptions {
  Framing framing;  // size of each picture
  // Pixels per pixel of the page it is for, 1..4: lines are as many times as wide.
  int pixel_ratio = 1;
  std::vector<View> views = four_sides();
  Rgba background = {0, 0, 0, 0};  // opacity 0: cut out, so that any page colour shows
  bool shadow = true;              // soft shadow on the floor under the feet
  bool scale_bar = false;          // a 20 cm bar at the lower left
  ColourScale scale;               // of Look::Deviation
  // Pictures show at most this many triangles (or points) of the scan. More shows finer detail and
  // costs time in proportion.
  std::size_t max_elements = 60'000;

  /// Throws InvalidInput naming the field and its value.
  void check() const;
};

/// One picture of one look from one view.
struct Figure {
  Look look;
  View view;
  Image image;
};

/// All figures of a scene: for each look in the order given, each view of the options. All figures
/// of one view match pixel for pixel, whatever their look; all views share one scale, so figures of
/// scan and garments can be laid over each other. One geometry pass per view is shared by all
/// looks. A look that lacks its data (Segmentation without labels, Placement without placed
/// garments) shows the scan alone. Deterministic: same scene, same bytes. Any thread may call it,
/// several at once too. Throws InvalidInput when sizes do not match or nothing can be shown; Error
/// (1) when the machine cannot draw.
std::vector<Figure> render_figures(const Scene& scene, std::span<const Look> looks,
                                   const FigureOptions& options = {});

}  // namespace regarment
