#include "jobs/config_fields.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cstdio>
#include <type_traits>

#include "base/error.h"
#include "base/one_line.h"
#include "http/address.h"
#include "jobs/job_store.h"

namespace regarment {
namespace {

using C = ServiceConfig;

constexpr double kMegabytes = 1 << 24;  // 16 TiB
constexpr double kYear = 366 * 24 * 3600.0;

constexpr std::array kFields = {
    ConfigField{"data", &C::data},
    ConfigField{"store", &C::store},
    ConfigField{"server", &C::server},
    ConfigField{"server_key", &C::server_key},
    ConfigField{"bind", &C::bind},
    ConfigField{"port", &C::port, 0, 65535},
    ConfigField{"http_threads", &C::http_threads, 1, 64},
    ConfigField{"workers", &C::workers, 0, 256},
    ConfigField{"threads", &C::threads, 1, 256},
    ConfigField{"max_upload_mb", &C::max_upload_mb, 1, kMegabytes},
    ConfigField{"max_queue", &C::max_queue, 1, 1e9},
    ConfigField{"max_jobs_per_key", &C::max_jobs_per_key, 1, 1e9},
    ConfigField{"quota_mb", &C::quota_mb, 0, kMegabytes},
    ConfigField{"min_free_mb", &C::min_free_mb, 0, kMegabytes},
    ConfigField{"keep_hours", &C::keep_hours, 0, 100 * kYear / 3600},
    ConfigField{"lease_seconds", &C::lease_seconds, 0.1, kYear},
    ConfigField{"max_attempts", &C::max_attempts, 1, 100},
    ConfigField{"fit_memory_mb", &C::fit_memory_mb, 0, kMegabytes},
    ConfigField{"fit_seconds", &C::fit_seconds, 0.1, kYear},
    ConfigField{"fit_file_mb", &C::fit_file_mb, 0, kMegabytes},
    ConfigField{"drain_seconds", &C::drain_seconds, 0, 3600},
};

std::string number(double value) {
  std::array<char, 40> text{};
  std::snprintf(text.data(), text.size(), "%.15g", value);
  return text.data();
}

}  // namespace

std::string ConfigField::environment_name() const {
  std::string out = "REGARMENT_";
  for (const char* c = name; *c != '\0'; ++c) {
    out += static_cast<char>(std::toupper(static_cast<unsigned char>(*c)));
  }
  return out;
}

void ConfigField::set(ServiceConfig& config, const std::string& text,
                      const std::string& where) const {
  std::visit(
      [&](auto of) {
        auto& value = config.*of;
        if constexpr (std::is_arithmetic_v<std::remove_reference_t<decltype(value)>>) {
          const char* end = text.data() + text.size();
          const auto [stop, error] = std::from_chars(text.data(), end, value);
          if (error != std::errc() || stop != end) {
            throw UsageError(where + ": '" + one_line(text, 60) + "' is not a number from " +
                             number(least) + " to " + number(most));
          }
        } else {
          value = text;
        }
      },
      member);
  check(config, where);
}

void ConfigField::check(const ServiceConfig& config, const std::string& where) const {
  std::visit(
      [&](auto of) {
        const auto& value = config.*of;
        if constexpr (std::is_arithmetic_v<std::remove_cvref_t<decltype(value)>>) {
          const auto real = static_cast<double>(value);
          if (!(real >= least && real <= most)) {
            throw UsageError(where + ": " + number(real) + " is not from " + number(least) +
                             " to " + number(most));
          }
        }
      },
      member);
  if (std::string_view(name) == "data" && config.data.empty()) {
    throw UsageError(where + ": is empty; give a folder");
  }
  if (std::string_view(name) == "server" && !config.server.empty()) try {
      HttpAddress::parse(config.server);
    } catch (const UsageError& error) {
      throw UsageError(where + ": " + error.what());
    }
}

std::string ConfigField::text(const ServiceConfig& config) const {
  return std::visit(
      [&](auto of) -> std::string {
        const auto& value = config.*of;
        using Value = std::remove_cvref_t<decltype(value)>;
        if constexpr (std::is_arithmetic_v<Value>) {
          return number(static_cast<double>(value));
        } else if constexpr (std::is_same_v<Value, std::filesystem::path>) {
          return value.string();
        } else {
          if (std::string_view(name) == "server_key") return value.empty() ? "not set" : "set";
          return std::string_view(name) == "store" ? shown_store(value) : value;
        }
      },
      member);
}

std::span<const ConfigField> config_fields() { return kFields; }

const ConfigField* find_config_field(std::string_view name) {
  const auto* found = std::find_if(kFields.begin(), kFields.end(),
                                   [&](const ConfigField& field) { return field.name == name; });
  return found == kFields.end() ? nullptr : found;
}

}  // namespace regarment
