#include <nlohmann/json.hpp>

#include "app/commands.h"
#include "base/one_line.h"
#include "report/write_review.h"

namespace regarment {

void run_review(const ReviewArguments& a, Console& console) {
  write_review(a.folders, a.out, a.force, console.progress());
  const std::string page = one_line(a.out.string(), 4096);
  console.say(page);
  if (console.wants_json()) {
    console.answer(nlohmann::ordered_json({{"review", page}}).dump(2) + "\n");
  }
}

}  // namespace regarment
