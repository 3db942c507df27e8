#pragma once

#include "app/command_line.h"
#include "app/console.h"

// The commands: each checks what it was given, makes one call and answers. They throw the errors
// of base/error.h, which `main` turns into an exit status.

namespace regarment {

/// Finds the garments and writes the result folder. Says the report's path, or result.json.
void run_fit(const FitArguments& arguments, Console& console);

/// Fits the scan of a stored result again from its state, with the options of that result where no
/// others are given. Says as `run_fit`.
void run_refit(const RefitArguments& arguments, Console& console);

/// Fits the scans of a table, or compares another's estimates, and sums up. Says the page's path,
/// or evaluation.json. Throws GateError when a gate failed, and NoGarmentError when a scan came to
/// no result and no gate speaks of failures; both once everything is written.
void run_evaluate(const EvaluateArguments& arguments, Console& console);

/// Fits the scans of a table here or by Slurm, goes on where it was, and sums up; or says how far a
/// batch is. Throws as run_evaluate once everything is written.
void run_batch(const BatchArguments& arguments, Console& console);

/// One shard of a batch, or its merge: what its tasks run. Throws as run_evaluate after a merge.
void run_batch_task(const BatchTaskArguments& arguments, Console& console);

/// Makes dressed people with known dimensions, scanned, into a folder. Says its ground-truth table.
void run_synthesize(const SynthesizeArguments& arguments, Console& console);

/// Makes report.html of a stored result again. Says its path.
void run_report(const ReportArguments& arguments, Console& console);

/// Makes one page to review many stored results by. Says its path.
void run_review(const ReviewArguments& arguments, Console& console);

/// Draws each mesh from four sides into NAME-SIDE.png. Says the files.
void run_render(const RenderArguments& arguments, Console& console);

/// Measures how fast this program is. Says a table, or it as JSON.
void run_bench(const BenchArguments& arguments, Console& console);

/// Lists the templates, or shows one with its measurements, bounds and drawing.
void run_templates(const TemplatesArguments& arguments, Console& console);

/// Runs jobs of the store until it is stopped, which is how it ends well: status 0.
void run_worker_command(const WorkerArguments& arguments, Console& console, const StopSignal& stop);

/// Adds, lists or revokes API keys. Says a new key, which nobody can find out again.
void run_key(const KeyArguments& arguments, Console& console);

/// Reads the service's config and shows every field with who set it.
void run_config(const ConfigArguments& arguments, Console& console);

/// Looks at what the service stands on, a line each. Throws GateError when something failed.
void run_doctor(const DoctorArguments& arguments, Console& console);

/// Serves jobs over HTTP until a signal asks it to stop; says "listening on ADDRESS" once it does.
/// Requests and events go to standard error as lines of JSON.
void run_serve(const ServeArguments& arguments, const StopSignal& stop);

}  // namespace regarment
