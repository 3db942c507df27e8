#include "report/measurements_csv.h"

#include "report/csv_table.h"
#include "report/text.h"

namespace regarment {
namespace {

std::string cell(const std::optional<double>& value_cm) {
  return value_cm ? fixed_text(*value_cm, 2) : "";
}

bool has_truth(const Result& result) {
  for (const ResultGarment& garment : result.garments) {
    for (const ResultMeasurement& m : garment.measurements) {
      if (m.truth_cm) return true;
    }
  }
  return false;
}

}  // namespace

std::string measurements_csv(const Result& result) {
  const bool with_truth = has_truth(result);
  std::string out =
      "layer,template,code,measurement,value_cm,low_cm,high_cm,worn_cm,observable,fixed" +
      std::string(with_truth ? ",truth_cm,error_cm\n" : "\n");
  for (const ResultGarment& garment : result.garments) {
    for (const ResultMeasurement& m : garment.measurements) {
      out += std::to_string(garment.layer) + "," + csv_text(garment.template_name) + "," +
             csv_text(m.code) + "," + csv_text(m.name) + "," + cell(m.value_cm) + "," +
             cell(m.low_cm) + "," + cell(m.high_cm) + "," + cell(m.worn_cm) + "," +
             (m.observable ? "true," : "false,") + (m.fixed ? "true" : "false");
      if (with_truth) out += "," + cell(m.truth_cm) + "," + cell(m.error_cm());
      out += "\n";
    }
  }
  return out;
}

}  // namespace regarment
