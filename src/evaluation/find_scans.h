#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace regarment {

/// The files a table means by `written`: the path seen from the table; else that path, or its file
/// name, in the folder `scans`; else every mesh file in `scans`, else beside the table, whose name
/// is `written` and one or more extensions ("skirt-1": skirt-1.cloud.ply, skirt-1.mesh.ply), sorted
/// by name. Empty when there is none.
std::vector<std::filesystem::path> find_scans(const std::string& written,
                                              const std::filesystem::path& table_folder,
                                              const std::optional<std::filesystem::path>& scans);

/// True labels of a scan: `written`, seen from the table or found in `scans`, or, where nothing is
/// written, STEM.labels.u8 beside the table or the scan when there is one (skirt-1.mesh.labels.u8
/// for skirt-1.mesh.ply). A written file that is not there comes back seen from the table.
std::optional<std::filesystem::path> find_labels(const std::string& written,
                                                 const std::filesystem::path& scan,
                                                 const std::filesystem::path& table_folder,
                                                 const std::optional<std::filesystem::path>& scans);

}  // namespace regarment
