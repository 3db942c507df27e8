#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

namespace regarment {

/// How well labels agree with true ones. Vertices whose true label is 255 are not scored.
struct LabelScore {
  std::size_t scored = 0;                  // vertices compared
  double accuracy = 0.0;                   // share of them with the right label, 0..1
  double mean_iou = 0.0;                   // mean over the classes that occur in the truth, 0..1
  std::vector<std::optional<double>> iou;  // person, garment 1, ...: common over either; none
                                           // where neither the labels nor the truth have the class
};

/// Compares labels 0..garments with the truth. Both have one entry per vertex (InvalidInput).
/// Throws ReadError on a true label that is neither one of these nor 255, and when all are 255.
LabelScore score_labels(const std::vector<std::uint8_t>& labels,
                        const std::vector<std::uint8_t>& truth, std::size_t garments);

/// Reads one byte per vertex. ReadError when the file's size is not `vertices`.
std::vector<std::uint8_t> read_labels(const std::filesystem::path& file, std::size_t vertices);

}  // namespace regarment
