#pragma once

#include <string>
#include <vector>

#include "placement/limb_map.h"

namespace regarment {

/// Which edge is looked for on a limb's height field.
struct EdgeSearch {
  bool garment_above = true;     // the garment lies at larger s (a hem on the trunk) or smaller
  double s_low = 0, s_high = 0;  // m, where the edge may be
  std::vector<double> centre;    // m, per column: where it is expected; empty = nowhere special
  double spread = 0;          // m, how far from `centre` it still may well be (standard deviation)
  double cloth_step = 0.004;  // m, step of cloth thickness that counts as fully convincing
  double most_step = 1.0;     // m, a larger step is something else than this edge
  double widest = 1.0;     // m, surface further from the axis than this belongs to something else
  double least_error = 0;  // m, standard error of an edge that shows all the way round
  double straightness = 0.0;  // m, the edge may stray this far from a curve of two waves round the
                              // limb (a tilt and an oval); 0: as far as it likes
  double tilt = 0.0;          // m, most amplitude of that curve's tilt
  double dip = 0.0;           // m, most that it lies lower at both sides than in front and behind
  int max_slope = 3;          // rows the edge may move from one column to the next
};

/// A closed edge of a garment on a limb, one entry per column of the map.
struct FoundEdge {
  std::vector<double> s;      // m along the limb
  std::vector<double> r;      // m, surface of the garment at the edge
  std::vector<double> step;   // m, how far the garment stands off there; 0 where nothing is seen
  std::vector<bool> seen;     // the scan shows the edge in this column
  double coverage = 0;        // share of columns that show the edge
  double typical_step = 0;    // m, median over the columns
  double contrast = 0;        // median colour difference across the edge, 0..1.7
  double standard_error = 0;  // m, of the mean of s, if this is the edge: larger the less shows
  double score = 0;           // mean evidence; 1 is a step of cloth thickness all the way round
  double even_score = 0;      // the same where no column outvotes others: a fold stands off far on
                              // a part of the loop, an edge at least a little all the way round;
                              // with colours, which tell folds from edges, `score`
  std::string evidence;       // "step", "drop" or "colour": what showed most

  bool found() const { return !s.empty(); }
  /// m along the limb, mean of the columns; the edge must be found.
  double mean_s() const;
};

/// Finds the closed loop round the limb that best separates cloth from what lies under it: for each
/// boundary between rows a smooth surface with a step is fitted to the rows on both sides, colours
/// are compared, and the loop of largest summed evidence is found by dynamic programming. Returns
/// an edge with empty vectors when the range holds no data.
FoundEdge find_edge(const LimbMap& map, const EdgeSearch& search);

/// The best loops that lie well apart, the one of most evidence first, at most `most`. With
/// `straightness` each of them keeps that near to a level curve (a tilt and an oval), for which the
/// evidence of all columns counts together: a faint edge shows in the whole loop before it shows in
/// its parts.
std::vector<FoundEdge> find_edges(const LimbMap& map, const EdgeSearch& search, int most);

/// Where a found edge lies in space, closed, one point per column.
std::vector<Vec3> edge_points(const FoundEdge& edge, const LimbMap& map, const LimbAxis& axis);

/// Length of a closed curve, m, after smoothing over `half_width` points on both sides so that
/// noise does not lengthen it.
double closed_length(const std::vector<Vec3>& points, int half_width = 1);

}  // namespace regarment
