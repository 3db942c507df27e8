#pragma once

#include <vector>

#include "report/gaps.h"
#include "report/page.h"

// The parts report_page is made of; each turns a piece of the result into what its gaps show.

namespace regarment {

/// The head and the verdict: what was found, the lights it rests on, remarks.
void show_verdict(const Result& result, Gaps& page);

/// One garment, the `number`-th from 1 on: its measurement table, edges and sketch.
Gaps show_garment(const ResultGarment& garment, std::size_t number, const std::string& sketch);

/// The legend of the deviation pictures: one histogram over the colour bar per garment that has
/// deviations.
std::vector<Gaps> show_deviations(const Result& result);

/// How the dimensions were searched for: one section per garment that was, with its runs, the terms
/// of E, and charts.
void show_searches(const Result& result, const PageParts& parts, Gaps& page);

/// What is known of the scan, and how to overrule what was guessed.
void show_scan(const Result& result, Gaps& page);

/// How many vertices carry each label, and how well they agree with true ones.
void show_labels(const Result& result, Gaps& page);

/// Command, options, times.
void show_settings(const Result& result, Gaps& page);

/// The pictures: the scan, and beside it the looks one can switch between.
void show_figures(const Result& result, const PageParts& parts, Gaps& page);

}  // namespace regarment
