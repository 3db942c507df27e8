// Prints how long nearest-point questions take, ours beside CGAL, Embree and nanoflann, in one run:
// the same scan, the same questions, the methods taking turns round by round. All run on one
// thread, whose processor time is counted, so that other programs disturb little.
#include "geometry/closest_point.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>

#include "base/error.h"
#include "bench/closest_point_rivals.h"
#include "geometry/mesh_io.h"
#include "scan/make_scan.h"

namespace regarment {

namespace {

struct Settings {
  std::string scan = "examples/data/skirt-1.mesh.ply";
  std::size_t questions = 20000;
  int rounds = 7;
  std::size_t finer = 400000;
};

struct Case {
  std::string name;
  std::vector<Question> questions;
  double min_cosine = -1;
};

Mesh read(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  const std::vector<char> content{std::istreambuf_iterator<char>(in), {}};
  if (content.empty()) throw ReadError(file + ": cannot be read; name a scan of triangles");
  const auto bytes = std::as_bytes(std::span(content));
  Mesh mesh = make_scan(parse_mesh(bytes, recognise_format(bytes, file), file)).mesh;
  if (mesh.is_cloud()) throw ReadError(file + ": has no triangles; name a scan of triangles");
  return mesh;
}

std::vector<Case> make_cases(const Mesh& mesh, std::size_t count) {
  std::vector<Case> cases;
  for (const bool ordered : {false, true}) {
    for (const double min_cosine : {-1.0, 0.5}) {
      for (const double mm : {3.0, 30.0}) {
        std::vector<Question> questions = ask_near(mesh, mm / 1000, count);
        if (ordered) questions = in_order(questions);
        cases.push_back({(ordered ? "ord " : "rnd ") + std::to_string(static_cast<int>(mm)) + "mm" +
                             (min_cosine > -1 ? " 60d" : ""),
                         std::move(questions), min_cosine});
      }
    }
  }
  return cases;
}

template <int K>
Finder our_finder(const Mesh& mesh, bool as_cloud) {
  const double start = thread_seconds();
  const auto tree = std::make_shared<KDopTree<K>>(
      as_cloud ? KDopTree<K>(std::span(mesh.positions), std::span(mesh.normals))
               : KDopTree<K>(std::span(mesh.positions), std::span(mesh.triangles)));
  const double build_ms = (thread_seconds() - start) * 1e3;
  const auto ask = [tree](std::span<const Question> questions, double min_cosine,
                          std::vector<double>& distances) {
    for (std::size_t i = 0; i < questions.size(); ++i) {
      ClosestFilter filter;
      filter.normal = questions[i].normal;
      filter.min_cosine = min_cosine;
      distances[i] = std::sqrt(tree->closest(questions[i].point, filter).squared_distance);
    }
  };
  return {"ours, k = " + std::to_string(K), build_ms, ask};
}

double median(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + values.size() / 2, values.end());
  return values[values.size() / 2];
}

// Largest difference to the first finder's distances, in metres; Embree's are floats.
double disagreement(const std::vector<double>& a, const std::vector<double>& b) {
  double most = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    if (a[i] != b[i]) most = std::max(most, std::abs(a[i] - b[i]));
  return most;
}

void print_table(const std::vector<Finder>& finders, const std::vector<Case>& cases,
                 const std::vector<std::vector<double>>& micros, const std::vector<double>& error) {
  std::printf("%-24s %9s", "us per query", "build ms");
  for (const Case& one : cases) std::printf(" %12s", one.name.c_str());
  std::printf(" %12s\n", "differs by m");
  for (std::size_t f = 0; f < finders.size(); ++f) {
    std::printf("%-24s %9.1f", finders[f].name.c_str(), finders[f].build_ms);
    for (const double time : micros[f]) std::printf(" %12.3f", time);
    std::printf(" %12.1e\n", error[f]);
  }
  std::printf("times as fast as\n");
  const std::size_t rivals = finders.size() - 4;
  for (std::size_t ours = rivals; ours < finders.size(); ++ours) {
    for (std::size_t f = 0; f < rivals; ++f) {
      std::printf("  %-14s : %-15s", finders[ours].name.c_str(), finders[f].name.c_str());
      for (std::size_t c = 0; c < cases.size(); ++c)
        std::printf(" %12.2f", micros[f][c] / micros[ours][c]);
      std::printf("\n");
    }
  }
}

void measure(const std::vector<Finder>& finders, const std::vector<Case>& cases, int rounds) {
  std::vector<std::vector<double>> micros(finders.size(), std::vector<double>(cases.size()));
  std::vector<double> error(finders.size(), 0);
  for (std::size_t c = 0; c < cases.size(); ++c) {
    const std::vector<Question>& questions = cases[c].questions;
    std::vector<std::vector<double>> times(finders.size());
    std::vector<double> first(questions.size()), distances(questions.size());
    for (int round = 0; round < rounds; ++round) {
      for (std::size_t f = 0; f < finders.size(); ++f) {
        const double start = thread_seconds();
        finders[f].ask(questions, cases[c].min_cosine, distances);
        times[f].push_back((thread_seconds() - start) * 1e6 /
                           static_cast<double>(questions.size()));
        if (f == 0) first = distances;
        error[f] = std::max(error[f], disagreement(first, distances));
      }
    }
    for (std::size_t f = 0; f < finders.size(); ++f) micros[f][c] = median(times[f]);
  }
  print_table(finders, cases, micros, error);
}

void measure_scan(const Mesh& mesh, const Settings& settings) {
  const std::vector<Case> cases = make_cases(mesh, settings.questions);
  for (const bool as_cloud : {false, true}) {
    std::printf("\n%zu %s, %zu queries, medians of %d rounds\n",
                as_cloud ? mesh.positions.size() : mesh.triangles.size(),
                as_cloud ? "points" : "triangles", settings.questions, settings.rounds);
    std::vector<Finder> finders;
    if (as_cloud) {
      finders.push_back(nanoflann_finder(mesh));
    } else {
      finders.push_back(cgal_finder(mesh));
      finders.push_back(embree_finder(mesh));
    }
    finders.push_back(our_finder<6>(mesh, as_cloud));
    finders.push_back(our_finder<14>(mesh, as_cloud));
    finders.push_back(our_finder<18>(mesh, as_cloud));
    finders.push_back(our_finder<26>(mesh, as_cloud));
    measure(finders, cases, settings.rounds);
  }
}

}  // namespace
}  // namespace regarment

int main(int argc, char** argv) {
  using namespace regarment;
  Settings settings;
  CLI::App app("Times nearest-point questions on a scan.");
  app.add_option("scan", settings.scan, "a scan of triangles")->capture_default_str();
  app.add_option("--queries", settings.questions)
      ->capture_default_str()
      ->check(CLI::PositiveNumber);
  app.add_option("--rounds", settings.rounds)->capture_default_str()->check(CLI::PositiveNumber);
  app.add_option("--finer", settings.finer, "triangles of a second, subdivided scan; 0 for none")
      ->capture_default_str();
  CLI11_PARSE(app, argc, argv);
  try {
    Mesh mesh = read(settings.scan);
    measure_scan(mesh, settings);
    if (mesh.triangles.size() >= settings.finer) return 0;
    subdivide(mesh, settings.finer);
    measure_scan(mesh, settings);
  } catch (const Error& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return error.exit_status();
  }
}
