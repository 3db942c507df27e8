#include "render/render_figures.h"

#include "base/error.h"
#include "render/albedo.h"
#include "render/floor.h"
#include "render/geometry_pass.h"
#include "render/paint.h"
#include "render/surface.h"

namespace regarment {
namespace {

// Each pixel is the mean of this many by this many.
constexpr int kSamples = 2;

constexpr Colour kClay = {214, 208, 199};

// A draped garment lies within this of the cloth it was fitted to, and is shown in front of it.
constexpr float kOnTheCloth = 0.02F;  // m

struct ShownGarment {
  DisplayMesh placed, draped;  // empty when not given or not asked for
  int layer;
};

// The scene as all views draw it.
struct Stage {
  const Scene& scene;
  Vec3 origin;
  DisplayMesh scan;
  std::vector<ShownGarment> garments;
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
  Stage stage{scene, Vec3::Zero(), {}, {}, frame_views(box, options.views, options.framing)};
  stage.origin = 0.5 * (box.low + box.high);
  stage.scan = make_display_mesh(scene.scan, scene.outlier, stage.origin, options.max_elements);
  const auto shown = [&](const SceneGarment& garment, std::span<const Vec3> positions, Look look) {
    if (positions.empty() || !wanted(looks, look)) return DisplayMesh();
    return make_display_mesh(positions, garment.triangles, stage.origin);
  };
  for (const SceneGarment& garment : scene.garments) {
    stage.garments.push_back({shown(garment, garment.placed, Look::Placement),
                              shown(garment, garment.draped, Look::Drape), garment.layer});
  }
  return stage;
}

// All views of one mesh, so that it is uploaded once.
std::vector<Surface> see_from_all(GeometryPass& pass, const DisplayMesh& mesh, const Stage& stage) {
  std::vector<Surface> surfaces;
  if (!mesh.positions.empty()) pass.load(mesh, stage.origin);
  for (const Camera& camera : stage.cameras) {
    surfaces.push_back(mesh.positions.empty()
                           ? Surface()
                           : see_surface(pass, mesh, stage.origin, supersampled(camera, kSamples)));
  }
  return surfaces;
}

std::vector<Sight> look_from_all(const Stage& stage) {
  GeometryPass pass;
  std::vector<Sight> sights(stage.cameras.size());
  std::vector<Surface> scan = see_from_all(pass, stage.scan, stage);
  for (std::size_t v = 0; v < sights.size(); ++v) {
    sights[v].camera = supersampled(stage.cameras[v], kSamples);
    sights[v].shadow = floor_shadow(scan[v], sights[v].camera);
    sights[v].scan = std::move(scan[v]);
  }
  for (const ShownGarment& garment : stage.garments) {
    std::vector<Surface> placed = see_from_all(pass, garment.placed, stage);
    std::vector<Surface> draped = see_from_all(pass, garment.draped, stage);
    for (std::size_t v = 0; v < sights.size(); ++v) {
      sights[v].placed.push_back(std::move(placed[v]));
      sights[v].draped.push_back(std::move(draped[v]));
    }
  }
  return sights;
}

Albedo scan_albedo(const Scene& scene, const Surface& scan, Look look, const ColourScale& scale) {
  if (look == Look::Scan && scene.scan.colours.size() == scene.scan.positions.size()) {
    return vertex_albedo(scan, scene.scan.colours);
  }
  if (look == Look::Segmentation && !scene.labels.empty()) {
    return label_albedo(scan, pixel_labels(scan, scene.labels), scene.cap, kSamples);
  }
  if (look == Look::Deviation && !scene.values.empty()) {
    return value_albedo(scan, scene.values, scale);
  }
  return plain_albedo(scan, kClay);
}

// What is painted in one look, from the back to the front, and the colours it refers to.
struct Painting {
  std::vector<Albedo> albedos;
  std::vector<Paint> paints;
};

void add_garments(const Stage& stage, const Sight& sight, Look look, Painting& painting) {
  const bool placed = look == Look::Placement;
  for (std::size_t g = stage.garments.size(); g-- > 0;) {  // innermost first
    const Surface& surface = placed ? sight.placed[g] : sight.draped[g];
    if (surface.mesh == nullptr) continue;
    painting.albedos.push_back(plain_albedo(surface, garment_colour(stage.garments[g].layer)));
    Paint paint{&surface, &painting.albedos.back()};
    if (placed) {
      paint.opacity = 0.55F;
      paint.wire = 0.75F;
    } else {
      paint.bias = kOnTheCloth;
    }
    painting.paints.push_back(paint);
  }
}

Painting compose(const Stage& stage, const Sight& sight, Look look, const ColourScale& scale) {
  Painting painting;
  painting.albedos.reserve(1 + stage.garments.size());  // paints point into it
  if (sight.scan.mesh != nullptr) {
    painting.albedos.push_back(scan_albedo(stage.scene, sight.scan, look, scale));
    painting.paints.push_back({&sight.scan, &painting.albedos.back()});
  }
  if (look == Look::Placement || look == Look::Drape) add_garments(stage, sight, look, painting);
  return painting;
}

void paint_floor(const Sight& sight, PaintRow& row) {
  for (int x = 0; x < sight.camera.width; ++x) {
    row.colour[std::size_t(x)] = {0, 0, 0, sight.shadow.at(x, row.y)};
  }
}

Linear mean_of_samples(const std::vector<PaintRow>& rows, int x) {
  Linear sum;
  for (const PaintRow& row : rows) {
    for (int s = 0; s < kSamples; ++s) sum = sum + row.colour[std::size_t(x * kSamples + s)];
  }
  return sum * (1.0F / (kSamples * kSamples));
}

Image paint_picture(const Sight& sight, const Painting& painting, const FigureOptions& options) {
  Image image(options.framing.width, options.framing.height);
  const Linear background =
      linear({options.background.r, options.background.g, options.background.b},
             float(options.background.a) / 255.0F);
  std::vector<PaintRow> rows(kSamples);
  for (int y = 0; y < image.height; ++y) {
    for (int s = 0; s < kSamples; ++s) {
      PaintRow& row = rows[std::size_t(s)];
      row.y = y * kSamples + s;
      row.colour.assign(std::size_t(sight.camera.width), Linear());
      row.depth.assign(std::size_t(sight.camera.width), std::numeric_limits<float>::infinity());
      if (options.shadow) paint_floor(sight, row);
      for (const Paint& paint : painting.paints) paint_surface(paint, row);
    }
    for (int x = 0; x < image.width; ++x) {
      image.at(x, y) = srgb(over(mean_of_samples(rows, x), background));
    }
  }
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
  const std::vector<Sight> sights = look_from_all(stage);
  std::vector<Figure> figures;
  for (const Look look : looks) {
    for (std::size_t v = 0; v < sights.size(); ++v) {
      const Painting painting = compose(stage, sights[v], look, options.scale);
      figures.push_back({look, options.views[v], paint_picture(sights[v], painting, options)});
    }
  }
  return figures;
}

}  // namespace regarment
