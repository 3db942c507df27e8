#include "synthetic/synthesize.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "geometry/mesh_io.h"

namespace regarment {
namespace {

using Files = std::map<std::string, std::string>;

// Coarse cloth, for it is the folder that is looked at and not the folds.
SynthesizeOptions two_skirts() {
  SynthesizeOptions how;
  how.seed = 2;
  how.cases = 2;
  how.wish.garments = {"skirt"};
  how.wish.kind = ScanKind::Cloud;
  how.dress.edge_length = 0.04;
  return how;
}

Files make(const SynthesizeOptions& how) {
  Files out;
  const Synthesis made = synthesize(how, [&](const std::vector<CaseFile>& files) {
    for (const CaseFile& file : files) out[file.path] = file.bytes;
  });
  for (const CaseFile& file : truth_tables(made)) out[file.path] = file.bytes;
  return out;
}

Mesh read(const std::string& bytes) {
  return parse_mesh(std::as_bytes(std::span(bytes)), MeshFormat::Ply, "made");
}

TEST(Synthesize, MakesTheSameFolderOnAnyNumberOfThreads) {
  SynthesizeOptions how = two_skirts();
  const Files one = make(how);
  how.threads = 2;
  EXPECT_EQ(make(how), one);

  const auto truth = nlohmann::json::parse(one.at("truth/truth.json"));
  ASSERT_EQ(truth.size(), 2U);
  for (const auto& each : truth) {
    const std::string name = each["name"];
    const std::string stem = name + ".cloud";
    const Mesh scan = read(one.at(stem + ".ply"));
    EXPECT_TRUE(scan.is_cloud());
    EXPECT_EQ(one.at("truth/" + stem + ".labels.u8").size(), scan.positions.size());
    EXPECT_EQ(each["points"]["points"], scan.positions.size());
    // Some of it is the person, some the skirt.
    EXPECT_GT(each["points"]["labels"]["0"], 1000);
    EXPECT_GT(each["points"]["labels"]["1"], 300);
    EXPECT_FALSE(read(one.at("truth/" + name + ".garment1.ply")).is_cloud());
  }
}

TEST(Synthesize, TheGarmentLiesWhereTheScanSaysSo) {
  // In the file's own frame: points labelled as garment keep to the garment's box.
  SynthesizeOptions how = two_skirts();
  how.cases = 1;
  const Files files = make(how);
  const Mesh scan = read(files.at("case-0000.cloud.ply"));
  const std::string& labels = files.at("truth/case-0000.cloud.labels.u8");
  const Mesh garment = read(files.at("truth/case-0000.garment1.ply"));
  Eigen::AlignedBox3d box;
  for (const Vec3& p : garment.positions) box.extend(p);
  const double slack = 0.02 * box.sizes().maxCoeff();  // the cloth's thickness and noise
  std::size_t inside = 0, all = 0;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    if (labels[i] != 1) continue;
    ++all;
    inside += box.exteriorDistance(scan.positions[i]) <= slack ? 1 : 0;
  }
  EXPECT_GT(all, 300U);
  EXPECT_GT(static_cast<double>(inside), 0.999 * static_cast<double>(all));
}

TEST(Synthesize, StopsWhenToldAndPassesOnWhatTheTakerThrows) {
  const SynthesizeOptions how = two_skirts();
  const auto nothing = [](const std::vector<CaseFile>&) {};
  EXPECT_THROW(synthesize(how, nothing, Progress([](std::string_view, double) { return false; })),
               Stopped);
  SynthesizeOptions one = how;
  one.cases = 1;
  const auto full = [](const std::vector<CaseFile>&) { throw TemporaryError("disk full"); };
  EXPECT_THROW(synthesize(one, full), TemporaryError);
}

TEST(Synthesize, NamesTheOptionThatIsWrong) {
  SynthesizeOptions how;
  how.cases = 0;
  EXPECT_THROW(how.check(), InvalidInput);
}

TEST(Refusal, TellsWhyAPersonIsNotUsed) {
  Dressing dressing;
  dressing.person.garments.resize(1);
  dressing.person.garments[0].template_name = "skirt";
  dressing.reports = {{.came_to_rest = true}};
  EXPECT_EQ(refusal(dressing), "");
  dressing.reports[0].deepest = 0.02;
  EXPECT_NE(refusal(dressing).find("20 mm"), std::string::npos) << refusal(dressing);
  dressing.reports[0] = {};
  EXPECT_NE(refusal(dressing).find("rest"), std::string::npos);
}

}  // namespace
}  // namespace regarment
