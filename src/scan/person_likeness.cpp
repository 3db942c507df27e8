#include "scan/person_likeness.h"

#include <algorithm>
#include <cmath>

#include "scan/robust.h"

namespace regarment {
namespace {

constexpr int kLevels = BodySlices::kLevels;

int level_at(double t) { return static_cast<int>(t * kLevels); }

struct HeadCue {
  double score = 0.0, neck_t = 0.0, top_t = 0.0, width = 0.0;
  double neck_width = 1.0;
};

/// Of necks that score nearly alike the narrowest is the neck.
bool is_better(const HeadCue& a, const HeadCue& b) {
  constexpr double kNearly = 0.85;
  if (a.score * kNearly > b.score) return true;
  return a.score > kNearly * b.score && a.neck_width < b.neck_width;
}

/// The pieces from a tip downwards, each carried by the next.
std::vector<const SlicePiece*> chain_below(const BodySlices& slices, int level, int piece) {
  std::vector<const SlicePiece*> chain;
  for (; level >= 0 && piece != SlicePiece::kNone; --level) {
    chain.push_back(&slices.levels[level][piece]);
    piece = chain.back()->below;
  }
  return chain;
}

/// How much a chain looks like head, neck and shoulders with the neck at `neck`. Widths are those
/// of an adult (head 0.09 to 0.11 of the height) to a small child (0.2), with room for hair.
double head_score(const std::vector<const SlicePiece*>& chain, std::size_t neck,
                  double& head_width) {
  std::vector<double> above;
  const SlicePiece* widest = chain[0];
  for (std::size_t i = 0; i < neck; ++i) {
    above.push_back(chain[i]->width);
    if (chain[i]->width > widest->width) widest = chain[i];
  }
  std::sort(above.begin(), above.end());
  head_width = above.size() > 2 ? above[above.size() - 2] : above.back();
  if (head_width < 0.07 || head_width > 0.34) return 0;
  const double tall = static_cast<double>(neck) / kLevels;
  const double neck_width = std::max(chain[neck]->width, 0.6 * head_width);
  double shoulders = 0;
  for (std::size_t i = neck + 1; i < chain.size() && i <= neck + level_at(0.14); ++i) {
    shoulders = std::max(shoulders, chain[i]->width);
  }
  const double on_shoulders = ramp(shoulders / neck_width, 1.2, 2.0);
  const double bulges = 0.5 + 0.5 * ramp(head_width / chain[neck]->width, 1.0, 1.2);
  const double round = ramp(widest->depth / widest->width, 0.3, 0.6);
  const double not_stretched = ramp(1.7 * head_width - 0.5 * tall, 0.0, 0.05);
  const double not_flat = ramp(tall / head_width, 0.3, 0.6);
  return on_shoulders * bulges * round * not_stretched * not_flat;
}

HeadCue find_head(const BodySlices& slices) {
  HeadCue best;
  for (int level = kLevels - 1; level >= level_at(0.6); --level) {
    for (int piece = 0; piece < static_cast<int>(slices.levels[level].size()); ++piece) {
      if (!slices.levels[level][piece].tip) continue;
      const auto chain = chain_below(slices, level, piece);
      const std::size_t lowest_neck = level_at(0.30);
      for (std::size_t neck = level_at(0.07); neck < lowest_neck && neck + 1 < chain.size();
           ++neck) {
        double width = 0;
        const double score = head_score(chain, neck, width);
        const double top = BodySlices::middle_of(level);
        const HeadCue cue{score, top - static_cast<double>(neck) / kLevels, top, width,
                          chain[neck]->width};
        if (score > 0 && is_better(cue, best)) best = cue;
      }
    }
  }
  return best;
}

/// Share of the lower slices that show two slim pieces of like size.
double legs_cue(const BodySlices& slices) {
  const int first = level_at(0.04), last = level_at(0.42);
  int two = 0;
  for (int level = first; level < last; ++level) {
    const auto& pieces = slices.levels[level];
    if (pieces.size() != 2) continue;
    const bool alike =
        static_cast<double>(pieces[1].cells) > 0.4 * static_cast<double>(pieces[0].cells);
    if (alike && std::max(pieces[0].width, pieces[1].width) < 0.3) ++two;
  }
  return ramp(static_cast<double>(two) / (last - first), 0.0, 0.35);
}

/// Share of the upper slices that show a piece on either side of the largest.
double arms_cue(const BodySlices& slices) {
  const int first = level_at(0.42), last = level_at(0.84);
  int three = 0;
  for (int level = first; level < last; ++level) {
    const auto& pieces = slices.levels[level];
    if (pieces.size() < 3) continue;
    const bool alike =
        static_cast<double>(pieces[2].cells) > 0.3 * static_cast<double>(pieces[1].cells);
    const Vec2 one = pieces[1].centre - pieces[0].centre,
               other = pieces[2].centre - pieces[0].centre;
    if (alike && one.dot(other) < 0) ++three;
  }
  return ramp(static_cast<double>(three) / (last - first), 0.0, 0.15);
}

/// Root mean square distance of the points with `low` < t < `high` from their mean.
double spread_between(const BodySlices& slices, double low, double high) {
  Vec2 sum = Vec2::Zero();
  double squares = 0, count = 0;
  for (std::size_t i = 0; i < slices.t.size(); ++i) {
    if (slices.t[i] <= low || slices.t[i] >= high) continue;
    sum += slices.across[i];
    squares += slices.across[i].squaredNorm();
    count += 1;
  }
  if (count < 3) return 0;
  return std::sqrt(std::max(0.0, squares / count - (sum / count).squaredNorm()));
}

}  // namespace

bool PersonLikeness::is_person() const {
  const int cues = (head >= 0.3) + (legs >= 0.4) + (arms >= 0.3) + (spread >= 0.3);
  return (head >= 0.3 || legs >= 0.4) && cues >= 2 && total() >= 2.5;
}

PersonLikeness judge_person(const BodySlices& slices) {
  PersonLikeness likeness;
  if (!(slices.height > 0)) return likeness;
  const HeadCue head = find_head(slices);
  likeness.head = head.score;
  likeness.neck_t = head.neck_t;
  likeness.head_top_t = head.top_t;
  likeness.head_width = head.width;
  likeness.legs = legs_cue(slices);
  likeness.arms = arms_cue(slices);
  const double bottom = spread_between(slices, -1, 0.015), top = spread_between(slices, 0.985, 2);
  likeness.spread = std::clamp((bottom - top) / 0.05, -1.0, 1.0);
  // Arms spread wide reach a body height; nobody is nearly as deep as tall.
  likeness.too_wide = 3 * ramp(slices.width, 1.1, 1.5) + 2 * ramp(slices.depth, 0.75, 1.05);
  return likeness;
}

}  // namespace regarment
