#include "report/label_score.h"

#include "base/error.h"
#include "report/files.h"

namespace regarment {
namespace {

constexpr std::uint8_t kNotScored = 255;

struct ClassCount {
  std::size_t found = 0, real = 0, both = 0;
};

std::vector<ClassCount> count_classes(const std::vector<std::uint8_t>& labels,
                                      const std::vector<std::uint8_t>& truth,
                                      std::size_t garments) {
  std::vector<ClassCount> classes(garments + 1);
  for (std::size_t i = 0; i < truth.size(); ++i) {
    if (truth[i] == kNotScored) continue;
    if (truth[i] > garments) {
      throw ReadError("true labels: vertex " + std::to_string(i) + " has label " +
                      std::to_string(truth[i]) + "; known are 0 (person) to " +
                      std::to_string(garments) + " (a garment each) and 255 (not scored)");
    }
    ++classes[truth[i]].real;
    if (labels[i] <= garments) ++classes[labels[i]].found;
    if (labels[i] == truth[i]) ++classes[truth[i]].both;
  }
  return classes;
}

double share(std::size_t part, std::size_t whole) {
  return static_cast<double>(part) / static_cast<double>(whole);
}

}  // namespace

LabelScore score_labels(const std::vector<std::uint8_t>& labels,
                        const std::vector<std::uint8_t>& truth, std::size_t garments) {
  if (labels.size() != truth.size()) throw InvalidInput("labels and truth differ in length");
  const std::vector<ClassCount> classes = count_classes(labels, truth, garments);
  LabelScore score;
  std::size_t right = 0, real_classes = 0;
  for (const ClassCount& one : classes) {
    score.scored += one.real;
    right += one.both;
    const std::size_t either = one.found + one.real - one.both;
    if (either == 0) {
      score.iou.emplace_back();
      continue;
    }
    score.iou.emplace_back(share(one.both, either));
    if (one.real == 0) continue;
    score.mean_iou += *score.iou.back();
    ++real_classes;
  }
  if (score.scored == 0) throw ReadError("true labels: all are 255, so nothing can be scored");
  score.mean_iou /= static_cast<double>(real_classes);
  score.accuracy = share(right, score.scored);
  return score;
}

std::vector<std::uint8_t> read_labels(const std::filesystem::path& file, std::size_t vertices) {
  const std::string bytes = read_file(file, vertices + 1);
  if (bytes.size() != vertices) {
    throw ReadError(file.filename().string() + ": must hold one byte per vertex of the scan, " +
                    std::to_string(vertices) + ", and is " +
                    (bytes.size() > vertices ? "longer" : std::to_string(bytes.size()) + " long"));
  }
  return {bytes.begin(), bytes.end()};
}

}  // namespace regarment
