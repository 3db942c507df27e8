#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "geometry/mesh.h"

namespace regarment {

/// Dimensions by name, metres. Every dimension of the template is present.
using Dimensions = std::map<std::string, double>;

/// A named length of a garment that is searched for.
struct Dimension {
  std::string name;        // "sleeve_length"
  std::string code;        // "T03"
  std::string title;       // "Sleeve length"
  std::string definition;  // what it is, exactly, one or two sentences
  std::string how_to_measure;
  bool circumference = false;   // full circumference; half is a matter of display
  double lower = 0, upper = 0;  // bounds, m
  double typical = 0;           // where a placement starts, m
};

/// How a quantity that can be seen on a scan follows from the dimensions. The direct method
/// measures the left side on the scan and solves for the dimensions on the right.
struct Observation {
  enum class Kind {
    Girth,          // closed length of the garment edge `edge`
    GirthAtOffset,  // closed length `offset` metres along the limb from `edge` towards the garment;
                    // with side "underarm" `offset` metres below the fork, towards `edge`
    Path,           // shortest length over the garment between edges `edge` and `to_edge` at `side`
    Fork,           // girth through the fork (underarm) between limb of `edge` and the torso
  };
  std::string name;
  Kind kind = Kind::Girth;
  std::string edge, to_edge;
  /// Path: "centre" (mean of front and back along the centre line), "top" (upper edge of a sleeve)
  /// or "shoulder_point" (from where shoulder and neck meet straight down, mean of left and right,
  /// front and back). GirthAtOffset: "underarm" or empty. Else empty.
  std::string side;
  double offset = 0.0;  // m, >= 0
  std::string equals;   // formula over dimensions and the template's constants
};

struct TemplateData;

/// A kind of garment: panels, seams and dimensions, read from a data file. A new garment is a new
/// file (templates/README.md), not new code. Immutable; copies share their content and may be used
/// by several threads at once.
class GarmentTemplate {
 public:
  /// Reads and checks a template file. Throws ReadError with the JSON path of what is wrong.
  static GarmentTemplate load(const std::filesystem::path& file);
  /// The same from text; `name_for_messages` stands in for the file name.
  static GarmentTemplate parse(const std::string& json, const std::string& name_for_messages);

  const std::string& name() const;                  // "skirt"
  const std::string& title() const;                 // "Skirt"
  const std::string& description() const;           // one or two sentences for a person
  const std::vector<std::string>& sources() const;  // where typical values and bounds come from
  const std::vector<Dimension>& dimensions() const;
  const std::vector<Observation>& observations() const;
  /// The dimension of this name. Throws InvalidInput when there is none.
  const Dimension& dimension(const std::string& name) const;

  /// Value of an observation's or any other length formula at these dimensions, m. Throws
  /// InvalidInput on unknown names, a missing dimension and a formula without a value there.
  double evaluate(const std::string& formula, const Dimensions& dimensions) const;
  /// Whether a formula's length grows with the named dimension at least half as fast as it. Throws
  /// as evaluate does.
  bool gives(const std::string& formula, const std::string& name,
             const Dimensions& dimensions) const;
  Dimensions typical() const;
  /// Throws UsageError naming the dimension, its value in cm and its bounds; or, when all are
  /// within bounds but together make no garment, what would have to change.
  void check(const Dimensions& dimensions) const;
  /// Dimensions that pass `check`, near the given ones: clamped to the bounds, missing or not
  /// finite ones typical, unknown ones dropped; then, if together they still make no garment, moved
  /// on the straight line towards the typical ones just far enough (to 1/1000 of the way).
  Dimensions nearest_possible(const Dimensions& dimensions) const;

  /// Panels, seams and drawing, for the other files of this library.
  const TemplateData& data() const { return *data_; }

 private:
  explicit GarmentTemplate(std::shared_ptr<const TemplateData> data) : data_(std::move(data)) {}
  std::shared_ptr<const TemplateData> data_;
};

}  // namespace regarment
