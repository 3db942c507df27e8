#include "evaluation/measurement_plot.h"

#include <algorithm>

#include "garment/svg_text.h"
#include "report/chart_axis.h"
#include "report/svg_path.h"
#include "report/text.h"

namespace regarment {
namespace {

constexpr double kLeft = 224, kRight = 16, kTop = 6, kBottom = 40, kRow = 32;
constexpr double kShownErrors = 0.98;

class Plot {
 public:
  explicit Plot(const std::vector<MeasurementErrors>& rows) : rows_(rows) {
    std::vector<double> all, always = {0};
    for (const MeasurementErrors& row : rows) {
      all.insert(all.end(), row.errors_cm.begin(), row.errors_cm.end());
      always.push_back(row.bias_cm);
    }
    range_ = range_showing(always, all, kShownErrors);
  }

  std::string drawn() {
    axis();
    for (std::size_t i = 0; i < rows_.size(); ++i)
      row(rows_[i], kTop + kRow * static_cast<double>(i));
    return path_element("band", bands_) + path_element("grid", grid_) +
           path_element("level zero", zero_) + path_element("dots s0", dots_) +
           path_element("box", boxes_) + path_element("median", medians_) +
           path_element("level truth", means_) + words_;
  }

 private:
  double x(double error) const {
    return kLeft +
           std::clamp(range_.share(error), 0.0, 1.0) * (kMeasurementPlotWidth - kLeft - kRight);
  }

  double bottom() const { return kTop + kRow * static_cast<double>(rows_.size()); }

  void axis() {
    for (const AxisTick& tick : axis_ticks(range_, 9)) {
      grid_.move_to(x(tick.value), kTop);
      grid_.vertical_to(bottom());
      words_ += text_element(x(tick.value), bottom() + 17, "x", tick.text);
    }
    zero_.move_to(x(0), kTop);
    zero_.vertical_to(bottom());
    words_ += text_element(0.5 * (kLeft + kMeasurementPlotWidth - kRight), bottom() + 34, "x",
                           "error, cm");
  }

  static void rectangle(SvgPath& to, double left, double top, double right, double low) {
    to.move_to(left, top);
    to.horizontal_to(right);
    to.vertical_to(low);
    to.horizontal_to(left);
    to.vertical_to(top);
  }

  void row(const MeasurementErrors& row, double top) {
    const double middle = top + 0.5 * kRow;
    words_ += text_element(kLeft - 10, middle + 4, "y", xml_escaped(row.name));
    if (row.limit_cm)
      rectangle(bands_, x(-*row.limit_cm), top + 4, x(*row.limit_cm), top + kRow - 4);
    for (std::size_t i = 0; i < row.errors_cm.size(); ++i) {
      // Spread over the row by their place in the list, so that dots do not hide each other.
      const double spread = static_cast<double>(i * 7 % 11) - 5;
      dots_.dot(x(row.errors_cm[i]), middle + 1.1 * spread);
    }
    rectangle(boxes_, x(quantile(row.errors_cm, 0.25)), middle - 7,
              x(quantile(row.errors_cm, 0.75)), middle + 7);
    const double median = x(quantile(row.errors_cm, 0.5));
    medians_.move_to(median, middle - 7);
    medians_.vertical_to(middle + 7);
    means_.move_to(x(row.bias_low_cm.value_or(row.bias_cm)), middle + 11);
    means_.horizontal_to(x(row.bias_high_cm.value_or(row.bias_cm)) + 0.5);
  }

  const std::vector<MeasurementErrors>& rows_;
  AxisRange range_;
  SvgPath bands_, grid_, zero_, dots_, boxes_, medians_, means_;
  std::string words_;
};

}  // namespace

std::vector<MeasurementErrors> measurement_errors(const std::vector<EvaluatedScan>& scans,
                                                  const std::vector<GroupStatistics>& groups) {
  std::vector<MeasurementErrors> out;
  for (const GroupStatistics& group : groups) {
    if (group.by != "measurement" || group.errors.n == 0) continue;
    MeasurementErrors row{
        group.name, {}, group.errors.bias_cm, group.errors.bias_low_cm, group.errors.bias_high_cm,
        {}};
    if (group.iso) row.limit_cm = group.iso->limit_cm;
    for (const EvaluatedScan& scan : scans) {
      for (std::size_t d = 0; d < scan.found.size(); ++d) {
        const TrueDimension& truth = scan.about.dimensions[d];
        if (!scan.found[d] || truth.hidden() || measurement_key(truth) != group.key) continue;
        row.errors_cm.push_back(scan.found[d]->value_cm - truth.truth_cm);
      }
    }
    out.push_back(std::move(row));
  }
  return out;
}

int measurement_plot_height(std::size_t measurements) {
  return static_cast<int>(kTop + kRow * static_cast<double>(measurements) + kBottom);
}

std::string measurement_plot(const std::vector<MeasurementErrors>& rows) {
  return Plot(rows).drawn();
}

}  // namespace regarment
