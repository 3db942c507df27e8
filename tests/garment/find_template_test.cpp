#include "garment/find_template.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>

#include "base/error.h"
#include "support/folders.h"
#include "support/texts.h"

namespace regarment {
namespace {

std::string message_of(const std::string& name_or_path) {
  return refusal_of<Error>([&] { find_template(name_or_path); });
}

TEST(FindTemplate, HasTheTwoBuiltInByName) {
  EXPECT_EQ(find_template("skirt").title(), "Skirt");
  EXPECT_EQ(find_template("tshirt").title(), "T-shirt");
}

TEST(FindTemplate, ReadsAPathThatEndsInJson) {
  EXPECT_EQ(find_template(std::string(TEMPLATE_FOLDER) + "/skirt.json").name(), "skirt");
  EXPECT_EQ(message_of("nowhere/cape.json"), "nowhere/cape.json: no such template file");
  EXPECT_THROW(find_template(TEMPLATE_FOLDER "/garment-template.schema.json"), ReadError);
}

TEST(FindTemplate, ListsTheNamesThereAreWhenAskedForAnother) {
  EXPECT_EQ(message_of("cape"),
            "there is no garment template 'cape'; there are skirt, tshirt, or give the path of a "
            ".json file");
  EXPECT_EQ(message_of("../etc/passwd"),
            "'../etc/passwd' is neither the name of a garment template (skirt, tshirt) nor a path "
            "ending in .json");
  EXPECT_THROW(find_template(""), UsageError);
  EXPECT_EQ(message_of("a\nb").find('\n'), std::string::npos);
}

/// Sets REGARMENT_TEMPLATES for one test.
class TemplateVariable {
 public:
  explicit TemplateVariable(const std::string& value) {
    setenv("REGARMENT_TEMPLATES", value.c_str(), 1);
  }
  ~TemplateVariable() { unsetenv("REGARMENT_TEMPLATES"); }
};

TEST(FindTemplate, LooksFirstInTheFoldersOfTheEnvironment) {
  const TemporaryFolder temporary;
  const std::filesystem::path& folder = temporary.path();
  std::string text = bytes_of(TEMPLATE_FOLDER "/skirt.json");
  const std::string title = "\"title\": \"Skirt\"";
  text.replace(text.find(title), title.size(), "\"title\": \"Kilt\"");
  std::ofstream(folder / "skirt.json") << text;
  std::ofstream(folder / "kilt.json") << text;
  std::ofstream(folder / "broken.json") << "{";
  {
    const TemplateVariable variable("/nowhere:" + folder.string());
    EXPECT_EQ(find_template("skirt").title(), "Kilt");
    EXPECT_EQ(find_template("kilt").title(), "Kilt");
    EXPECT_THROW(find_template("broken"), ReadError);
    std::string names;
    for (const TemplateEntry& entry : list_templates())
      names += entry.name + "=" + entry.title + (entry.source == "built in" ? "* " : " ");
    EXPECT_EQ(names, "kilt=Kilt skirt=Kilt tshirt=T-shirt* ");
  }
  EXPECT_EQ(find_template("skirt").title(), "Skirt");
}

}  // namespace
}  // namespace regarment
