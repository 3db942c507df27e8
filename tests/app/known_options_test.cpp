#include "app/known_options.h"

#include <gtest/gtest.h>

#include "app/command_line.h"
#include "base/error.h"
#include "garment/find_template.h"

namespace regarment {
namespace {

std::vector<GarmentTemplate> templates(const std::vector<std::string>& names) {
  std::vector<GarmentTemplate> out;
  out.reserve(names.size());
  for (const std::string& name : names) out.push_back(find_template(name));
  return out;
}

AnalyzeOptions applied(const KnownArguments& a, const std::vector<std::string>& garments) {
  AnalyzeOptions how;
  apply_known(a, templates(garments), how);
  return how;
}

std::string refusal(const KnownArguments& a, const std::vector<std::string>& garments = {"skirt"}) {
  try {
    check_known(a);
    applied(a, garments);
  } catch (const UsageError& error) {
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
    return error.what();
  }
  return "";
}

KnownArguments fix(const std::string& text) { return {{text}, {}, ""}; }
KnownArguments hint(const std::string& text) { return {{}, {text}, ""}; }

TEST(KnownOptions, PutSizesIntoMetresByTemplate) {
  const AnalyzeOptions how =
      applied({{"length=54,skirt.hip=95.5", "waist=7e1"}, {}, ""}, {"skirt"});
  const std::map<std::string, Dimensions> expected = {
      {"skirt", {{"length", 0.54}, {"hip", 0.955}, {"waist", 0.70}}}};
  EXPECT_EQ(how.fixed, expected);
}

TEST(KnownOptions, FindTheOnlyGarmentThatIsMeant) {
  const std::vector<std::string> both = {"tshirt", "skirt"};
  EXPECT_TRUE(applied(fix("hip=95"), both).fixed.at("skirt").contains("hip"));
  EXPECT_TRUE(applied(fix("tshirt.length=70"), both).fixed.at("tshirt").contains("length"));
  EXPECT_TRUE(applied(hint("waist_edge=103"), both).placement.edges.contains("skirt.waist"));
  EXPECT_DOUBLE_EQ(applied(hint("tshirt.hem_edge=90"), both).placement.edges.at("tshirt.hem"), 0.9);
  EXPECT_DOUBLE_EQ(applied(hint("left_cuff_edge=120"), both).placement.edges.at("tshirt.left_cuff"),
                   1.2);
}

TEST(KnownOptions, SayWhatIsWrong) {
  const std::vector<std::pair<KnownArguments, const char*>> wrong = {
      {fix("length"), "form NAME=CM"},
      {fix("=5"), "form NAME=CM"},
      {fix(""), "form NAME=CM"},
      {fix("length="), "no length"},
      {fix("length=54cm"), "no length"},
      {fix("length=nan"), "no length"},
      {fix("length=inf"), "no length"},
      {fix("length=-54"), "no length"},
      {fix("length=0"), "no length"},
      {fix("length=1e300"), "no length"},
      {fix("length=54,"), "form NAME=CM"},
      {fix("long\nest=54"), "use length, width, waist, hip"},
      {fix("tshirt.length=54"), "use length, width, waist, hip"},
      {fix("length=540"), "22.0 to 125.0 cm"},
      {fix("length=54,skirt.length=54"), "given twice"},
      {hint("waist=103"), "use hem_edge, waist_edge"},
      {hint("waist_edge=301"), "300 cm"},
      {hint("neck_edge=130"), "use hem_edge, waist_edge"},
      {hint("waist_edge=100,waist_edge=101"), "given twice"},
      {{{}, {}, "silk"}, "woven, jersey or elastic"},
  };
  for (const auto& [arguments, word] : wrong) {
    const std::string message = refusal(arguments);
    EXPECT_NE(message.find(word), std::string::npos) << word << ": " << message;
  }
}

TEST(KnownOptions, AskWhichOfSeveralGarments) {
  EXPECT_NE(refusal(fix("length=60"), {"tshirt", "skirt"}).find("write tshirt.length"),
            std::string::npos);
  EXPECT_NE(refusal(hint("hem_edge=60"), {"tshirt", "skirt"}).find("write tshirt.hem_edge"),
            std::string::npos);
  EXPECT_NE(refusal(fix("length=60"), {"skirt", "skirt"}).find("two garments"), std::string::npos);
}

TEST(KnownOptions, LeaveTheSearchSomethingToDo) {
  AnalyzeOptions how;
  how.method = Method::Annealing;
  const KnownArguments all = fix("length=60,width=130,waist=80,hip=100");
  EXPECT_THROW(apply_known(all, templates({"skirt"}), how), UsageError);
  EXPECT_EQ(refusal(all), "");  // measured, nothing is searched
}

TEST(KnownOptions, ComeFromTheCommandLineAndGoIntoTheResult) {
  const char* words[] = {
      "regarment", "fit",   "a",      "--garment", "skirt",          "--out",    "o",     "--fix",
      "length=54", "--fix", "hip=95", "--hint",    "waist_edge=103", "--fabric", "jersey"};
  const auto a = std::get<FitArguments>(parse_command_line(std::size(words), words));
  using Pairs = std::vector<std::pair<std::string, std::string>>;
  EXPECT_EQ(chosen_known(a.known),
            (Pairs{{"fix", "length=54,hip=95"}, {"hint", "waist_edge=103"}, {"fabric", "jersey"}}));
  EXPECT_EQ(applied(a.known, {"skirt"}).fabric, Fabric::Jersey);
}

}  // namespace
}  // namespace regarment
