#pragma once

#include <chrono>
#include <optional>
#include <string>

namespace regarment {

/// Tells the service manager something (systemd's sd_notify): "READY=1", "STOPPING=1",
/// "WATCHDOG=1". Does nothing where NOTIFY_SOCKET is not set or nobody listens.
void notify_manager(const std::string& state);

/// How often the manager wants to hear "WATCHDOG=1", halved, by WATCHDOG_USEC; nothing when it does
/// not.
std::optional<std::chrono::microseconds> watchdog_interval();

}  // namespace regarment
