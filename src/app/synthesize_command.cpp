#include <nlohmann/json.hpp>

#include "app/commands.h"
#include "app/synthesize_options.h"
#include "base/one_line.h"
#include "report/output_folder.h"

namespace regarment {

void run_synthesize(const SynthesizeArguments& a, Console& console) {
  const SynthesizeOptions how = synthesize_options(a);
  OutputFolder out(a.out, a.force);
  const auto take = [&](const std::vector<CaseFile>& files) {
    for (const CaseFile& file : files) out.write(file.path, file.bytes);
  };
  const Synthesis synthesis = synthesize(how, take, console.progress());
  take(truth_tables(synthesis));
  out.publish();
  const std::string table = one_line((a.out / "truth" / "ground_truth.csv").string(), 4096);
  console.say(table);
  if (!console.wants_json()) return;
  console.answer(nlohmann::ordered_json({{"cases", how.cases}, {"table", table}}).dump(2) + "\n");
}

}  // namespace regarment
