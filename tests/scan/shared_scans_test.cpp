// The scans of the shared folder against what is known of them. Skipped where the folder is not.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>

#include "geometry/mesh_io.h"
#include "scan/make_scan.h"

namespace regarment {
namespace {

using std::filesystem::path;

std::optional<path> scans_folder() {
  const char* given = std::getenv("REGARMENT_SHARED");
  const path shared = given ? path(given) : path(REGARMENT_SOURCE_DIR).parent_path() / "shared";
  if (!std::filesystem::is_directory(shared / "scans")) return std::nullopt;
  return shared / "scans";
}

struct Known {
  std::string file;
  std::string units = "m", up = "+y";
  Vec3 front = Vec3::UnitZ();  // in the file
  double front_within = 3;     // degrees
};

void PrintTo(const Known& known, std::ostream* out) { *out << known.file; }

/// Up +z means: facing -y, turned about z; up +y: facing +z, turned about y.
std::vector<Known> of_truth(const path& folder) {
  std::vector<Known> all;
  std::ifstream file(folder / "truth" / "truth.json");
  for (const auto& entry : nlohmann::json::parse(file)) {
    const auto& scan = entry["scan"];
    const double yaw = scan["yaw"].get<double>() * 3.14159265358979 / 180;
    const bool z_up = scan["up"] == "z";
    for (const char* kind : {".cloud.ply", ".mesh.ply"}) {
      Known known;
      known.file = entry["name"].get<std::string>() + kind;
      known.units = scan["unit"];
      known.up = z_up ? "+z" : "+y";
      known.front =
          z_up ? Vec3(std::sin(yaw), -std::cos(yaw), 0) : Vec3(std::sin(yaw), 0, std::cos(yaw));
      known.front_within = 4;  // some hold the trunk turned against the legs
      all.push_back(known);
    }
  }
  return all;
}

std::vector<Known> known_scans() {
  const auto folder = scans_folder();
  if (!folder) return {Known{""}};
  std::vector<Known> all = of_truth(*folder);
  for (const auto& entry : std::filesystem::directory_iterator(*folder / "bodies")) {
    all.push_back({"bodies/" + entry.path().filename().string(), "m", "+z", -Vec3::UnitY()});
  }
  for (const char* name : {"naked-female", "skirt-and-top", "tshirt-and-jeans"}) {
    all.push_back({"artist/" + std::string(name) + ".obj"});
  }
  // Facing as their faces and feet do, by eye.
  all.push_back({"real/shirt-and-trousers.obj", "m", "+y", Vec3(0.2, 0, 1).normalized(), 15});
  all.push_back({"real/skirt-and-top.obj", "m", "+y", Vec3(1, 0, 0.1).normalized(), 10});
  std::sort(all.begin(), all.end(), [](const Known& a, const Known& b) { return a.file < b.file; });
  return all;
}

class SharedScan : public testing::TestWithParam<Known> {};

TEST_P(SharedScan, IsUnderstood) {
  const Known& known = GetParam();
  const auto folder = scans_folder();
  if (!folder) GTEST_SKIP() << "no shared scans (REGARMENT_SHARED)";
  const path file = *folder / known.file;
  std::ifstream in(file, std::ios::binary);
  const std::vector<char> bytes{std::istreambuf_iterator<char>(in), {}};
  const auto span = std::as_bytes(std::span(bytes));
  const Scan scan = make_scan(parse_mesh(span, recognise_format(span, file), known.file));
  const ScanFacts& facts = scan.facts;
  EXPECT_EQ(facts.units, known.units);
  EXPECT_EQ(facts.up, known.up);
  const Vec3 front = scan.file_from_body.linear().col(2).normalized();
  const double off =
      std::acos(std::clamp(front.dot(known.front), -1.0, 1.0)) * 180 / 3.14159265358979;
  EXPECT_LT(off, known.front_within);
  EXPECT_GT(facts.front_confidence, 0.85);
  EXPECT_GT(facts.height, 1.5);
  EXPECT_LT(facts.height, 2.0);
  std::printf(
      "%s: %s, up %s, front %s (%.1f degrees off, sure %.3f), %.3f m, noise %.2f mm, "
      "spacing %.2f mm, %zu outliers, %zu holes\n",
      known.file.c_str(), facts.units.c_str(), facts.up.c_str(), facts.front.c_str(), off,
      facts.front_confidence, facts.height, facts.noise * 1e3, facts.spacing * 1e3, facts.outliers,
      facts.holes);
  for (const Finding& finding : facts.findings) {
    std::printf("  %s: %s\n", finding.code.c_str(), finding.found.c_str());
  }
}

INSTANTIATE_TEST_SUITE_P(All, SharedScan, testing::ValuesIn(known_scans()), [](const auto& test) {
  std::string name = test.param.file.empty() ? "None" : test.param.file;
  for (char& c : name) c = std::isalnum(static_cast<unsigned char>(c)) ? c : '_';
  return name;
});

}  // namespace
}  // namespace regarment
