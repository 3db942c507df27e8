#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <memory>
#include <set>
#include <sstream>

#include "app/command_line.h"
#include "base/error.h"

namespace regarment {
namespace {

std::string answer(std::vector<const char*> words) {
  words.insert(words.begin(), "regarment");
  return std::get<TextAnswer>(parse_command_line(static_cast<int>(words.size()), words.data()))
      .text;
}

// What a command prints.
std::string output_of(const std::string& command) {
  const std::unique_ptr<FILE, int (*)(FILE*)> pipe(popen(command.c_str(), "r"), pclose);
  std::string out;
  std::array<char, 4096> part{};
  while (pipe && std::fgets(part.data(), part.size(), pipe.get()) != nullptr) out += part.data();
  return out;
}

// What bash offers after these words, the last of which is being typed.
std::set<std::string> offered(const std::vector<std::string>& words) {
  const auto file = std::filesystem::temp_directory_path() /
                    ("regarment-completion-" + std::to_string(::getpid()));
  std::ofstream(file) << answer({"completion", "bash"});
  std::string list;
  for (const std::string& word : words) list += " '" + word + "'";
  std::istringstream found(
      output_of("cd / && bash --norc -c 'source \"" + file.string() +
                "\"; COMP_WORDS=(regarment \"$@\"); COMP_CWORD=$#; _regarment; " +
                "printf \"%s\\n\" \"${COMPREPLY[@]}\"' bash" + list));
  std::filesystem::remove(file);
  std::set<std::string> out;
  for (std::string line; std::getline(found, line);)
    if (!line.empty()) out.insert(line);
  return out;
}

TEST(Completion, OffersCommands) {
  EXPECT_EQ(offered({"rep"}), std::set<std::string>{"report"});
  EXPECT_TRUE(offered({""}).contains("fit"));
  EXPECT_TRUE(offered({""}).contains("templates"));
}

TEST(Completion, OffersTheOptionsOfACommand) {
  EXPECT_EQ(offered({"fit", "--garm"}), std::set<std::string>{"--garment"});
  EXPECT_TRUE(offered({"report", "--garm"}).empty());
}

TEST(Completion, OffersValuesWhereOnlySomeAreAllowed) {
  EXPECT_EQ(offered({"fit", "--units", "m"}), (std::set<std::string>{"m", "mm"}));
}

TEST(Completion, OffersFilesWhereOnesAreNamed) {
  EXPECT_TRUE(offered({"fit", "etc"}).contains("etc"));  // in the root folder
}

TEST(Completion, ComesForEachShellAndNoOther) {
  EXPECT_TRUE(answer({"completion", "zsh"}).starts_with("#compdef regarment\n"));
  EXPECT_NE(answer({"completion", "fish"}).find("-l garment"), std::string::npos);
  EXPECT_THROW(answer({"completion", "csh"}), UsageError);
  EXPECT_THROW(answer({"completion"}), UsageError);
}

TEST(ManualPage, NamesEveryCommandAndOption) {
  const std::string page = answer({"manual"});
  for (const char* command : {"fit", "refit", "evaluate", "synthesize", "report", "render"}) {
    EXPECT_NE(page.find(std::string(".SS regarment ") + command), std::string::npos) << command;
    std::istringstream words(answer({command, "--help"}));
    for (std::string word; words >> word;) {
      if (!word.starts_with("--") || word.find('\'') != std::string::npos) continue;
      word = word.substr(2, word.find_first_not_of("abcdefghijklmnopqrstuvwxyz-", 2) - 2);
      std::string written = "\\-\\-";
      for (const char c : word) written += c == '-' ? std::string("\\-") : std::string(1, c);
      EXPECT_NE(page.find(written), std::string::npos) << command << " " << word;
    }
  }
}

TEST(ManualPage, HasNoLineThatRoffTakesForARequestByMistake) {
  const std::set<std::string> requests = {"TH", "SH", "SS", "TP", "B", "I"};
  std::istringstream page(answer({"manual"}));
  for (std::string line; std::getline(page, line);) {
    EXPECT_FALSE(line.starts_with("'")) << line;
    if (line.starts_with(".")) {
      EXPECT_TRUE(requests.contains(line.substr(1, line.find(' ') - 1))) << line;
    }
  }
}

}  // namespace
}  // namespace regarment
