#include "analysis/scan_state.h"

#include <functional>
#include <span>

#include "base/sha256.h"
#include "findings.h"
#include "support/dice.h"

namespace regarment {
namespace {

using test::Dice;

constexpr std::size_t kHead = 16 + 4 + 8 + 64;  // magic, version, length, digest

ScanState dressed() {
  test::PersonPlan plan;
  plan.skirt.emplace();
  plan.edge = 0.02;
  ScanState state;
  state.scan = test::scan_of(test::make_person(plan).mesh);
  ScanFacts& facts = state.scan.facts;
  facts.file = "a b.ply", facts.sha256 = std::string(64, 'a');
  facts.units = "inch", facts.up = "-z", facts.front = "free";
  facts.units_guessed = false, facts.front_confidence = 0.75;
  facts.noise = 0.0013, facts.outliers = 3, facts.holes = 2;
  facts.findings = {{"floor", Severity::Advice, "A floor", "Left out", ""}};
  state.scan.file_from_body = Eigen::Translation3d(1, -2, 3) *
                              Eigen::AngleAxisd(0.3, Vec3(1, 2, 2).normalized()) *
                              Eigen::Scaling(39.37);
  const std::size_t n = state.scan.mesh.positions.size();
  Dice dice(5);
  state.scan.outlier.resize(n), state.scan.invented.resize(n), state.true_labels.resize(n);
  for (std::size_t v = 0; v < n; ++v) {
    state.scan.outlier[v] = dice.uniform(0, 1) < 0.1, state.scan.invented[v] = v % 3 == 0;
    state.true_labels[v] = v % 2 == 0 ? 1 : 255;
    state.scan.mesh.colours.push_back({static_cast<std::uint8_t>(v), 7, 255});
  }
  state.placement.landmarks = {{"neck", 1.435}};
  state.placement.edges = {{"skirt.waist", 1.01}, {"hem", 0.5}};
  return state;
}

/// Bytes with the length and digest that suit what stands behind the head.
std::string sealed(std::string bytes) {
  const std::string_view rest = std::string_view(bytes).substr(kHead);
  const std::uint64_t length = rest.size();
  std::memcpy(bytes.data() + 20, &length, sizeof length);
  const std::string digest = sha256_hex(std::as_bytes(std::span(rest.data(), rest.size())));
  bytes.replace(28, 64, digest);
  return bytes;
}

std::string refusal(const std::string& bytes) {
  try {
    read_state(bytes, "state.bin");
  } catch (const ReadError& error) {
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
    EXPECT_TRUE(std::string(error.what()).starts_with("state.bin: ")) << error.what();
    return error.what();
  }
  return "";
}

void expect_same_surface(const Scan& a, const Scan& b) {
  ASSERT_EQ(a.mesh.positions.size(), b.mesh.positions.size());
  for (std::size_t v = 0; v < a.mesh.positions.size(); ++v) {
    // Half of a float's last digit at 2 m.
    EXPECT_LT((a.mesh.positions[v] - b.mesh.positions[v]).norm(), 2e-7);
    EXPECT_LT((a.mesh.normals[v] - b.mesh.normals[v]).norm(), 1.8e-4);  // 0.01 degrees
  }
  EXPECT_EQ(a.mesh.triangles, b.mesh.triangles);
  EXPECT_EQ(a.mesh.colours, b.mesh.colours);
  EXPECT_EQ(a.outlier, b.outlier);
  EXPECT_EQ(a.invented, b.invented);
}

TEST(ScanState, ComesBack) {
  const ScanState state = dressed();
  const std::string bytes = write_state(state);
  const ScanState back = read_state(bytes, "s");
  expect_same_surface(state.scan, back.scan);
  EXPECT_EQ(back.placement.landmarks, state.placement.landmarks);
  EXPECT_EQ(back.placement.edges, state.placement.edges);
  EXPECT_EQ(back.true_labels, state.true_labels);
  EXPECT_EQ(back.scan.file_from_body.matrix(), state.scan.file_from_body.matrix());
  const ScanFacts &a = state.scan.facts, &b = back.scan.facts;
  EXPECT_EQ(std::tie(a.file, a.sha256, a.units, a.up, a.front, a.units_guessed, a.up_guessed,
                     a.front_guessed, a.front_confidence, a.noise, a.spacing, a.height, a.outliers,
                     a.holes),
            std::tie(b.file, b.sha256, b.units, b.up, b.front, b.units_guessed, b.up_guessed,
                     b.front_guessed, b.front_confidence, b.noise, b.spacing, b.height, b.outliers,
                     b.holes));
  ASSERT_EQ(b.findings.size(), 1U);
  EXPECT_EQ(b.findings[0].code, "floor");
  EXPECT_EQ(b.findings[0].severity, Severity::Advice);
  // What was rounded once stays.
  EXPECT_EQ(write_state(back), bytes);
}

TEST(ScanState, KeepsNormalsOfAllDirections) {
  ScanState state = dressed();
  Dice dice(9);
  auto& normals = state.scan.mesh.normals;
  for (Vec3& n : normals)
    n = Vec3(dice.uniform(-1, 1), dice.uniform(-1, 1), dice.uniform(-1, 1)).normalized();
  for (std::size_t k = 0; k < 3; ++k)
    normals[2 * k] = Vec3::Unit(static_cast<int>(k)), normals[2 * k + 1] = -normals[2 * k];
  normals[6].setZero();
  expect_same_surface(state.scan, read_state(write_state(state), "s").scan);
}

TEST(ScanState, KeepsTheThinCopy) {
  ScanState state = dressed();
  auto thin = std::make_shared<ThinScan>();
  thin->scan = state.scan;
  const std::size_t n = state.scan.mesh.positions.size();
  for (std::size_t v = 0; v < n; ++v)
    thin->of_vertex.push_back(static_cast<std::uint32_t>(n - 1 - v));
  thin->of_vertex[0] = ThinScan::kNone;
  state.scan.mesh.normals[0] = Vec3::UnitY();  // as a vertex without a place has it
  for (std::size_t v = 1; v < n; ++v)
    state.scan.mesh.normals[v] = thin->scan.mesh.normals[n - 1 - v];
  state.scan.thin = thin;
  const ScanState back = read_state(write_state(state), "s");
  expect_same_surface(state.scan, back.scan);
  ASSERT_NE(back.scan.thin, nullptr);
  EXPECT_EQ(back.scan.thin->of_vertex, thin->of_vertex);
  expect_same_surface(thin->scan, back.scan.thin->scan);
}

TEST(ScanState, TakesThirtyBytesAVertex) {
  ScanState state = dressed();
  state.true_labels.clear();
  const std::size_t n = state.scan.mesh.positions.size();
  EXPECT_LT(write_state(state).size(), 30 * n + 1000);
  state.scan.mesh.triangles.clear();
  EXPECT_LT(write_state(state).size(), 20 * n + 1000);
}

TEST(ScanState, RefusesAnotherVersionAndBrokenFiles) {
  const std::string good = write_state(dressed());
  EXPECT_NE(refusal("").find("no state"), std::string::npos);
  EXPECT_NE(refusal("ply\nformat").find("no state"), std::string::npos);
  std::string other = good;
  other[16] = 2;
  EXPECT_NE(refusal(other).find("version 2"), std::string::npos);
  for (const std::size_t size : {17U, 40U, 91U, 92U, 4000U})
    EXPECT_NE(refusal(good.substr(0, size)).find("broken"), std::string::npos) << size;
  EXPECT_NE(refusal(good + "x").find("bytes in place of"), std::string::npos);
  other = good;
  other[other.size() / 2] ^= 1;
  EXPECT_NE(refusal(other).find("digest"), std::string::npos);
}

TEST(ScanState, SurvivesWhateverStandsBehindAGoodDigest) {
  ScanState state = dressed();
  for (auto* list : {&state.scan.mesh.positions, &state.scan.mesh.normals}) list->resize(60);
  state.scan.mesh.colours.resize(60), state.scan.mesh.triangles = {{0, 1, 2}, {57, 58, 59}};
  state.scan.outlier.resize(60), state.scan.invented.resize(60), state.true_labels.resize(60);
  const std::string good = write_state(state);
  Dice dice(77);
  int refused = 0;
  for (int round = 0; round < 4000; ++round) {
    std::string bytes = good;
    for (int k = 0; k < 3; ++k) {
      const auto at = kHead + static_cast<std::size_t>(dice.uniform(0, 1) *
                                                       static_cast<double>(bytes.size() - kHead));
      bytes[at] = static_cast<char>(dice.uniform(0, 256));
    }
    if (round % 4 == 0) bytes.resize(kHead + round % (bytes.size() - kHead));
    try {
      const ScanState read = read_state(sealed(bytes), "s");
      for (const Triangle& t : read.scan.mesh.triangles)
        for (const std::uint32_t v : t) ASSERT_LT(v, read.scan.mesh.positions.size());
    } catch (const ReadError&) {
      ++refused;
    }
  }
  EXPECT_GT(refused, 1000);  // all that end too early, and more
  EXPECT_LT(refused, 4000);
}

TEST(ScanState, RefusesVectorsThatContradictEachOther) {
  ScanState state = dressed();
  state.true_labels.pop_back();
  EXPECT_THROW(write_state(state), InvalidInput);
  state = dressed();
  state.scan.outlier.pop_back();
  EXPECT_THROW(write_state(state), InvalidInput);
}

}  // namespace
}  // namespace regarment
