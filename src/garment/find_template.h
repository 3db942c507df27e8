#pragma once

#include <string>
#include <vector>

#include "garment/garment_template.h"

namespace regarment {

/// A template that can be asked for by name.
struct TemplateEntry {
  std::string name;
  std::string title;
  std::string source;  // "built in", or the folder it was found in
};

/// A template by name or by path. What ends in ".json" is a path. A name is looked up in the
/// folders of the environment variable REGARMENT_TEMPLATES (colon-separated), then in
/// ../share/regarment/templates beside the program, then among the templates built into the
/// program. Throws UsageError that lists the names there are, ReadError when the file is wrong.
GarmentTemplate find_template(const std::string& name_or_path);

/// All templates that can be asked for by name, sorted; the first place that has a name counts, as
/// in find_template. Files that are no template are left out: asking for one says why.
std::vector<TemplateEntry> list_templates();

}  // namespace regarment
