#include <nlohmann/json.hpp>

#include "app/commands.h"
#include "base/one_line.h"
#include "report/report_folder.h"

namespace regarment {

void run_report(const ReportArguments& arguments, Console& console) {
  const std::string page = one_line(remake_report(arguments.folder).string(), 4096);
  console.say(page);
  if (console.wants_json()) {
    console.answer(nlohmann::ordered_json({{"report", page}}).dump(2) + "\n");
  }
}

}  // namespace regarment
