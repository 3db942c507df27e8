// The scans of the shared folder against their truth. Skipped where the folder is not.
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "findings.h"
#include "scan/make_scan.h"
#include "scan/read_sandboxed.h"

namespace regarment {
namespace {

using std::filesystem::path;
using test::measured;

class SharedScans : public testing::Test {
 protected:
  void SetUp() override {
    const char* given = std::getenv("REGARMENT_SHARED");
    folder_ = (given ? path(given) : path(REGARMENT_SOURCE_DIR).parent_path() / "shared") / "scans";
    if (!std::filesystem::is_directory(folder_))
      GTEST_SKIP() << "no shared scans; set REGARMENT_SHARED to the folder that holds scans/";
  }
  Mesh mesh_of(const std::string& file) const { return read_mesh_sandboxed(folder_ / file).mesh; }
  std::vector<std::uint8_t> labels_of(const std::string& name) const {
    std::ifstream in(folder_ / "truth" / (name + ".labels.u8"), std::ios::binary);
    return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  }
  nlohmann::json truth() const {
    std::ifstream in(folder_ / "truth" / "truth.json");
    return nlohmann::json::parse(in);
  }
  path folder_;
};

/// Mean over the classes that occur of what is labelled and true over what is labelled or true.
/// Vertices of true label 255 do not count.
double mean_iou(const std::vector<std::uint8_t>& label, const std::vector<std::uint8_t>& truth) {
  std::set<std::uint8_t> classes(truth.begin(), truth.end());
  classes.erase(255);
  double sum = 0;
  for (const std::uint8_t c : classes) {
    double both = 0, either = 0;
    for (std::size_t v = 0; v < truth.size(); ++v) {
      if (truth[v] == 255) continue;
      both += label[v] == c && truth[v] == c;
      either += label[v] == c || truth[v] == c;
    }
    sum += both / either;
  }
  return sum / static_cast<double>(classes.size());
}

class UndamagedScans : public SharedScans {
 protected:
  /// All scans of one garment that are neither damaged nor layered.
  void score(const std::string& template_name, const std::vector<std::string>& dimensions) {
    for (const auto& entry : truth()) {
      const std::string name = entry["name"];
      if (name.rfind("corrupt", 0) == 0 || entry["garments"].size() != 1) continue;
      const auto& garment = entry["garments"][0];
      if (garment["template"] != template_name) continue;
      for (const std::string kind : {".mesh", ".cloud"}) {
        try {
          score(name + kind, template_name, dimensions, garment["worn_cm"]);
        } catch (const Error& error) {
          ADD_FAILURE() << name + kind << ": " << error.what();
        }
      }
    }
  }
  double mean_error_cm() const { return error_ / count_; }
  std::string figures() const { return figures_.str(); }  // per scan, for the message

 private:
  void score(const std::string& scan, const std::string& template_name,
             const std::vector<std::string>& dimensions, const nlohmann::json& worn_cm) {
    const Analysis analysis =
        analyze(make_scan(mesh_of(scan + ".ply")), test::templates_of({template_name}));
    const std::vector<std::uint8_t> labels = labels_of(scan);
    ASSERT_EQ(analysis.labels.size(), labels.size()) << scan;
    const double iou = mean_iou(analysis.labels, labels);
    EXPECT_GE(iou, 0.93) << scan;
    figures_ << "\n" << scan << ": IoU " << iou;
    for (const std::string& d : dimensions) {
      const Measurement& m = measured(analysis.garments.at(0), d);
      ASSERT_TRUE(m.worn.has_value()) << scan << " " << d;
      const double error = 100 * *m.worn - worn_cm[d].get<double>();
      figures_ << ", " << d << " " << error << " cm";
      error_ += std::abs(error);
      count_ += 1;
    }
  }
  double error_ = 0, count_ = 0;
  std::ostringstream figures_;
};

TEST_F(UndamagedScans, AreLabelledAndMeasured) {
  score("skirt", {"width", "length", "waist"});
  score("tshirt", {"width", "length"});
  EXPECT_LE(mean_error_cm(), 2.0) << "mean absolute error of worn lengths" << figures();
}

TEST_F(SharedScans, NakedBodiesWearNothing) {
  std::vector<std::string> files{"artist/naked-female.obj"};
  for (const auto& entry : std::filesystem::directory_iterator(folder_ / "bodies"))
    if (entry.path().extension() == ".ply")
      files.push_back("bodies/" + entry.path().filename().string());
  ASSERT_GE(files.size(), 2U);
  for (const std::string& file : files) {
    SCOPED_TRACE(file);
    const Scan scan = make_scan(mesh_of(file));
    for (const char* name : {"skirt", "tshirt"}) test::expect_no_garment(scan, name);
  }
}

/// Garments of what an artist dressed and of real people are found, with all their edges.
TEST_F(SharedScans, DressedFiguresWearWhatTheyWear) {
  const std::pair<const char*, const char*> figures[] = {{"artist/skirt-and-top.obj", "skirt"},
                                                         {"artist/tshirt-and-jeans.obj", "tshirt"}};
  for (const auto& [file, name] : figures) {
    SCOPED_TRACE(file);
    const Analysis analysis = analyze(make_scan(mesh_of(file)), test::templates_of({name}));
    const GarmentAnalysis& garment = analysis.garments.at(0);
    EXPECT_GE(garment.edges.size(), garment.pattern.edges.size());
    EXPECT_GT(garment.vertices_labelled, analysis.labels.size() / 30);
    EXPECT_LT(garment.vertices_labelled, analysis.labels.size() / 2);
  }
}

/// Worn and flat dimensions of a scan of the shared folder after its file was changed.
class MovedScans : public SharedScans {
 protected:
  std::map<std::string, double> dimensions(const Mesh& mesh, const std::string& name) const {
    std::map<std::string, double> out;
    const Analysis analysis = analyze(make_scan(mesh), test::templates_of({name}));
    for (const Measurement& m : analysis.garments.at(0).measurements) {
      out[m.name] = m.flat;
      if (m.worn) out[m.name + " worn"] = *m.worn;
    }
    return out;
  }
  static Mesh moved(Mesh mesh, const Eigen::Matrix3d& turn, double scale) {
    for (Vec3& p : mesh.positions) p = scale * (turn * p) + scale * Vec3(0.3, -0.2, 0.1);
    for (Vec3& n : mesh.normals) n = turn * n;
    return mesh;
  }
  void expect_same(const std::map<std::string, double>& a,
                   const std::map<std::string, double>& b) const {
    ASSERT_EQ(a.size(), b.size());
    for (const auto& [name, value] : a) EXPECT_NEAR(value, b.at(name), 0.002) << name;
  }
};

TEST_F(MovedScans, GiveTheSameDimensions) {
  // A scan with Z up in mm and one with Y up in m.
  const std::tuple<const char*, const char*, Vec3, double> scans[] = {
      {"skirt-1.mesh.ply", "skirt", Vec3::UnitZ(), 1e-3},
      {"tshirt-2.mesh.ply", "tshirt", Vec3::UnitY(), 1.0}};
  for (const auto& [file, name, up, metres] : scans) {
    SCOPED_TRACE(file);
    const Mesh mesh = mesh_of(file);
    const auto still = dimensions(mesh, name);
    const Eigen::Matrix3d turn =
        Eigen::AngleAxisd(37 * std::numbers::pi / 180, up).toRotationMatrix();
    Eigen::Matrix3d axes;  // x to y, y to z, z to x: none of the two that the scans have
    axes << 0, 0, 1, 1, 0, 0, 0, 1, 0;
    {
      SCOPED_TRACE("turned by 37 degrees");
      expect_same(still, dimensions(moved(mesh, turn, 1), name));
    }
    {
      SCOPED_TRACE("other axes");
      expect_same(still, dimensions(moved(mesh, axes, 1), name));
    }
    {
      SCOPED_TRACE("inches");
      expect_same(still,
                  dimensions(moved(mesh, Eigen::Matrix3d::Identity(), metres / 0.0254), name));
    }
  }
}

}  // namespace
}  // namespace regarment
