#pragma once

#include <cstdint>
#include <functional>

#include "base/progress.h"
#include "synthetic/case_making.h"

namespace regarment {

/// Which cases to make, and how.
struct SynthesizeOptions {
  std::uint64_t seed = 1;
  std::uint32_t first = 0;  // index of the first case
  int cases = 10;           // 1 .. 100000
  int threads = 1;          // cases in the making at once, 1 .. 256
  CaseWish wish;
  DressOptions dress = {.longest = 4.0};  // thick and tucked cloth takes its time

  /// Throws InvalidInput naming the field and its value.
  void check() const;
};

/// What was made; its order is that of the cases.
struct Synthesis {
  std::vector<CaseTruth> truth;
};

/// Makes the cases and hands each case's files to `take` as soon as they are there: from one thread
/// at a time, cases in any order. The bytes do not depend on the number of threads. Tells progress
/// how many are done and how long the rest will take. Throws what make_case and `take` throw, once
/// all threads have ended.
Synthesis synthesize(const SynthesizeOptions& options,
                     const std::function<void(const std::vector<CaseFile>&)>& take,
                     const Progress& progress = {});

/// The tables over all cases: truth/truth.json and truth/ground_truth.csv.
std::vector<CaseFile> truth_tables(const Synthesis& synthesis);

}  // namespace regarment
