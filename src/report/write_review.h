#pragma once

#include <filesystem>
#include <vector>

#include "base/progress.h"

namespace regarment {

/// The result folders that are meant: a folder with a result.json, else those folders in it, or in
/// its `fits`, that have one, by name. Each once, in the order given. Throws UsageError when a
/// folder does not exist or holds no result, or when there are more than 2000.
std::vector<std::filesystem::path> find_results(const std::vector<std::filesystem::path>& folders);

/// Writes the page to review these results by (review_page.h) to the file `page`, in one step. A
/// file that is there is replaced only with `replace`. Throws UsageError as find_results does and
/// when the page may not be written; ReadError naming the folder whose result is none.
void write_review(const std::vector<std::filesystem::path>& folders,
                  const std::filesystem::path& page, bool replace, const Progress& progress);

}  // namespace regarment
