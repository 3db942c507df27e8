// How well worn_stretch tells flat garments from worn ones, on true drapes of made people:
//
//   build/release/regarment synthesize --out out/people --cases 200 --seed 4
//   build/release/fabric_benchmark out/people
//
// Per dimension: mean absolute error in cm of flat = worn / (1 + stretch) with no stretch, with the
// mean stretch of the cases, and with worn_stretch; and how often the truth is within one standard
// deviation. A second argument disturbs the cloth by so many millimetres (3); a third writes every
// stretch to a CSV file.

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <iterator>

#include "fabric/worn_stretch.h"
#include "garment/find_template.h"
#include "made_garments.h"

namespace {

using namespace regarment;

constexpr double kExact = 0.001;  // m, error of the pattern's triangles against the true cloth

struct Row {
  std::string garment, dimension;
  double flat = 0, worn = 0;  // m
  Stretch stretch;

  double true_stretch() const { return worn / flat - 1; }
  double error(double stretch_taken) const { return worn / (1 + stretch_taken) - flat; }
};

std::vector<Row> rows_of(const std::vector<MadeGarment>& garments, double noise) {
  StretchOptions options;
  options.cloth_error = std::max(noise, kExact);
  std::vector<Row> out;
  for (std::size_t k = 0; k < garments.size(); ++k) {
    MadeGarment made = garments[k];
    disturb(made.draped, noise, k);
    const auto stretch = worn_stretch(find_template(made.template_name), made.laid, made.pattern,
                                      made.draped, options);
    for (const auto& [name, value] : stretch) {
      if (std::find(made.hidden.begin(), made.hidden.end(), name) != made.hidden.end()) continue;
      out.push_back({made.name, made.template_name + " " + name, made.flat.at(name),
                     made.worn.at(name), value});
    }
  }
  return out;
}

void print(const std::string& name, const std::vector<Row>& rows) {
  double mean = 0, none = 0, constant = 0, told = 0, bias = 0, within = 0;
  const auto n = static_cast<double>(rows.size());
  for (const Row& row : rows) mean += row.true_stretch() / n;
  for (const Row& row : rows) {
    none += 100 * std::abs(row.error(0)) / n;
    constant += 100 * std::abs(row.error(mean)) / n;
    told += 100 * std::abs(row.error(row.stretch.mean)) / n;
    bias += 100 * row.error(row.stretch.mean) / n;
    const double miss = std::abs(row.true_stretch() - row.stretch.mean);
    within += (miss <= row.stretch.standard_deviation ? 1 : 0) / n;
  }
  std::printf("%-22s n %3zu  none %5.2f  constant %5.2f  told %5.2f  bias %5.2f  within %3.0f %%\n",
              name.c_str(), rows.size(), none, constant, told, bias, 100 * within);
}

void print_all(const std::vector<Row>& rows) {
  std::vector<std::string> names;
  names.reserve(rows.size());
  for (const Row& row : rows) names.push_back(row.dimension);
  std::sort(names.begin(), names.end());
  names.erase(std::unique(names.begin(), names.end()), names.end());
  for (const std::string& name : names) {
    std::vector<Row> some;
    std::copy_if(rows.begin(), rows.end(), std::back_inserter(some),
                 [&](const Row& row) { return row.dimension == name; });
    print(name, some);
  }
}

void write_csv(const std::vector<Row>& rows, const char* path) {
  std::ofstream out(path);
  out << "garment,dimension,flat_m,worn_m,true_stretch,stretch,standard_deviation\n";
  for (const Row& row : rows) {
    out << row.garment << ',' << row.dimension << ',' << row.flat << ',' << row.worn << ','
        << row.true_stretch() << ',' << row.stretch.mean << ',' << row.stretch.standard_deviation
        << '\n';
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) {
    std::cerr << "usage: fabric_benchmark FOLDER_OF_SYNTHESIZE [NOISE_MM [CSV]]\n";
    return 2;
  }
  try {
    const double noise = argc > 2 ? std::atof(argv[2]) / 1000 : 0.003;
    const std::vector<Row> rows = rows_of(read_made_garments(argv[1], 0.015), noise);
    print_all(rows);
    if (argc > 3) write_csv(rows, argv[3]);
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
  }
  return 0;
}
