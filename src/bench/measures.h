#pragma once

#include <functional>
#include <vector>

#include "bench/bench.h"
#include "geometry/mesh.h"

namespace regarment {

/// Processor seconds of this thread that each of the actions takes at best, in rounds in which they
/// take turns, so that a machine that slows down slows all.
std::vector<double> best_in_turn(const std::vector<std::function<void()>>& actions, int rounds);

// Each measures one part and adds its rows and curves.

/// The scan fitted by this program, and larger copies of it.
void measure_fits(const BenchOptions& options, const Progress& progress, Bench& bench);
/// Nearest points of a surface of `mesh`, beside CGAL's tree.
void measure_closest_points(const Mesh& mesh, Bench& bench);
/// The step of the joint fit, beside Eigen's factorisation by single numbers.
void measure_solver(Bench& bench);
/// Silhouettes of a garment and of a surface of `mesh`.
void measure_silhouettes(const Mesh& mesh, Bench& bench);
/// PLY files read.
void measure_reading(const Mesh& mesh, Bench& bench);

}  // namespace regarment
