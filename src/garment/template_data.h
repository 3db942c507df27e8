#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "garment/formula.h"
#include "garment/garment_template.h"

namespace regarment {

/// How an outline edge bends between its ends (GarmentCode: edge "curvature").
struct Curvature {
  enum class Kind { Quadratic, Cubic, Ellipse };
  Kind kind = Kind::Ellipse;
  /// Quadratic and Cubic: one or two control points in the edge's own frame, where the edge runs
  /// from (0, 0) to (1, 0) and the second axis is the edge turned from +s towards +t (GarmentCode
  /// "relative"). Ellipse: the centre, in panel coordinates; the ends are conjugate half diameters,
  /// so that an axis-parallel quarter ellipse has them on its axes.
  std::vector<std::array<Formula, 2>> params;
  int segments = 1;  // the curve becomes this many straight pieces
};

struct ShapeEdge {
  std::string name;
  int from = 0, to = 0;  // index into ShapeData::vertices
  std::optional<Curvature> curvature;
};

struct ShapeLine {
  std::string title;     // drawn when not empty: "hip line"
  int from = 0, to = 0;  // index into vertices, then points
};

/// An outline as a template file states it: a whole panel, or the half s >= 0 of a panel cut on the
/// fold s = 0. Lines are edges of its triangulation. Formulas are in the file's unit.
struct ShapeData {
  std::string panel;  // the panel that states it
  bool on_fold = false;
  std::vector<std::array<Formula, 2>> vertices;
  std::vector<ShapeEdge> edges;  // chained; closed, or from fold to fold
  std::vector<std::array<Formula, 2>> points;
  std::vector<ShapeLine> lines;
};

struct PanelData {
  std::string name;
  std::string limb;
  bool is_front = true;
  int shape = 0;          // index into TemplateData::shapes
  bool mirrored = false;  // s -> -s, "left_" <-> "right_" in edge names
};

/// One side of a seam, or a free edge: edge `edge` of the shape of `panel`; `half` 1 is the mirror
/// half of a panel cut on the fold.
struct EdgeRef {
  int panel = 0, half = 0, edge = 0;
  auto operator<=>(const EdgeRef&) const = default;
};

struct FreeEdge {
  std::string name, limb;
  std::vector<EdgeRef> parts;
};

struct Requirement {
  Formula positive;
  std::string message;
};

/// An arrow of the drawing; its length is share * dimension.
struct MeasureArrow {
  std::string dimension;
  int piece = 0;  // index into TemplateData::pieces
  double share = 1.0;
  std::array<Formula, 2> from, to;
  Formula offset;         // file unit: the arrow lies this far to the left of from -> to, t down
  double label_at = 0.5;  // where along the arrow its text stands, 0..1
};

struct DrawnPiece {
  std::string title;
  std::vector<int> panels;
  int cut = 1;
  std::array<Formula, 2> grain_from, grain_to;
};

struct Derived {
  std::string name;
  Formula formula;
};

struct TemplateData {
  std::string file;  // for messages
  std::string name, title, description;
  std::vector<std::string> sources;
  double units_in_meter = 100.0;
  std::vector<Dimension> dimensions;                      // m
  std::vector<std::pair<std::string, double>> constants;  // file unit
  std::vector<Derived> derived;                           // may use what stands before them
  std::vector<Requirement> requirements;
  std::vector<ShapeData> shapes;
  std::vector<PanelData> panels;
  std::vector<std::array<EdgeRef, 2>> seams;
  std::vector<FreeEdge> free_edges;
  std::vector<Observation> observations;
  std::vector<DrawnPiece> pieces;
  std::vector<MeasureArrow> arrows;
  /// Coarse triangles of each shape over its coarse points (shape.h), negative area in (s, t).
  std::vector<std::vector<std::array<int, 3>>> coarse_triangles;
  /// Sign of each shape's outline in (s, t) as the file runs round it: +1 or -1.
  std::vector<int> outline_sign;
};

/// Values of all names of a template at given dimensions, in the file's unit. Derived names are
/// worked out when asked for, so that an impossible one spoils only what uses it.
/// Throws InvalidInput when a dimension is missing. Keeps references: use it and drop it.
class NameScope {
 public:
  NameScope(const TemplateData& data, const Dimensions& dimensions);
  /// Throws InvalidInput on an unknown name and on a formula without a value.
  double operator()(std::string_view name) const;
  double value(const Formula& formula) const;
  Vec2 metres(const std::array<Formula, 2>& point) const;

 private:
  const TemplateData& data_;
  mutable std::map<std::string, double, std::less<>> known_;
};

/// "left_cuff" becomes "right_cuff" and the other way round; other names stay.
std::string swap_sides(const std::string& name);

/// Name of an edge as a seam or a free edge knows it, sides swapped for mirrored parts.
std::string edge_name(const TemplateData& data, const EdgeRef& ref);

/// True when a panel's half lies turned over in (s, t) against its shape seen as a front: it is a
/// mirror image or a back, but not both.
bool is_turned(const PanelData& panel, int half);

/// True when the edge, run in the order of the file, has its panel on the left, seen from outside.
/// Needs `outline_sign`.
bool has_panel_on_left(const TemplateData& data, const EdgeRef& ref);

}  // namespace regarment
