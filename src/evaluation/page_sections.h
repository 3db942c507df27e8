#pragma once

#include "evaluation/evaluation.h"
#include "report/gaps.h"

// The sections of the page of an evaluation: each fills its own gaps of evaluation.html.

namespace regarment {

/// What it came to in a sentence, the key figures, and the gates.
void show_summary(const Evaluation& evaluation, Gaps& page);

/// Tables by measurement, template, layer, kind and damage.
void show_groups(const Evaluation& evaluation, Gaps& page);

/// Estimates over truth, errors over size.
void show_plots(const Evaluation& evaluation, Gaps& page);

/// The worst scans with their dimensions and pictures, the failed ones, and all in one table.
void show_scans(const Evaluation& evaluation, Gaps& page);

/// Garments that several scans show: how far their estimates lie apart, and what pooling brings.
void show_repeats(const Evaluation& evaluation, Gaps& page);

/// Every dimension that was found, the worst first, as far as a page holds them.
void show_dimensions(const Evaluation& evaluation, Gaps& page);

/// What differs from an evaluation of before.
void show_baseline(const Evaluation& evaluation, Gaps& page);

/// A figure with so many digits, or an en dash where there is none.
std::string figure_text(const std::optional<double>& value, int digits);
/// The same with its sign.
std::string signed_figure_text(const std::optional<double>& value, int digits);
/// A share 0..1 in whole percent: "93 %".
std::string percent_text(const std::optional<double>& share);

}  // namespace regarment
