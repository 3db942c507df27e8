#include "render/render_figures.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <string>

#include "base/error.h"
#include "geometry/parallel.h"
#include "render/albedo.h"
#include "render/floor.h"
#include "render/geometry_pass.h"
#include "render/picture.h"
#include "render/strokes.h"
#include "render/surface.h"

namespace regarment {
namespace {

constexpr Colour kClay = {214, 208, 199};

// Colours of values are read off against a legend: half of the light's modelling is enough.
constexpr float kEvenness = 0.5F;

// A draped garment lies within this of the cloth it was fitted to, and is shown in front of it.
constexpr float kOnTheCloth = 0.02F;  // m

// In samples of a picture that has one pixel per pixel of the page.
constexpr double kHalfLine = 1.7;  // half the width of a border line
constexpr float kWire = 2.0F;      // width of a wire

// Threads that draw views: each needs a context and a copy of the meshes of its own.
constexpr std::size_t kCasts = 2;

using NoLines = std::vector<std::span<const Vec3>>;

// The scene as all views draw it. A mesh that is not given or not asked for is empty.
struct Stage {
  const Scene& scene;
  Vec3 origin;
  DisplayMesh scan;
  std::vector<DisplayMesh> placed, draped;  // one per garment
  std::vector<Camera> cameras;
};

// The scene as one view sees it.
struct Sight {
  Camera camera;  // supersampled
  Surface scan;
  std::vector<Surface> placed, draped;  // one per garment
  FloorShadow shadow;
};

void check_size(const char* what, std::size_t size, std::size_t expected) {
  if (size == 0 || size == expected) return;
  throw InvalidInput(std::string("scene.") + what + " has " + std::to_string(size) +
                     " entries, the scan " + std::to_string(expected));
}

void check_scene(const Scene& scene) {
  const std::size_t vertices = scene.scan.positions.size();
  check_size("labels", scene.labels.size(), vertices);
  check_size("values", scene.values.size(), vertices);
  check_size("probability", scene.probability.size(), vertices);
  check_size("outlier", scene.outlier.size(), vertices);
  check_size("cap", scene.cap.size(), scene.scan.triangles.size());
  for (const SceneGarment& garment : scene.garments) {
    if (!garment.placed.empty() && !garment.draped.empty()) {
      check_size("garments: draped", garment.draped.size(), garment.placed.size());
    }
  }
}

bool wanted(std::span<const Look> looks, Look look) {
  return std::find(looks.begin(), looks.end(), look) != looks.end();
}

Box box_of_points(const Scene& scene) {
  Box box;
  for (std::size_t i = 0; i < scene.scan.positions.size(); ++i) {
    if (!scene.outlier.empty() && scene.outlier[i] != 0) continue;
    check_drawable(scene.scan.positions[i], i);
    box.add(scene.scan.positions[i]);
  }
  for (const SceneGarment& garment : scene.garments) {
    for (const std::span<const Vec3> positions : {garment.placed, garment.draped}) {
      if (positions.empty()) continue;
      const Box around = bounding_box(positions);
      box.add(around.low), box.add(around.high);
    }
  }
  return box;
}

Stage set_stage(const Scene& scene, std::span<const Look> looks, const FigureOptions& options) {
  const Box box = box_of_points(scene);
  Stage stage{scene, Vec3::Zero(), {}, {}, {}, frame_views(box, options.views, options.framing)};
  stage.origin = 0.5 * (box.low + box.high);
  stage.scan = make_display_mesh(scene.scan, scene.labels, scene.outlier, stage.origin,
                                 options.max_elements);
  const auto shown = [&](const SceneGarment& garment, std::span<const Vec3> positions, Look look) {
    if (positions.empty() || garment.triangles.empty() || !wanted(looks, look))
      return DisplayMesh();
    return make_display_mesh(positions, garment.triangles, stage.origin);
  };
  for (const SceneGarment& garment : scene.garments) {
    stage.placed.push_back(shown(garment, garment.placed, Look::Placement));
    stage.draped.push_back(shown(garment, garment.draped, Look::Drape));
  }
  return stage;
}

// The meshes of a stage in OpenGL's memory, in one order for all views.
class Cast {
 public:
  explicit Cast(const Stage& stage) : stage_(stage) {
    add(stage.scan);
    for (const DisplayMesh& mesh : stage.placed) add(mesh);
    for (const DisplayMesh& mesh : stage.draped) add(mesh);
  }

  Sight see(const Camera& camera) {
    Sight sight;
    sight.camera = supersampled(camera, kSamples);
    std::vector<Surface> surfaces;
    for (std::size_t i = 0; i < meshes_.size(); ++i) {
      surfaces.push_back(uploaded_[i].has_value() ? see_surface(pass_, *uploaded_[i], *meshes_[i],
                                                                stage_.origin, sight.camera)
                                                  : Surface());
    }
    const auto draped = surfaces.begin() + 1 + std::ptrdiff_t(stage_.placed.size());
    sight.scan = std::move(surfaces.front());
    sight.placed.assign(std::make_move_iterator(surfaces.begin() + 1),
                        std::make_move_iterator(draped));
    sight.draped.assign(std::make_move_iterator(draped), std::make_move_iterator(surfaces.end()));
    sight.shadow = floor_shadow(sight.scan, sight.camera);
    return sight;
  }

 private:
  void add(const DisplayMesh& mesh) {
    meshes_.push_back(&mesh);
    uploaded_.emplace_back();
    if (!mesh.positions.empty()) uploaded_.back().emplace(mesh, stage_.origin);
  }

  const Stage& stage_;
  GeometryPass pass_;
  std::vector<const DisplayMesh*> meshes_;
  std::vector<std::optional<UploadedMesh>> uploaded_;  // none for an empty mesh
};

// Empty: clay.
Albedo scan_albedo(const Scene& scene, const Surface& scan, Look look, const ColourScale& scale) {
  if (look == Look::Scan && scene.scan.colours.size() == scene.scan.positions.size()) {
    return vertex_albedo(scan, scene.scan.colours);
  }
  if (look == Look::Segmentation && !scene.labels.empty()) {
    return label_albedo(scan, pixel_labels(scan, scene.labels),
                        {scene.cap, scene.probability, scene.border_lines.empty()});
  }
  if (look == Look::Deviation && !scene.values.empty()) {
    return value_albedo(scan, scene.values, scale);
  }
  return {};
}

void add_garments(const Stage& stage, const Sight& sight, Look look, int pixel_ratio,
                  std::vector<Paint>& paints) {
  const bool placed = look == Look::Placement;
  for (std::size_t g = stage.scene.garments.size(); g-- > 0;) {  // innermost first
    const Surface& surface = placed ? sight.placed[g] : sight.draped[g];
    if (surface.mesh == nullptr) continue;
    Paint paint;
    paint.surface = &surface;
    paint.plain = garment_colour(stage.scene.garments[g].layer);
    paint.opacity = placed ? 0.55F : 1.0F;
    paint.wire = placed ? 0.75F : 0.0F;
    paint.wire_width = kWire * static_cast<float>(pixel_ratio);
    paint.bias = placed ? 0.0F : kOnTheCloth;
    paints.push_back(std::move(paint));
  }
}

// What is painted in one look, from the back to the front.
std::vector<Paint> compose(const Stage& stage, const Sight& sight, Look look,
                           const FigureOptions& options) {
  std::vector<Paint> paints;
  if (sight.scan.mesh != nullptr) {
    Paint paint;
    paint.surface = &sight.scan;
    paint.albedo = scan_albedo(stage.scene, sight.scan, look, options.scale);
    paint.plain = kClay;
    paint.evenness = look == Look::Deviation ? kEvenness : 0.0F;
    paints.push_back(std::move(paint));
  }
  if (look == Look::Placement || look == Look::Drape)
    add_garments(stage, sight, look, options.pixel_ratio, paints);
  return paints;
}

Image make_picture(const Stage& stage, const Sight& sight, Look look,
                   const FigureOptions& options) {
  const FloorShadow* shadow = options.shadow ? &sight.shadow : nullptr;
  const Strokes lines(look == Look::Segmentation ? stage.scene.border_lines : NoLines(),
                      sight.camera, kHalfLine * options.pixel_ratio);
  Image image = paint_picture(sight.camera, compose(stage, sight, look, options), lines, shadow,
                              options.background);
  if (options.scale_bar) draw_scale_bar(image, sight.camera.pixels_per_metre / kSamples);
  return image;
}

}  // namespace

std::string_view look_name(Look look) {
  switch (look) {
    case Look::Scan:
      return "scan";
    case Look::Clay:
      return "clay";
    case Look::Segmentation:
      return "segmentation";
    case Look::Placement:
      return "placement";
    case Look::Drape:
      return "drape";
    case Look::Deviation:
      return "deviation";
  }
  throw InvalidInput("unknown look " + std::to_string(int(look)));
}

void FigureOptions::check() const {
  if (views.empty()) throw InvalidInput("views is empty, at least one is needed");
  if (pixel_ratio < 1 || pixel_ratio > 4)
    throw InvalidInput("pixel_ratio is " + std::to_string(pixel_ratio) + ", must be 1 to 4");
  if (max_elements < 1000) {
    throw InvalidInput("max_elements is " + std::to_string(max_elements) + ", must be >= 1000");
  }
  if (!(scale.low < scale.high) || !std::isfinite(scale.high - scale.low)) {
    throw InvalidInput("scale runs from " + std::to_string(scale.low) + " to " +
                       std::to_string(scale.high) + ", must be rising and finite");
  }
}

std::vector<Figure> render_figures(const Scene& scene, std::span<const Look> looks,
                                   const FigureOptions& options) {
  options.check();
  check_scene(scene);
  const Stage stage = set_stage(scene, looks, options);
  const std::size_t views = stage.cameras.size();
  std::vector<Figure> figures(looks.size() * views);
  parallel_for(views, (views + kCasts - 1) / kCasts, [&](std::size_t begin, std::size_t end) {
    Cast cast(stage);
    for (std::size_t v = begin; v < end; ++v) {
      const Sight sight = cast.see(stage.cameras[v]);
      for (std::size_t l = 0; l < looks.size(); ++l) {
        figures[l * views + v] = {looks[l], options.views[v],
                                  make_picture(stage, sight, looks[l], options)};
      }
    }
  });
  return figures;
}

}  // namespace regarment
