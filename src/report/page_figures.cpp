#include <array>

#include "base/error.h"
#include "render/heat_map.h"
#include "report/page_parts.h"
#include "report/text.h"

namespace regarment {
namespace {

struct Look {
  const char* kind;
  const char* title;
  const char* caption;
};

constexpr std::array<Look, 6> kLooks = {{
    {"scan", "Scan",
     "The scan as it was read. All pictures have one scale: the bar is 20 cm long."},
    {"segmentation", "Segmentation", "Each vertex in the colour of its label."},
    {"placement", "Placement", "Where the garment starts, before it is laid on the scan."},
    {"drape", "Garment", "The garment found, laid on the scan."},
    {"deviation", "Deviation",
     "How far the scan lies from the garment: red-brown where it is outside of the garment, blue "
     "where it is inside. Grey is what is not this garment's."},
    {"filled", "Holes closed",
     "The segmentation with the scan's holes under garments closed by the garment found; the part "
     "that was added has a colour of its own. It is in filled.ply."},
}};

std::string media_type(const std::string& file, std::string_view bytes) {
  if (file.ends_with(".webp") && bytes.starts_with("RIFF") && bytes.substr(8).starts_with("WEBP")) {
    return "image/webp";
  }
  if (file.ends_with(".jpg") && bytes.starts_with("\xff\xd8\xff")) return "image/jpeg";
  if (file.ends_with(".png") && bytes.starts_with("\x89PNG\r\n")) return "image/png";
  throw ReadError(file + ": is not the picture its name says; run 'regarment fit' again");
}

Gaps show_figure(const StoredFigure& figure, const Look& look, const PageParts& parts,
                 const std::string& subject) {
  const auto bytes = parts.pictures.find(figure.file);
  if (bytes == parts.pictures.end()) {
    throw ReadError(figure.file + ": the picture is missing; run 'regarment fit' again");
  }
  Gaps gaps;
  gaps.set("source",
           "data:" + media_type(figure.file, bytes->second) + ";base64," + base64(bytes->second));
  gaps.set("view", figure.view);
  gaps.set("alt", std::string(look.title) + " of " + subject + ", seen from the " + figure.view);
  gaps.set("width", std::to_string(figure.width));
  gaps.set("height", std::to_string(figure.height));
  return gaps;
}

// A swatch of 18 by 12: a ground, and a line or stripes on it.
Gaps key(const std::string& name, Colour ground, const std::string& path = "") {
  Gaps gaps;
  gaps.set("name", name);
  const std::string line = "<path fill=\"none\" stroke-width=\"2\" stroke=\"" +
                           css_colour(border_colour()) + "\" d=\"" + path + "\"/>";
  gaps.set("drawing", "<path fill=\"" + css_colour(ground) + "\" d=\"M0 0h18v12H0z\"/>" +
                          (path.empty() ? "" : line));
  return gaps;
}

// What the colours and lines of the segmentation mean.
std::vector<Gaps> segmentation_keys(const Result& result) {
  std::vector<Gaps> keys;
  for (const ResultGarment& garment : result.garments) {
    keys.push_back(key(garment.title, garment_colour(garment.layer)));
  }
  const Colour person = garment_colour(0);
  keys.push_back(key("person", person));
  keys.push_back(key("border of a garment", person, "M0 6h18"));
  keys.push_back(key("unsure label, darkest where one half is", label_colour(0, 0.5F)));
  if (result.scan.caps > 0) {
    keys.push_back(
        key("surface that closes a hem", person, "M0 4L4 0M0 10L10 0M5 12L17 0M12 12l6-6"));
  }
  return keys;
}

// The first picture of the scan and of the first look beside it, to stand next to the verdict.
std::vector<Gaps> pair_of(const std::vector<Gaps>& before, const std::vector<Gaps>& after) {
  std::vector<Gaps> pair;
  for (const std::vector<Gaps>* row : {&before, &after}) {
    if (row->empty()) continue;
    pair.push_back(std::get<std::vector<Gaps>>(row->front().values.at("figures")).front());
  }
  return pair;
}

}  // namespace

void show_figures(const Result& result, const PageParts& parts, Gaps& page) {
  std::vector<Gaps> before, after;
  for (const Look& look : kLooks) {
    std::vector<Gaps> figures;
    for (const StoredFigure& figure : result.figures) {
      if (figure.kind == look.kind) {
        figures.push_back(show_figure(figure, look, parts, result.scan.file));
      }
    }
    if (figures.empty()) continue;
    std::vector<Gaps>& row = std::string_view(look.kind) == "scan" ? before : after;
    Gaps& gaps = row.emplace_back();
    gaps.set("kind", look.kind);
    gaps.set("name", look.title);
    gaps.set("caption", look.caption);
    gaps.set("first", row.size() == 1);
    gaps.set("figures", std::move(figures));
    std::vector<Gaps> keys;
    if (std::string_view(look.kind) == "segmentation") keys = segmentation_keys(result);
    gaps.set("has_keys", !keys.empty());
    gaps.set("keys", std::move(keys));
    std::vector<Gaps> legends;
    if (std::string_view(look.kind) == "deviation") legends = show_deviations(result);
    gaps.set("has_legends", !legends.empty());
    gaps.set("legends", std::move(legends));
  }
  page.set("has_figures", !before.empty() || !after.empty());
  page.set("pair", pair_of(before, after));
  page.set("before", std::move(before));
  page.set("after", std::move(after));
}

}  // namespace regarment
