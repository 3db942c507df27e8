#include "app/check_job_words.h"

#include "app/command_line.h"
#include "app/finish_fit.h"

namespace regarment {
namespace {

Command parsed(std::vector<std::string> words, const std::vector<std::string>& more) {
  words.insert(words.begin(), "regarment");
  words.insert(words.end(), more.begin(), more.end());
  std::vector<const char*> argv;
  argv.reserve(words.size());
  for (const std::string& word : words) argv.push_back(word.c_str());
  return parse_command_line(static_cast<int>(argv.size()), argv.data());
}

void check_fit(const FitArguments& fit) { analyze_options(fit, templates_of(fit)); }

}  // namespace

void check_job_words(JobKind kind, const std::vector<std::string>& garments,
                     const std::vector<std::string>& words) {
  if (kind == JobKind::Refit) {
    const auto refit = std::get<RefitArguments>(parsed({"refit", "result", "--out", "out"}, words));
    FitArguments fit;
    fit.garments = garments;
    fit.known = refit.known;
    check_fit(fit);
  } else if (!garments.empty()) {
    std::vector<std::string> command = {"fit", "scan.ply", "--out", "out"};
    for (const std::string& garment : garments)
      command.insert(command.end(), {"--garment", garment});
    check_fit(std::get<FitArguments>(parsed(command, words)));
  }
}

}  // namespace regarment
