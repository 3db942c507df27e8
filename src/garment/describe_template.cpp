#include "garment/describe_template.h"

#include <iomanip>
#include <sstream>

#include "garment/template_data.h"

namespace regarment {

namespace {

constexpr std::size_t kColumns = 88;

/// Breaks a paragraph into lines, the first begun by `first`, the others indented as far.
std::string paragraph(const std::string& first, const std::string& text) {
  const std::string indent(first.size(), ' ');
  std::istringstream words(text);
  std::string out, line = first;
  bool empty = true;
  for (std::string word; words >> word;) {
    if (!empty && line.size() + 1 + word.size() > kColumns) {
      out += line + "\n";
      line = indent;
      empty = true;
    }
    line += (empty ? "" : " ") + word;
    empty = false;
  }
  return out + line + "\n";
}

std::string measurement(const Dimension& dimension) {
  std::ostringstream head;
  head << "  " << dimension.code << "  " << dimension.title << "  (" << dimension.name << ")\n"
       << "       " << std::fixed << std::setprecision(1) << "typical " << 100.0 * dimension.typical
       << " cm, bounds " << 100.0 * dimension.lower << " to " << 100.0 * dimension.upper << " cm"
       << (dimension.circumference ? ", full circumference" : "") << "\n";
  return head.str() + paragraph("       ", dimension.definition) +
         paragraph("       How: ", dimension.how_to_measure);
}

}  // namespace

std::string describe_template(const GarmentTemplate& garment) {
  const TemplateData& data = garment.data();
  std::string text = garment.title() + " (" + garment.name() + ")\n";
  text += paragraph("  ", garment.description()) + "\nMeasurements of the flat garment\n";
  for (const Dimension& dimension : garment.dimensions()) text += measurement(dimension) + "\n";
  if (!data.requirements.empty()) {
    text += "Together they must fulfil\n";
    for (const Requirement& requirement : data.requirements)
      text += paragraph("  - ", requirement.message);
    text += "\n";
  }
  text += "Free edges\n";
  for (const FreeEdge& edge : data.free_edges)
    text += "  " + edge.name + " (round the " + edge.limb + ")\n";
  if (!garment.sources().empty()) text += "\nWhere typical values and bounds come from\n";
  for (const std::string& source : garment.sources()) text += paragraph("  - ", source);
  return text;
}

}  // namespace regarment
