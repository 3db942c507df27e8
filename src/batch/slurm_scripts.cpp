#include "batch/slurm_scripts.h"

#include "batch/run_scans.h"
#include "report/text.h"

namespace regarment {
namespace {

// Beyond what poisonous scans cost: times a task may find its shard in another's hands.
constexpr std::size_t kMoreRestarts = 20;

constexpr const char* kRequeueing =
    "# What ends a task before its scans are done (a crash, a kill, a full disk) makes it leave\n"
    "# with 75. Slurm takes it up again, and it goes on where it was, when slurm.conf says\n"
    "#   RequeueExit=75\n"
    "# Without that the task stays failed, and the merge job fits what it left.\n";

// Paths come after the first command only: sbatch looks for options in all lines before it.
std::string head(const std::string& name, const std::string& more) {
  return "#!/bin/bash\n#SBATCH --job-name=" + name +
         "\n#SBATCH --ntasks=1\n#SBATCH --cpus-per-task=1\n#SBATCH --requeue\n"
         "#SBATCH --output=/dev/null\n" +
         more + kRequeueing + "set -u\n";
}

// `log`: as the shell reads it, in the folder log/ of the batch.
std::string body(const Manifest& manifest, const SlurmOptions& options, const std::string& log,
                 const std::string& words) {
  const std::size_t most = kMostAttempts * manifest.shard_size + kMoreRestarts;
  return "cd -- " + shell_quoted(options.here.string()) + " || exit 75\nexec >>" +
         shell_quoted((options.folder / "log").string()) + "/" + log + " 2>&1 || exit 75\n" +
         shell_quoted(options.program.string()) + " batch-task " +
         shell_quoted(options.folder.string()) + words +
         "\nstatus=$?\n"
         "[ \"$status\" -lt 128 ] || status=75\n"
         "# Nothing is to come back for ever.\n"
         "[ \"$status\" != 75 ] || [ \"${SLURM_RESTART_COUNT:-0}\" -lt " +
         std::to_string(most) + " ] || status=1\nexit \"$status\"\n";
}

std::string quoted_words(const std::vector<std::string>& words) {
  std::string out;
  for (const std::string& word : words) out += " " + shell_quoted(word);
  return out;
}

}  // namespace

std::string array_indices(const std::vector<std::size_t>& shards) {
  std::string out;
  for (std::size_t i = 0; i < shards.size();) {
    std::size_t last = i;
    while (last + 1 < shards.size() && shards[last + 1] == shards[last] + 1) ++last;
    out += (out.empty() ? "" : ",") + std::to_string(shards[i]);
    if (last > i) out += "-" + std::to_string(shards[last]);
    i = last + 1;
  }
  return out;
}

std::string array_script(const Manifest& manifest, const std::vector<std::size_t>& shards,
                         const SlurmOptions& options) {
  std::string array = "#SBATCH --array=" + array_indices(shards);
  if (options.at_once > 0) array += "%" + std::to_string(options.at_once);
  return head("regarment", array + "\n") + body(manifest, options,
                                                "shard-\"$SLURM_ARRAY_TASK_ID\".log",
                                                " --shard \"$SLURM_ARRAY_TASK_ID\" --quiet");
}

std::string merge_script(const Manifest& manifest, const SlurmOptions& options) {
  std::string words = " --merge --quiet";
  for (const std::string& gate : options.gates) words += " --gate " + shell_quoted(gate);
  return head("regarment-merge", "") + body(manifest, options, "merge.log", words);
}

std::string submit_script(bool with_array, const SlurmOptions& options) {
  const std::string words = quoted_words(options.words), folder = options.folder.string();
  std::string out =
      "#!/bin/sh\n"
      "# Submits the batch: its array, and the merge for when all tasks of that have ended.\n"
      "set -eu\n"
      "command -v sbatch >/dev/null || { echo 'there is no sbatch here' >&2; exit 127; }\n"
      "scontrol show config | grep -Eq '^RequeueExit +=.*[ ,]75(,|$)' ||\n"
      "  echo 'slurm.conf has no RequeueExit=75: the merge job will fit what killed tasks leave'\n";
  const std::string sbatch = "$(sbatch --parsable" + words;
  if (with_array) {
    out += "array=" + sbatch + " " + shell_quoted(folder + "/array.sbatch") + ")\n";
    out += "merge=" + sbatch + " --dependency=afterany:\"${array%%;*}\" " +
           shell_quoted(folder + "/merge.sbatch") + ")\n";
    return out + "echo \"array ${array%%;*}, merge ${merge%%;*}\"\n";
  }
  out += "merge=" + sbatch + " " + shell_quoted(folder + "/merge.sbatch") + ")\n";
  return out + "echo \"merge ${merge%%;*}\"\n";
}

}  // namespace regarment
