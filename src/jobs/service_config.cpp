#include "jobs/service_config.h"

#include <toml++/toml.h>
#include <algorithm>
#include <cstdlib>
#include <sstream>
#include <utility>

#include "base/error.h"
#include "base/one_line.h"
#include "jobs/config_fields.h"
#include "report/files.h"

namespace regarment {
namespace {

constexpr std::size_t kMostFileBytes = 1U << 20U;

[[noreturn]] void refuse(const std::string& where, const std::string& wanted) {
  throw UsageError(where + ": " + wanted);
}

// How unlike two names are: single letters to change.
std::size_t distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t corner = std::exchange(row[0], i);
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t changed = corner + (a[i - 1] == b[j - 1] ? 0 : 1);
      corner = row[j];
      row[j] = std::min({changed, row[j] + 1, row[j - 1] + 1});
    }
  }
  return row.back();
}

std::string nearest_field(std::string_view name) {
  const auto fields = config_fields();
  return std::min_element(fields.begin(), fields.end(),
                          [&](const ConfigField& a, const ConfigField& b) {
                            return distance(name, a.name) < distance(name, b.name);
                          })
      ->name;
}

std::string text_of(const toml::node& node, const ConfigField& field, const std::string& where) {
  if (const auto text = node.value_exact<std::string>()) {
    if (field.is_text()) return *text;
  } else if (const auto whole = node.value_exact<std::int64_t>()) {
    if (!field.is_text()) return std::to_string(*whole);
  } else if (const auto real = node.value_exact<double>()) {
    std::ostringstream digits;
    digits.precision(17);
    digits << *real;
    if (!field.is_text()) return digits.str();
  }
  refuse(where, field.is_text() ? "wants a text in quotes" : "wants a number");
}

toml::table parsed(const std::filesystem::path& file) {
  const std::string shown = one_line(file.string(), 300);
  const std::string text = read_file(file, kMostFileBytes + 1);
  if (text.size() > kMostFileBytes) throw ReadError(shown + ": more than 1 MiB is no config");
  try {
    return toml::parse(text);
  } catch (const toml::parse_error& error) {
    refuse(shown + ": line " + std::to_string(error.source().begin.line),
           one_line(error.description(), 200));
  }
}

}  // namespace

void ServiceConfig::check() const {
  for (const ConfigField& field : config_fields()) field.check(*this, field.name);
}

std::string ServiceConfig::store_or_default() const {
  return store.empty() ? (data / "store.sqlite3").string() : store;
}

std::optional<std::string> process_environment(const std::string& name) {
  const char* value = std::getenv(name.c_str());
  if (value == nullptr) return std::nullopt;
  return value;
}

ReadConfig read_service_config(const std::optional<std::filesystem::path>& file,
                               const Environment& environment) {
  ReadConfig out;
  std::vector<std::string> from(config_fields().size(), "default");
  const auto set = [&](const ConfigField& field, const std::string& text, const std::string& where,
                       const char* who) {
    field.set(out.config, text, where);
    from[static_cast<std::size_t>(&field - config_fields().data())] = who;
  };
  if (file) {
    for (const auto& [key, node] : parsed(*file)) {
      const std::string where = one_line(file->string(), 300) + ": line " +
                                std::to_string(node.source().begin.line) + ": " +
                                one_line(key.str(), 60);
      const ConfigField* field = find_config_field(key.str());
      if (field == nullptr) {
        refuse(where, "is no field of the config; did you mean " + nearest_field(key.str()) + "?");
      }
      set(*field, text_of(node, *field, where), where, "file");
    }
  }
  for (const ConfigField& field : config_fields()) {
    const std::string name = field.environment_name();
    if (const auto text = environment(name)) set(field, *text, name, "environment");
  }
  out.config.check();
  for (const ConfigField& field : config_fields()) {
    out.entries.push_back({field.name, field.text(out.config), from[out.entries.size()]});
  }
  return out;
}

}  // namespace regarment
