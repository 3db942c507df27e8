#include "made_garments.h"

#include <cmath>
#include <cstring>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numbers>
#include <optional>
#include <sstream>

#include "base/error.h"
#include "base/random.h"
#include "garment/find_template.h"
#include "garment/plane.h"

namespace regarment {
namespace {

using nlohmann::json;

constexpr double kReach = 0.05;  // m on the panel within which a vertex's triangle is looked for

// A garment's file as the program writes it: x y z in the scan's unit, s t in m.
struct DrapedFile {
  std::vector<Vec3> positions;
  std::vector<Vec2> flat;
  std::vector<int> panel;
  std::vector<Triangle> triangles;
};

std::size_t count_in(const std::string& header, const std::string& element) {
  const std::size_t at = header.find("element " + element + " ");
  if (at == std::string::npos) throw ReadError("a garment's PLY has no " + element);
  return std::stoul(header.substr(at + element.size() + 9));
}

template <typename T>
T take(const std::string& bytes, std::size_t& at) {
  if (at + sizeof(T) > bytes.size()) throw ReadError("a garment's PLY ends too early");
  T out{};
  std::memcpy(&out, bytes.data() + at, sizeof(T));
  at += sizeof(T);
  return out;
}

// Vertices stand once per panel, panel by panel, so a panel is what triangles hang together.
void number_panels(DrapedFile& file) {
  std::vector<std::size_t> root(file.flat.size());
  for (std::size_t v = 0; v < root.size(); ++v) root[v] = v;
  const auto find = [&](std::size_t v) {
    while (root[v] != v) v = root[v] = root[root[v]];
    return v;
  };
  for (const Triangle& t : file.triangles) {
    for (std::size_t k = 1; k < 3; ++k) {
      const std::size_t a = find(t[0]), b = find(t[k]);
      root[std::max(a, b)] = std::min(a, b);
    }
  }
  int panels = 0;
  for (std::size_t v = 0; v < root.size(); ++v) {
    const std::size_t r = find(v);
    file.panel.push_back(r == v ? panels++ : file.panel[r]);
  }
}

DrapedFile read_draped(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  const std::string bytes((std::istreambuf_iterator<char>(in)), {});
  const std::string mark = "end_header\n";
  std::size_t at = bytes.find(mark);
  if (at == std::string::npos) throw ReadError(path.string() + ": no PLY header");
  const std::string header = bytes.substr(0, at);
  at += mark.size();
  DrapedFile out;
  const std::size_t vertices = count_in(header, "vertex"), faces = count_in(header, "face");
  for (std::size_t v = 0; v < vertices; ++v) {
    std::array<double, 5> row{};
    for (double& value : row) value = static_cast<double>(take<float>(bytes, at));
    out.positions.emplace_back(row[0], row[1], row[2]);
    out.flat.emplace_back(row[3], row[4]);
  }
  for (std::size_t f = 0; f < faces; ++f) {
    if (take<std::uint8_t>(bytes, at) != 3) throw ReadError(path.string() + ": not a triangle");
    Triangle t{};
    for (auto& v : t) v = take<std::uint32_t>(bytes, at);
    for (const auto v : t) {
      if (v >= vertices) throw ReadError(path.string() + ": a triangle names no vertex");
    }
    out.triangles.push_back(t);
  }
  number_panels(out);
  return out;
}

// Where a flat point of a panel lies, by the triangle it is in or nearest to being in.
Vec3 place(const DrapedFile& file, int panel, const Vec2& p) {
  double best = -1e9;
  Vec3 out = Vec3::Zero();
  for (const Triangle& t : file.triangles) {
    if (file.panel[t[0]] != panel || (file.flat[t[0]] - p).squaredNorm() > kReach * kReach)
      continue;
    const Vec2 &a = file.flat[t[0]], &b = file.flat[t[1]], &c = file.flat[t[2]];
    const double area = twice_area(a, b, c);
    const Vec3 w(twice_area(p, b, c) / area, twice_area(a, p, c) / area,
                 twice_area(a, b, p) / area);
    if (!w.allFinite() || w.minCoeff() <= best) continue;
    best = w.minCoeff();
    out = w[0] * file.positions[t[0]] + w[1] * file.positions[t[1]] + w[2] * file.positions[t[2]];
  }
  return out;
}

Dimensions metres(const json& centimetres) {
  Dimensions out;
  for (const auto& [name, value] : centimetres.items()) out[name] = value.get<double>() / 100;
  return out;
}

double metres_per(const std::string& unit) {
  if (unit == "m") return 1;
  if (unit == "cm") return 0.01;
  return unit == "mm" ? 0.001 : 0.0254;
}

}  // namespace

std::vector<MadeGarment> read_made_garments(const std::filesystem::path& folder,
                                            double edge_length) {
  std::ifstream in(folder / "truth" / "truth.json");
  const json cases = json::parse(in, nullptr, false);
  if (!cases.is_array()) throw ReadError((folder / "truth/truth.json").string() + ": no cases");
  std::vector<MadeGarment> out;
  for (const json& one : cases) {
    for (const json& garment : one.at("garments")) {
      MadeGarment made;
      made.name = one.at("name").get<std::string>() + ".garment" +
                  std::to_string(garment.at("layer").get<int>());
      made.template_name = garment.at("template");
      made.flat = metres(garment.at("measurements_cm"));
      made.worn = metres(garment.at("worn_cm"));
      made.hidden = garment.at("not_observable").get<std::vector<std::string>>();
      const DrapedFile file = read_draped(folder / "truth" / (made.name + ".ply"));
      const GarmentTemplate garment_template = find_template(made.template_name);
      made.pattern = make_pattern(garment_template, made.flat, edge_length);
      const double unit = metres_per(one.at("scan").at("unit"));
      for (std::size_t v = 0; v < made.pattern.flat.size(); ++v) {
        made.draped.push_back(unit * place(file, made.pattern.panel[v], made.pattern.flat[v]));
      }
      made.laid = garment_template.nearest_possible(made.worn);
      move_pattern(garment_template, made.laid, made.pattern);
      out.push_back(std::move(made));
    }
  }
  return out;
}

void disturb(std::vector<Vec3>& positions, double rms, std::uint64_t seed) {
  constexpr int kWaves = 60;
  Random random(seed);
  const auto direction = [&] {
    return Vec3(random.normal(), random.normal(), random.normal()).normalized();
  };
  std::vector<Vec3> moved(positions.size(), Vec3::Zero());
  for (int wave = 0; wave < kWaves; ++wave) {
    const Vec3 k = 2 * std::numbers::pi / random.uniform(0.06, 0.15) * direction();
    const Vec3 way = rms * std::sqrt(2.0 / kWaves) * direction();
    const double phase = random.uniform(0, 2 * std::numbers::pi);
    for (std::size_t v = 0; v < positions.size(); ++v) {
      moved[v] += std::cos(k.dot(positions[v]) + phase) * way;
    }
  }
  for (std::size_t v = 0; v < positions.size(); ++v) positions[v] += moved[v];
}

}  // namespace regarment
