#pragma once

#include <span>
#include <string>
#include <string_view>
#include <variant>

#include "jobs/service_config.h"

namespace regarment {

/// One field of ServiceConfig: how it is called, where it lies, what it may be.
struct ConfigField {
  const char* name;
  std::variant<std::filesystem::path ServiceConfig::*, std::string ServiceConfig::*,
               int ServiceConfig::*, std::uint64_t ServiceConfig::*, double ServiceConfig::*>
      member;
  double least = 0, most = 0;  // of numbers

  bool is_text() const { return member.index() < 2; }
  /// "REGARMENT_MAX_QUEUE".
  std::string environment_name() const;
  /// Sets it from text; numbers are read strictly. Throws UsageError that begins with `where`.
  void set(ServiceConfig& config, const std::string& text, const std::string& where) const;
  /// Throws UsageError that begins with `where` when the value is out of range.
  void check(const ServiceConfig& config, const std::string& where) const;
  /// Its value, fit to be shown: without a password, and of a key only whether it is set.
  std::string text(const ServiceConfig& config) const;
};

/// All of them, in the order of the struct.
std::span<const ConfigField> config_fields();
/// Null where there is none.
const ConfigField* find_config_field(std::string_view name);

}  // namespace regarment
