// The same input gives the same result: again, in another order, on fewer threads, and after stops.
#include <sys/sysinfo.h>

#include <thread>

#include "findings.h"

namespace {

int processors = 0;  // as std::thread counts them; 0 = as many as the machine has

/// Sets the number of processors while it lives.
class Processors {
 public:
  explicit Processors(int count) : before_(std::exchange(processors, count)) {}
  ~Processors() { processors = before_; }
  Processors(const Processors&) = delete;
  Processors& operator=(const Processors&) = delete;

 private:
  int before_;
};

}  // namespace

// Stands in for the C library's, which the standard library asks for the number of processors.
extern "C" int get_nprocs() noexcept { return processors > 0 ? processors : get_nprocs_conf(); }

namespace regarment {
namespace {

using test::measured;

Scan dressed_scan() {
  test::PersonPlan plan;
  plan.skirt.emplace();
  plan.edge = 0.01;
  return test::scan_of(test::make_person(plan).mesh);
}

void expect_same_bits(const Analysis& a, const Analysis& b) {
  EXPECT_EQ(a.labels, b.labels);
  EXPECT_EQ(a.label_probability, b.label_probability);
  EXPECT_EQ(a.cap, b.cap);
  EXPECT_EQ(a.landmarks, b.landmarks);
  EXPECT_EQ(a.warnings, b.warnings);
  ASSERT_EQ(a.garments.size(), b.garments.size());
  for (std::size_t g = 0; g < a.garments.size(); ++g) {
    const GarmentAnalysis &p = a.garments[g], &q = b.garments[g];
    EXPECT_EQ(p.dimensions, q.dimensions);
    EXPECT_EQ(p.pattern.flat, q.pattern.flat);
    EXPECT_EQ(p.placed, q.placed);
    EXPECT_EQ(p.draped, q.draped);
    EXPECT_EQ(p.mean_distance, q.mean_distance);
    EXPECT_EQ(p.mean_stretch, q.mean_stretch);
    ASSERT_EQ(p.measurements.size(), q.measurements.size());
    for (std::size_t m = 0; m < p.measurements.size(); ++m) {
      EXPECT_EQ(p.measurements[m].flat, q.measurements[m].flat);
      EXPECT_EQ(p.measurements[m].low, q.measurements[m].low);
      EXPECT_EQ(p.measurements[m].high, q.measurements[m].high);
      EXPECT_EQ(p.measurements[m].worn, q.measurements[m].worn);
    }
    ASSERT_EQ(p.edges.size(), q.edges.size());
    for (std::size_t e = 0; e < p.edges.size(); ++e)
      EXPECT_EQ(p.edges[e].points, q.edges[e].points);
  }
}

TEST(Repeat, TwoRunsGiveTheSameBits) {
  const Scan scan = dressed_scan();
  expect_same_bits(analyze(scan, test::templates_of({"skirt"})),
                   analyze(scan, test::templates_of({"skirt"})));
}

TEST(Repeat, TheNumberOfThreadsDoesNotMatter) {
  const Scan scan = dressed_scan();
  const Processors two(2);
  if (std::thread::hardware_concurrency() != 2) GTEST_SKIP() << "processors are counted elsewise";
  const Analysis expected = analyze(scan, test::templates_of({"skirt"}));
  for (const int count : {1, 3, 7}) {
    const Processors some(count);
    SCOPED_TRACE(count);
    expect_same_bits(expected, analyze(scan, test::templates_of({"skirt"})));
  }
}

TEST(Repeat, TheOrderOfVerticesAndTrianglesDoesNotMatter) {
  const Scan scan = dressed_scan();
  const std::size_t n = scan.mesh.positions.size();
  std::vector<std::uint32_t> order(n), place(n);
  for (std::uint32_t v = 0; v < n; ++v) order[v] = v;
  test::Dice dice(91);
  dice.shuffle(order);
  Scan shuffled = scan;
  for (std::uint32_t k = 0; k < n; ++k) {
    place[order[k]] = k;
    shuffled.mesh.positions[k] = scan.mesh.positions[order[k]];
    shuffled.mesh.normals[k] = scan.mesh.normals[order[k]];
  }
  for (Triangle& t : shuffled.mesh.triangles) t = {place[t[1]], place[t[2]], place[t[0]]};
  dice.shuffle(shuffled.mesh.triangles);
  const Analysis a = analyze(scan, test::templates_of({"skirt"})),
                 b = analyze(shuffled, test::templates_of({"skirt"}));
  for (const Measurement& m : a.garments.at(0).measurements)
    EXPECT_NEAR(m.flat, measured(b.garments.at(0), m.name).flat, 0.001) << m.name;
  std::size_t other = 0;
  for (std::size_t v = 0; v < n; ++v) other += a.labels[v] != b.labels[place[v]];
  EXPECT_LT(other, n / 500);
}

TEST(Repeat, ProgressCanStopItAtEveryCall) {
  const Scan scan = dressed_scan();
  const auto skirt = test::templates_of({"skirt"});
  int calls = 0;
  double last = 0;
  std::string stage;
  analyze(scan, skirt, {}, Progress([&](std::string_view name, double fraction) {
            ++calls;
            EXPECT_FALSE(name.empty());
            EXPECT_TRUE(fraction >= 0 && fraction <= 1);
            if (name == stage) {
              EXPECT_GE(fraction, last);
            }
            stage = name, last = fraction;
            return true;
          }));
  ASSERT_GE(calls, 4);
  for (int stop = 1; stop <= calls; ++stop) {
    int seen = 0;
    const Progress progress([&](std::string_view, double) { return ++seen < stop; });
    EXPECT_THROW(analyze(scan, skirt, {}, progress), Stopped) << stop;
    EXPECT_EQ(seen, stop);  // not asked again after "stop"
  }
}

}  // namespace
}  // namespace regarment
