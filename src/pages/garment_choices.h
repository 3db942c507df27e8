#pragma once

#include <optional>
#include <string>

namespace regarment {

/// The templates there are as pages need them to choose by picture and to correct by hand, JSON:
///   [{"name", "title", "edges": [edges round the trunk, whose height a person may give],
///     "sketch": address of its drawing}, ...]
/// in the order of list_templates. A template whose file is wrong is left out.
std::string garment_choices_json();

/// The sketch of a template at its typical size, SVG. Nothing when no template has this name.
std::optional<std::string> garment_sketch(const std::string& name);

}  // namespace regarment
