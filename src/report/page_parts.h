#pragma once

#include <vector>

#include "report/page.h"
#include "report/view.h"

// The parts report_page is made of; each turns a piece of the result into what its gaps show.

namespace regarment {

/// The head and the verdict: what was found, how sure, remarks.
void view_verdict(const Result& result, View& page);

/// One garment: its measurement table, edges and drawing.
View view_garment(const ResultGarment& garment, const std::string& drawing);

/// What is known of the scan, and how to overrule what was guessed.
void view_scan(const Result& result, View& page);

/// How many vertices carry each label, and how well they agree with true ones.
void view_labels(const Result& result, View& page);

/// Command, options, times.
void view_settings(const Result& result, View& page);

/// The pictures: the scan, and beside it the looks one can switch between.
void view_figures(const Result& result, const PageParts& parts, View& page);

}  // namespace regarment
