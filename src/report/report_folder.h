#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "analysis/analysis.h"
#include "base/progress.h"
#include "fill/fill_scan.h"
#include "report/pictures.h"
#include "report/result.h"

namespace regarment {

/// Every file of a result folder, by its name in it.
using ReportFiles = std::map<std::string, std::string>;

/// All files of an analysis: report.html, result.json, measurements.csv, labels.u8, filled.ply,
/// pictures/... (sketch-I.svg and view.json too), state.bin where the options hold one, what
/// add_exports gives, and, for each garment I that was searched for, evaluations-I.csv. `templates`
/// are those of the garments, in their order; `filled` is as close_holes gives it. Depends on its
/// arguments alone.
ReportFiles report_files(const Analysis& analysis, const std::vector<GarmentTemplate>& templates,
                         const ReportOptions& options, const FilledScan& filled,
                         const Pictures& pictures);

/// Draws the pictures, makes the files and puts them into the folder `place`, which appears whole
/// or not at all (OutputFolder says where it may stand and what is thrown). Returns the text of
/// result.json.
std::string write_report_folder(const Analysis& analysis,
                                const std::vector<GarmentTemplate>& templates,
                                const ReportOptions& options, const std::filesystem::path& place,
                                bool replace, const Progress& progress);

/// Makes report.html of a stored result again, with the bytes `fit` gave it, and puts it in place
/// in one step. Returns its path. Throws UsageError when `folder` holds no result, ReadError when
/// what it holds is not what `fit` writes.
std::filesystem::path remake_report(const std::filesystem::path& folder);

}  // namespace regarment
