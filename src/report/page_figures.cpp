#include <array>

#include "base/error.h"
#include "report/page_parts.h"
#include "report/text.h"

namespace regarment {
namespace {

struct Look {
  const char* kind;
  const char* title;
  const char* caption;
};

constexpr std::array<Look, 4> kLooks = {{
    {"scan", "Scan", "The scan as it was read."},
    {"segmentation", "Segmentation", "Each vertex in the colour of its label; grey is the person."},
    {"placement", "Placement", "Where the garment starts, before it is laid on the scan."},
    {"garment", "Garment", "The garment found, laid on the scan."},
}};

std::string media_type(const std::string& file, std::string_view bytes) {
  if (file.ends_with(".webp") && bytes.starts_with("RIFF") && bytes.substr(8).starts_with("WEBP")) {
    return "image/webp";
  }
  if (file.ends_with(".jpg") && bytes.starts_with("\xff\xd8\xff")) return "image/jpeg";
  if (file.ends_with(".png") && bytes.starts_with("\x89PNG\r\n")) return "image/png";
  throw ReadError(file + ": is not the picture its name says; run 'regarment fit' again");
}

View view_figure(const Figure& figure, const Look& look, const PageParts& parts,
                 const std::string& subject) {
  const auto bytes = parts.pictures.find(figure.file);
  if (bytes == parts.pictures.end()) {
    throw ReadError(figure.file + ": the picture is missing; run 'regarment fit' again");
  }
  View view;
  view.set("source",
           "data:" + media_type(figure.file, bytes->second) + ";base64," + base64(bytes->second));
  view.set("view", figure.view);
  view.set("alt", std::string(look.title) + " of " + subject + ", seen from the " + figure.view);
  view.set("width", std::to_string(figure.width));
  view.set("height", std::to_string(figure.height));
  return view;
}

}  // namespace

void view_figures(const Result& result, const PageParts& parts, View& page) {
  std::vector<View> before, after;
  for (const Look& look : kLooks) {
    std::vector<View> figures;
    for (const Figure& figure : result.figures) {
      if (figure.kind == look.kind) {
        figures.push_back(view_figure(figure, look, parts, result.scan.file));
      }
    }
    if (figures.empty()) continue;
    std::vector<View>& row = std::string_view(look.kind) == "scan" ? before : after;
    View& view = row.emplace_back();
    view.set("kind", look.kind);
    view.set("name", look.title);
    view.set("caption", look.caption);
    view.set("first", row.size() == 1);
    view.set("figures", std::move(figures));
  }
  page.set("has_figures", !before.empty() || !after.empty());
  page.set("before", std::move(before));
  page.set("after", std::move(after));
}

}  // namespace regarment
