#include "app/every_fit_options.h"

#include <CLI/CLI.hpp>
#include <sstream>

#include "app/command_line.h"
#include "base/error.h"
#include "garment/find_template.h"

namespace regarment {
namespace {

constexpr const char* kGroup = "Every fit";

void forward(CLI::App& command, std::vector<std::string>& words, const std::string& name,
             const std::string& help) {
  command
      .add_option_function<std::string>(
          name,
          [&words, name](const std::string& value) {
            words.push_back(name);
            words.push_back(value);
          },
          help)
      ->group(kGroup);
}

}  // namespace

void add_every_fit_options(CLI::App& command, std::vector<std::string>& words) {
  forward(command, words, "--method", "How to find the dimensions, see 'regarment fit --help'");
  forward(command, words, "--seed", "Seed");
  forward(command, words, "--runs", "Searches of the method annealing");
  forward(command, words, "--evaluations", "Drapes of each search");
  command
      .add_option_function<std::string>(
          "--args",
          [&words](const std::string& text) {
            std::istringstream stream(text);
            for (std::string word; stream >> word;) words.push_back(word);
          },
          "Other options of 'regarment fit', in one text: --args \"--collisions --up +z\"")
      ->group(kGroup);
}

void check_fit_command(const std::vector<std::string>& command,
                       const std::vector<std::string>& garments) {
  std::vector<const char*> words;
  words.reserve(command.size());
  for (const std::string& word : command) words.push_back(word.c_str());
  const Command parsed = parse_command_line(static_cast<int>(words.size()), words.data());
  const auto* fit = std::get_if<FitArguments>(&parsed);
  if (fit == nullptr || fit->garments != garments) {
    throw UsageError("options of fits may not name garments or ask for help");
  }
  if (fit->known.fix.empty() && fit->known.hint.empty()) return;
  AnalyzeOptions how;
  std::vector<GarmentTemplate> templates;
  templates.reserve(garments.size());
  for (const std::string& name : garments) templates.push_back(find_template(name));
  apply_known(fit->known, templates, how);
}

}  // namespace regarment
