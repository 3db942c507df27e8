#include "garment/find_template.h"

#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <sstream>

#include "base/error.h"
#include "base/one_line.h"
#include "garment/builtin_templates.h"

namespace regarment {

namespace {

namespace fs = std::filesystem;

bool is_name(const std::string& text) {
  return !text.empty() && text.size() <= 40 && std::all_of(text.begin(), text.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
  });
}

std::vector<fs::path> folders() {
  std::vector<fs::path> folders;
  if (const char* variable = std::getenv("REGARMENT_TEMPLATES")) {
    std::istringstream list(variable);
    for (std::string folder; std::getline(list, folder, ':');)
      if (!folder.empty()) folders.emplace_back(folder);
  }
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  if (!error) folders.push_back(program.parent_path().parent_path() / "share/regarment/templates");
  return folders;
}

/// Template files of a folder by name, sorted; none when the folder cannot be read.
std::map<std::string, fs::path> files_in(const fs::path& folder) {
  std::map<std::string, fs::path> files;
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error)) {
    const fs::path& file = entry->path();
    const std::string name = file.stem().string();
    if (file.extension() == ".json" && is_name(name)) files.emplace(name, file);
  }
  return files;
}

GarmentTemplate parse_builtin(const BuiltinTemplate& builtin) {
  return GarmentTemplate::parse(std::string(builtin.json), std::string(builtin.name) + ".json");
}

std::string known_names() {
  std::string names;
  for (const TemplateEntry& entry : list_templates())
    names += (names.empty() ? "" : ", ") + entry.name;
  return names;
}

}  // namespace

GarmentTemplate find_template(const std::string& name_or_path) {
  if (name_or_path.ends_with(".json")) return GarmentTemplate::load(name_or_path);
  if (!is_name(name_or_path))
    throw UsageError("'" + one_line(name_or_path, 60) +
                     "' is neither the name of a garment template (" + known_names() +
                     ") nor a path ending in .json");
  for (const fs::path& folder : folders()) {
    const fs::path file = folder / (name_or_path + ".json");
    std::error_code error;
    if (fs::is_regular_file(file, error)) return GarmentTemplate::load(file);
  }
  for (const BuiltinTemplate& builtin : builtin_templates())
    if (builtin.name == name_or_path) return parse_builtin(builtin);
  throw UsageError("there is no garment template '" + name_or_path + "'; there are " +
                   known_names() + ", or give the path of a .json file");
}

std::vector<TemplateEntry> list_templates() {
  std::map<std::string, TemplateEntry> entries;
  for (const fs::path& folder : folders()) {
    for (const auto& [name, file] : files_in(folder)) {
      if (entries.contains(name)) continue;
      try {
        entries[name] = {name, GarmentTemplate::load(file).title(), folder.string()};
      } catch (const ReadError&) {
        continue;  // not a template; find_template says why when asked for it
      }
    }
  }
  for (const BuiltinTemplate& builtin : builtin_templates()) {
    const std::string name(builtin.name);
    if (!entries.contains(name)) entries[name] = {name, parse_builtin(builtin).title(), "built in"};
  }
  std::vector<TemplateEntry> sorted;
  sorted.reserve(entries.size());
  for (auto& [name, entry] : entries) sorted.push_back(std::move(entry));
  return sorted;
}

}  // namespace regarment
