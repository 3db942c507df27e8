#pragma once

#include <filesystem>
#include <map>
#include <string>

// Fits so small that what is measured is the store, the workers and the engines: their "program" is
// a shell script that writes a result of a skirt whose length says which job it is of.

namespace regarment {

/// Writes the script into the folder, beside what it fills in; its path.
std::filesystem::path write_tiny_program(const std::filesystem::path& folder);
/// What job I, below 10,000, is called.
std::string tiny_name(int job);
int tiny_number(const std::string& name);
/// Its scan, and the length of the skirt on it in cm, as text.
std::string tiny_scan(int job);
std::string tiny_length(int job);

/// Whether the result folder of job I is whole and its own.
bool is_tiny_result(const std::filesystem::path& result, int job);

/// One hash of the results of jobs, by their names.
std::string tiny_digest(const std::map<std::string, std::filesystem::path>& results);

}  // namespace regarment
