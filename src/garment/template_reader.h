#pragma once

#include <string>

#include "garment/template_data.h"

namespace regarment {

/// Reads the text of a template file: structure, names, formulas, references; everything that can
/// be said without geometry (template_check.h does that). Throws ReadError("FILE: /json/pointer:
/// ...").
TemplateData read_template(const std::string& json, const std::string& file);

}  // namespace regarment
