#pragma once

#include <filesystem>
#include <map>
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
  bool circumference = false;  // full circumference; half is a matter of display
  double lower = 0, upper = 0;  // bounds, m
  double typical = 0;           // where a placement starts, m
};

/// How a quantity that can be seen on a scan follows from the dimensions. The direct method
/// measures the left side on the scan and solves for the dimensions on the right.
struct Observation {
  enum class Kind {
    Girth,          // closed length of the garment edge `edge`
    GirthAtOffset,  // closed length `offset` metres along the limb from `edge` towards the garment
    Path,           // shortest length over the garment between edges `edge` and `to_edge` at `side`
    Fork,           // girth through the fork (underarm) between limb of `edge` and the torso
  };
  std::string name;
  Kind kind = Kind::Girth;
  std::string edge, to_edge;
  std::string side;     // "centre" (mean of front and back), "top" (upper edge of a sleeve), ...
  double offset = 0.0;  // m
  std::string equals;   // formula over dimensions and the template's constants
};

/// A kind of garment: panels, seams and dimensions, read from a data file. A new garment is a new
/// file (templates/README.md), not new code.
class GarmentTemplate {
 public:
  /// Reads and checks a template file. Throws ReadError with the JSON path of what is wrong.
  static GarmentTemplate load(const std::filesystem::path& file);
  /// The same from text; `name_for_messages` stands in for the file name.
  static GarmentTemplate parse(const std::string& json, const std::string& name_for_messages);

  const std::string& name() const;   // "skirt"
  const std::string& title() const;  // "Skirt"
  const std::vector<Dimension>& dimensions() const;
  const std::vector<Observation>& observations() const;
  /// Value of an observation's or any other formula at these dimensions, m. Throws InvalidInput on unknown names.
  double evaluate(const std::string& formula, const Dimensions& dimensions) const;
  Dimensions typical() const;
  /// Throws UsageError naming the dimension, its value in cm and its bounds.
  void check(const Dimensions& dimensions) const;
};

}  // namespace regarment
