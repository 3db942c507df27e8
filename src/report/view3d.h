#pragma once

#include <string>

#include "analysis/analysis.h"

namespace regarment {

/// Scan and garments for the view the page lets turn, as JSON (pictures/view.json): of the scan at
/// most kViewElements triangles or points. Positions are 16 bits of the box around everything,
/// normals 8 bits signed, labels one byte; deviations are one byte of `scale`, 255 where there is
/// none; all in base64, little-endian:
///
///   {"low": [x, y, z], "size": [x, y, z],            body frame, m
///    "palette": [[r, g, b], ...],                    colours of the labels
///    "scale": "..", "scale_mm": 5,                   255 colours from -5 to 5 mm; "" for none
///    "scan": {"points": "..", "normals": "..", "triangles": "..", "labels": "..", "values": ".."},
///    "garments": [{"points": "..", "normals": "..", "triangles": "..", "label": 1}, ...]}
///
/// Empty when there is nothing to show or too many points for 16 bits. Same analysis, same text.
std::string view_json(const Analysis& analysis);

inline constexpr std::size_t kViewElements = 30'000;

/// Throws ReadError when a stored text holds anything but what `view_json` writes of: it goes into
/// the page as it is, so no character may end the element it stands in.
void check_view(const std::string& json);

}  // namespace regarment
