#pragma once

#include <gtest/gtest.h>

#include <string>

#include "run_program.h"

namespace regarment {

/// The program failed as it should: this status, nothing on standard output, and one line on
/// standard error that begins with the program's name and says `says`.
inline void expect_failure(const ProgramRun& run, int status, const std::string& says = "") {
  EXPECT_EQ(run.status, status) << run.err;
  EXPECT_EQ(run.out, "");
  EXPECT_EQ(lines_of(run.err).size(), 1u) << run.err;
  EXPECT_TRUE(run.err.starts_with("regarment: ")) << run.err;
  EXPECT_TRUE(run.err.ends_with("\n"));
  EXPECT_NE(run.err.find(says), std::string::npos) << run.err;
  for (const char c : run.err) {
    EXPECT_TRUE(c == '\n' || static_cast<unsigned char>(c) >= 0x20) << run.err;
  }
}

}  // namespace regarment
