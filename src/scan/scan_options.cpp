#include "base/error.h"
#include "scan/file_axis.h"
#include "scan/find_units.h"
#include "scan/make_scan.h"

namespace regarment {
namespace {

template <typename Check>
void check_option(const char* name, const std::string& value, Check check) {
  if (value == "auto") return;
  try {
    check(value);
  } catch (const UsageError& error) {
    throw UsageError(std::string(name) + ": " + error.what() + ", or auto");
  }
}

}  // namespace

void ScanOptions::check() const {
  check_option("--units", units, metres_of);
  check_option("--up", up, axis_vector);
  check_option("--front", front, axis_vector);
  if (up == "auto" || front == "auto") return;
  if (axis_vector(up).dot(axis_vector(front)) != 0.0) {
    throw UsageError("--front " + front + " is not perpendicular to --up " + up +
                     ": give two different axes");
  }
}

}  // namespace regarment
