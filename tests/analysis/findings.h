#pragma once

#include <gtest/gtest.h>

#include "analysis/analyze.h"
#include "base/error.h"
#include "garment/find_template.h"
#include "support/made_person.h"

namespace regarment::test {

inline std::vector<GarmentTemplate> templates_of(const std::vector<std::string>& names) {
  std::vector<GarmentTemplate> out;
  out.reserve(names.size());
  for (const std::string& name : names) out.push_back(find_template(name));
  return out;
}

inline const Measurement& measured(const GarmentAnalysis& garment, const std::string& name) {
  for (const Measurement& m : garment.measurements)
    if (m.name == name) return m;
  throw std::out_of_range("no measurement " + name);
}

/// Expects NoGarmentError with exit status 4 and a message of one line.
inline void expect_no_garment(const Scan& scan, const std::string& name) {
  try {
    analyze(scan, templates_of({name}));
    ADD_FAILURE() << "found a " << name;
  } catch (const NoGarmentError& error) {
    const std::string message = error.what();
    EXPECT_EQ(error.exit_status(), 4);
    EXPECT_EQ(message.find('\n'), std::string::npos);
    EXPECT_NE(message.find(name), std::string::npos) << message;
  }
}

}  // namespace regarment::test
