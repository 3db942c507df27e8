#include "scan/separate_body.h"

#include <algorithm>

namespace regarment {
namespace {

constexpr int kMostRounds = 6;         // of taking something away and looking again
constexpr double kMuchSmaller = 0.75;  // of the size before: then the sample was too coarse

/// What still may be the body.
struct Remaining {
  std::vector<Vec3> positions;
  std::vector<Triangle> triangles;
};

Remaining remaining(std::span<const Vec3> positions, std::span<const Triangle> triangles,
                    std::span<const Belongs> belongs) {
  Remaining rest;
  std::vector<std::uint32_t> place(positions.size(), 0);
  for (std::size_t i = 0; i < positions.size(); ++i) {
    if (belongs[i] != Belongs::Body) continue;
    place[i] = static_cast<std::uint32_t>(rest.positions.size());
    rest.positions.push_back(positions[i]);
  }
  for (const auto& [a, b, c] : triangles) {
    if (belongs[a] != Belongs::Body || belongs[b] != Belongs::Body || belongs[c] != Belongs::Body) {
      continue;
    }
    rest.triangles.push_back({place[a], place[b], place[c]});
  }
  return rest;
}

double longest_side(std::span<const Vec3> points) {
  if (points.empty()) return 0;
  Vec3 low = points[0], high = points[0];
  for (const Vec3& p : points) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  return (high - low).maxCoeff();
}

/// Marks what the sample did not keep.
void mark_rest(std::span<const Vec3> positions, const BodySample& sample,
               std::vector<Belongs>& belongs) {
  for (std::size_t i = 0; i < positions.size(); ++i) {
    if (belongs[i] == Belongs::Body) belongs[i] = sample.at(positions[i]);
  }
}

}  // namespace

SeparatedBody separate_body(std::span<const Vec3> positions, std::span<const Triangle> triangles) {
  SeparatedBody separated;
  separated.belongs.assign(positions.size(), Belongs::Body);
  separated.sample = sample_body(positions, triangles);
  for (int round = 0; round < kMostRounds; ++round) {
    const BodySample& sample = separated.sample;
    const auto sheet = find_outer_sheet(sample.points, sample.cell);
    const bool smaller = longest_side(sample.points) < kMuchSmaller * sample.longest;
    if (!sheet && !smaller) break;
    if (sheet) {
      separated.sheets.push_back(refine_sheet(*sheet, positions, sample.cell));
      for (std::size_t i = 0; i < positions.size(); ++i) {
        const bool taken = separated.sheets.back().takes(positions[i]);
        if (taken && separated.belongs[i] == Belongs::Body) separated.belongs[i] = Belongs::Sheet;
      }
    } else {
      mark_rest(positions, sample, separated.belongs);
    }
    const Remaining rest = remaining(positions, triangles, separated.belongs);
    if (rest.positions.empty()) break;
    separated.sample = sample_body(rest.positions, rest.triangles);
  }
  mark_rest(positions, separated.sample, separated.belongs);
  return separated;
}

}  // namespace regarment
