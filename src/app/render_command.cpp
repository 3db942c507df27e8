#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

#include "app/commands.h"
#include "base/error.h"
#include "base/one_line.h"
#include "render/render_figures.h"
#include "report/output_folder.h"
#include "scan/make_scan.h"
#include "scan/read_sandboxed.h"

namespace regarment {
namespace {

namespace fs = std::filesystem;

// A person stands upright; anything else is drawn as it lies in its file, y up.
Mesh upright(Mesh mesh) {
  try {
    return make_scan(mesh).mesh;
  } catch (const NoPersonError&) {
    return mesh;
  }
}

std::string picture_name(const fs::path& mesh, const Figure& figure) {
  return mesh.filename().string() + "-" + std::string(view_name(figure.view)) + ".png";
}

void draw(const fs::path& path, int pixel_ratio, const Progress& progress, OutputFolder& out,
          std::vector<std::string>& names) {
  const Mesh mesh = upright(read_mesh_sandboxed(path, {}, progress).mesh);
  const Scene scene{
      .scan = mesh, .labels = {}, .values = {}, .cap = {}, .outlier = {}, .garments = {}};
  const std::array<Look, 1> looks = {Look::Scan};
  FigureOptions options;
  options.framing.width *= pixel_ratio;
  options.framing.height *= pixel_ratio;
  options.pixel_ratio = pixel_ratio;
  for (const Figure& figure : render_figures(scene, looks, options)) {
    progress.report("draw", 0.5);
    const std::vector<std::byte> bytes = encode_image(figure.image, ImageFormat::Png);
    std::string text(bytes.size(), '\0');
    std::transform(bytes.begin(), bytes.end(), text.begin(),
                   [](std::byte b) { return static_cast<char>(b); });
    names.push_back(picture_name(path, figure));
    out.write(names.back(), text);
  }
}

// Two meshes of one name would overwrite each other's pictures.
void check_names(const std::vector<fs::path>& meshes) {
  std::set<std::string> seen;
  for (const fs::path& mesh : meshes) {
    if (!seen.insert(mesh.filename().string()).second) {
      throw UsageError("MESH: two files are called " + mesh.filename().string() +
                       "; draw them into two folders");
    }
  }
}

}  // namespace

void run_render(const RenderArguments& arguments, Console& console) {
  check_names(arguments.meshes);
  OutputFolder out(arguments.out, arguments.force, arguments.meshes);
  const Progress progress = console.progress();
  std::vector<std::string> names;
  for (const fs::path& mesh : arguments.meshes)
    draw(mesh, arguments.pixel_ratio, progress, out, names);
  out.publish();
  nlohmann::ordered_json files = nlohmann::ordered_json::array();
  for (const std::string& name : names) {
    const std::string path = one_line((arguments.out / name).string(), 4096);
    console.say(path);
    files.push_back(path);
  }
  if (console.wants_json()) {
    console.answer(nlohmann::ordered_json({{"pictures", files}}).dump(2) + "\n");
  }
}

}  // namespace regarment
