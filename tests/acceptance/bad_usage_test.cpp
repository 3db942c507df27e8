#include <gtest/gtest.h>

#include <fstream>

#include "failures.h"
#include "support/folders.h"

namespace regarment {
namespace {

namespace fs = std::filesystem;

void write(const fs::path& file, const std::string& text) {
  std::ofstream(file, std::ios::binary) << text;
}

// Words that stand for files: SCAN an example, NEW a place that may be written, FULL a folder with
// something in it, FILE a file that is no folder, DIR an empty folder.
struct BadUsage {
  std::string name;
  Arguments arguments;
  int status = 2;
  std::string says;
};

std::ostream& operator<<(std::ostream& out, const BadUsage& usage) { return out << usage.name; }

Arguments fit(Arguments more) {
  Arguments all = {"fit", "SCAN", "--garment", "skirt", "--out", "NEW"};
  all.insert(all.end(), more.begin(), more.end());
  return all;
}

class BadUsageTest : public testing::TestWithParam<BadUsage> {
 protected:
  BadUsageTest() {
    fs::create_directory(home_.path() / "full");
    fs::create_directory(home_.path() / "dir");
    write(home_.path() / "full/kept.txt", "kept");
    write(home_.path() / "file", "kept");
  }

  std::string placed(const std::string& word) const {
    if (word == "SCAN") return example("skirt-1.mesh.ply");
    for (const std::string name : {"NEW", "FULL", "FILE", "DIR"}) {
      const std::size_t at = word.find(name);
      if (at == std::string::npos) continue;
      std::string lower = name;
      for (char& c : lower) c = static_cast<char>(std::tolower(c));
      return word.substr(0, at) + (home_.path() / lower).string() + word.substr(at + name.size());
    }
    return word;
  }

  TemporaryFolder home_;
};

TEST_P(BadUsageTest, EndsInOneLineAndTouchesNothing) {
  Arguments arguments;
  for (const std::string& word : GetParam().arguments) arguments.push_back(placed(word));
  expect_failure(run_program(arguments), GetParam().status, GetParam().says);
  EXPECT_EQ(names_in(home_.path()), (std::vector<std::string>{"dir", "file", "full"}));
  EXPECT_EQ(names_in(home_.path() / "full"), std::vector<std::string>{"kept.txt"});
  EXPECT_EQ(names_in(home_.path() / "dir"), std::vector<std::string>{});
}

const std::vector<BadUsage> kTable = {
    {"NoCommand", {}, 2, "no command"},
    {"UnknownCommand", {"stitch"}, 2, "'stitch' is no command"},
    {"EmptyCommand", {""}, 2, "is no command"},
    {"CommandWithControls", {"fi\nt\x1b[31m"}, 2, "fi\\x0at\\x1b[31m"},
    {"EvaluateWithoutOut", {"evaluate", "FILE"}, 2, "--out"},
    {"EvaluateUnknownStatistic",
     {"evaluate", "FILE", "--out", "NEW", "--gate", "mad_cm<1"},
     2,
     "names no statistic"},
    {"EvaluateGateWithoutNumber",
     {"evaluate", "FILE", "--out", "NEW", "--gate", "mae_cm<"},
     2,
     "--gate"},
    {"EvaluateNoTable", {"evaluate", "NEW/none.csv", "--out", "NEW"}, 3, "none.csv"},
    {"EvaluateNoTableInside", {"evaluate", "FILE", "--out", "NEW"}, 3, "line"},
    {"EvaluateEstimatesAndFits",
     {"evaluate", "FILE", "--out", "NEW", "--estimates", "FILE", "--seed", "3"},
     2,
     "--estimates"},
    {"BatchWithoutOut", {"batch", "FILE"}, 2, "--out DIR"},
    {"ServeOnAPortThereIsNot", {"serve", "--data", "NEW", "--port", "70000"}, 2, "port"},
    {"UnknownGlobalOption", {"--colour"}, 2, "--colour"},
    {"FitAlone", {"fit"}, 2, ""},
    {"FitWithoutGarment", {"fit", "SCAN", "--out", "NEW"}, 2, "--garment"},
    {"FitWithoutOut", {"fit", "SCAN", "--garment", "skirt"}, 2, "--out"},
    {"FitWithoutScan", {"fit", "--garment", "skirt", "--out", "NEW"}, 2, "SCAN"},
    {"FitTwoScans", fit({"SCAN"}), 2, ""},
    {"GarmentWithoutValue", {"fit", "SCAN", "--out", "NEW", "--garment"}, 2, "--garment"},
    {"GarmentTwiceInOne", {"fit", "SCAN", "--out", "NEW", "--garment", "tshirt", "skirt"}, 2, ""},
    {"GarmentUnknown", {"fit", "SCAN", "--out", "NEW", "--garment", "toga"}, 2, "toga"},
    {"GarmentEmpty", {"fit", "SCAN", "--out", "NEW", "--garment", ""}, 2, "--garment"},
    {"GarmentIsAPathUp", {"fit", "SCAN", "--out", "NEW", "--garment", "../../etc/passwd"}, 2, ""},
    {"GarmentFileMissing",
     {"fit", "SCAN", "--out", "NEW", "--garment", "DIR/no.json"},
     3,
     "no.json"},
    {"NineGarments",
     fit({"--garment", "skirt", "--garment", "skirt", "--garment", "skirt", "--garment", "skirt",
          "--garment", "skirt", "--garment", "skirt", "--garment", "skirt", "--garment", "skirt"}),
     2, "8"},
    {"UnknownOption", fit({"--colour", "red"}), 2, "--colour"},
    {"OptionShortened", fit({"--forc"}), 2, "--forc"},
    {"MethodUnknown", fit({"--method", "magic"}), 2, "magic"},
    {"MethodTwice", fit({"--method", "direct", "--method", "direct"}), 2, "--method"},
    {"RunsZero", fit({"--method", "annealing", "--runs", "0"}), 2, "--runs"},
    {"RunsNoNumber", fit({"--method", "annealing", "--runs", "many"}), 2, "--runs"},
    {"EvaluationsTooFew", fit({"--method", "annealing", "--evaluations", "3"}), 2, "--evaluations"},
    {"NormalAngleZero", fit({"--method", "annealing", "--normal-angle", "0"}), 2, "--normal-angle"},
    {"NormalAngleNan", fit({"--method", "annealing", "--normal-angle", "nan"}), 2,
     "--normal-angle"},
    {"SegmentDistanceNegative", fit({"--method", "annealing", "--segment-distance", "-1"}), 2,
     "--segment-distance"},
    {"SegmentDistanceNan", fit({"--method", "annealing", "--segment-distance", "nan"}), 2,
     "--segment-distance"},
    {"AttractionSideways", fit({"--method", "annealing", "--attraction", "sideways"}), 2,
     "--attraction"},
    {"DrapeFromNowhere", fit({"--method", "annealing", "--drape-from", "nowhere"}), 2,
     "--drape-from"},
    {"SeedIsNoNumber", fit({"--seed", "abc"}), 2, "--seed"},
    {"SeedIsNegative", fit({"--seed", "-1"}), 2, "--seed"},
    {"SeedIsTooLarge", fit({"--seed", "99999999999999999999999"}), 2, "--seed"},
    {"ThreadsZero", fit({"--threads", "0"}), 2, "--threads"},
    {"ThreadsNegative", fit({"--threads", "-2"}), 2, "--threads"},
    {"ThreadsTooMany", fit({"--threads", "100000"}), 2, "--threads"},
    {"ThreadsBroken", fit({"--threads", "1.5"}), 2, "--threads"},
    {"UnitsUnknown", fit({"--units", "furlong"}), 2, "--units"},
    {"UpUnknown", fit({"--up", "north"}), 2, "--up"},
    {"UpWithoutSign", fit({"--up", "z"}), 2, "--up"},
    {"FrontUnknown", fit({"--front", "+w"}), 2, "--front"},
    {"UpAndFrontOnOneAxis", fit({"--up", "+z", "--front", "-z"}), 2, "--front"},
    {"OutEmpty", {"fit", "SCAN", "--garment", "skirt", "--out", ""}, 2, "--out"},
    {"OutTakesAnOption", {"fit", "SCAN", "--garment", "skirt", "--out", "--force"}, 2, "--out"},
    {"OutIsFull", {"fit", "SCAN", "--garment", "skirt", "--out", "FULL"}, 2, "--force"},
    {"OutIsAFile", {"fit", "SCAN", "--garment", "skirt", "--out", "FILE"}, 2, "no folder"},
    {"OutIsAFileEvenByForce",
     {"fit", "SCAN", "--garment", "skirt", "--out", "FILE", "--force"},
     2,
     "no folder"},
    {"OutBelowAFile", {"fit", "SCAN", "--garment", "skirt", "--out", "FILE/out"}, 2, ""},
    {"OutCannotBeWritten", {"fit", "SCAN", "--garment", "skirt", "--out", "/proc/out"}, 2, "/proc"},
    {"OutIsTheRoot", {"fit", "SCAN", "--garment", "skirt", "--out", "/", "--force"}, 2, "replaced"},
    {"OutHoldsTheWorkingFolder",
     {"fit", "SCAN", "--garment", "skirt", "--out", ".", "--force"},
     2,
     "replaced"},
    {"OutNameTooLong",
     {"fit", "SCAN", "--garment", "skirt", "--out", "DIR/" + std::string(5000, 'x')},
     2,
     ""},
    {"ScanEmptyName", {"fit", "", "--garment", "skirt", "--out", "NEW"}, 2, "SCAN"},
    {"TruthMissing", fit({"--ground-truth", "DIR/none.csv"}), 3, "none.csv"},
    {"TruthIsAFolder", fit({"--ground-truth", "DIR"}), 3, "regular file"},
    {"TruthIsNoTable", fit({"--ground-truth", "FILE"}), 3, "line 1"},
    {"LabelsMissing", fit({"--ground-truth-labels", "DIR/none.u8", "--quiet"}), 3, "none.u8"},
    {"LabelsOfAnotherLength", fit({"--ground-truth-labels", "FILE", "--quiet"}), 3, "43333"},
    {"PlacementMissing", fit({"--placement", "DIR/none.json"}), 3, "none.json"},
    {"PlacementIsNoPlacement", fit({"--placement", "FILE"}), 3, ""},
    {"ReportAlone", {"report"}, 2, "DIR"},
    {"ReportOfNothing", {"report", "DIR"}, 3, "result.json"},
    {"ReportOfAFile", {"report", "FILE"}, 3, ""},
    {"RenderAlone", {"render"}, 2, ""},
    {"RenderWithoutOut", {"render", "SCAN"}, 2, "--out"},
    {"RenderOneNameTwice", {"render", "SCAN", "SCAN", "--out", "NEW"}, 2, "two files"},
    {"RenderOfNothing", {"render", "DIR/none.ply", "--out", "NEW"}, 3, "none.ply"},
    {"TemplateUnknown", {"templates", "toga"}, 2, "toga"},
    {"TemplatesTwo", {"templates", "skirt", "tshirt"}, 2, ""},
    {"TemplateFileIsNoTemplate", {"templates", "FILE.json"}, 3, ""},
};

INSTANTIATE_TEST_SUITE_P(Table, BadUsageTest, testing::ValuesIn(kTable),
                         [](const auto& row) { return row.param.name; });

struct BadTable {
  std::string name, text;
  int status;
  std::string says;
};

class BadTruth : public testing::TestWithParam<BadTable> {};

TEST_P(BadTruth, IsToldBeforeTheWorkBegins) {
  const TemporaryFolder home;
  write(home.path() / "t.csv", GetParam().text);
  const ProgramRun run =
      run_program({"fit", example("skirt-1.mesh.ply"), "--garment", "skirt", "--out",
                   home.path() / "out", "--ground-truth", home.path() / "t.csv"});
  expect_failure(run, GetParam().status, GetParam().says);
  EXPECT_EQ(names_in(home.path()), std::vector<std::string>{"t.csv"});
}

const std::string kHead = "scan,measurement,value_cm\n";

INSTANTIATE_TEST_SUITE_P(
    Table, BadTruth,
    testing::Values(
        BadTable{"Empty", "", 3, "is empty"},
        BadTable{"NoScanColumn", "measurement,value_cm\n", 3, "'scan'"},
        BadTable{"NoValueColumn", "scan,measurement\n", 3, "'value_cm'"},
        BadTable{"NotANumber", kHead + "skirt-1,length,wide\n", 3, "line 2, column value_cm"},
        BadTable{"CommaForPoint", kHead + "skirt-1,length,\"54,5\"\n", 3, "value_cm"},
        BadTable{"NegativeLength", kHead + "skirt-1,length,-54\n", 3, "value_cm"},
        BadTable{"Millimetres", kHead + "skirt-1,length,54000\n", 3, "centimetres"},
        BadTable{"RowTooShort", kHead + "skirt-1,length\n", 3, "line 2"},
        BadTable{"QuoteLeftOpen", kHead + "skirt-1,\"length,54\n", 3, "line 2"},
        BadTable{"ColumnTwice", "scan,scan,measurement,value_cm\n", 3, "twice"},
        BadTable{"NulByte", kHead + std::string("skirt-1,length,5\0", 17) + "\n", 3, "NUL"},
        BadTable{"AnotherScan", kHead + "skirt-2,length,54\n", 2, "skirt-1.mesh.ply"}),
    [](const auto& row) { return row.param.name; });

}  // namespace
}  // namespace regarment
