#include "app/command_line.h"

#include <CLI/CLI.hpp>

#include "app/annealing_options.h"
#include "app/bench_options.h"
#include "app/check_arguments.h"
#include "app/evaluate_options.h"
#include "app/one_each.h"
#include "app/shell_help.h"
#include "app/synthesize_options.h"
#include "base/error.h"
#include "base/one_line.h"
#include "report/version.h"

namespace regarment {
namespace {

constexpr const char* kHelpFooter =
    "Exit status: 0 done, 1 internal error, 2 wrong usage, 3 no readable scan or no person,\n"
    "4 not the garment asked for, 5 a gate failed, 75 a temporary failure worth another try,\n"
    "130 and 143 stopped.";

void add_speech(CLI::App& command, Speech& speech) {
  command.add_flag("--quiet", speech.quiet, "No progress on standard error");
  command.add_flag("--json", speech.json, "The result as JSON on standard output");
  command
      .add_option("--progress", speech.progress,
                  "auto: a bar on a terminal, plain lines elsewhere; json: an object a line")
      ->check(CLI::IsMember({"auto", "json"}))
      ->capture_default_str();
}

// A command, what it does, and its options; those of Speech come last, where it has them.
template <class Arguments, class Declare>
CLI::App* add_command(CLI::App& app, const char* name, const char* what, Arguments& a,
                      const Declare& declare) {
  CLI::App* command = app.add_subcommand(name, what);
  declare(*command, a);
  if constexpr (requires { a.speech; }) add_speech(*command, a.speech);
  return command;
}

// What every JSON reader keeps exactly; CLI11 by itself takes -1 for the largest number there is.
std::string whole_number(const std::string& text) {
  constexpr std::size_t kMostDigits = 15;
  const bool fits = !text.empty() && text.size() <= kMostDigits;
  if (fits && text.find_first_not_of("0123456789") == std::string::npos) return {};
  return "'" + text + "' is no whole number of at most 15 digits";
}

void add_seed(CLI::App& command, std::uint64_t& seed) {
  command.add_option("--seed", seed, "Same seed, same bytes")
      ->check(whole_number)
      ->capture_default_str();
}

void add_threads(CLI::App& command, int& threads) {
  command.add_option("--threads", threads, "Threads to use; as many as there are cores by default")
      ->check(CLI::Range(1, 256));
}

void add_pixel_ratio(CLI::App& command, int& ratio) {
  command
      .add_option("--pixel-ratio", ratio,
                  "2: pictures of twice the size, for printing and fine screens")
      ->check(CLI::Range(1, 2))
      ->capture_default_str();
}

void add_fit_options(CLI::App& fit, FitArguments& a) {
  const std::vector<std::string> axes = {"auto", "+x", "-x", "+y", "-y", "+z", "-z"};
  fit.add_option("SCAN", a.scan, "Mesh or point cloud: PLY, OBJ, OFF, STL, GLB, glTF")->required();
  one_each(fit.add_option("--garment", a.garments,
                          "Template name or file; repeat for layers, outermost first"))
      ->required();
  fit.add_option("--out", a.out, "Folder for the result")->required();
  fit.add_option("--name", a.name,
                 "What the scan is called in the result and in the table of true dimensions; its "
                 "file's name by default");
  fit.add_flag("--force", a.force, "Replace a folder that is not empty");
  fit.add_option("--method", a.method, "How to find the dimensions: joint, direct or annealing")
      ->capture_default_str();
  add_seed(fit, a.seed);
  add_threads(fit, a.threads);
  fit.add_flag("!--no-timing", a.timing,
               "Leave out times, thread count and paths, so that two runs give the same bytes");
  fit.add_flag("!--no-state", a.state,
               "Leave no state.bin, by which 'regarment refit' fits the scan again");
  fit.add_option("--units", a.units, "Unit of the scan")
      ->check(CLI::IsMember({"auto", "mm", "cm", "m", "inch"}))
      ->capture_default_str();
  fit.add_option("--up", a.up, "Axis of the scan that points up")
      ->check(CLI::IsMember(axes))
      ->capture_default_str();
  fit.add_option("--front", a.front, "Axis of the scan the person faces along")
      ->check(CLI::IsMember(axes))
      ->capture_default_str();
  fit.add_option("--placement", a.placement, "File with a start position that overrides ours");
  fit.add_option("--ground-truth", a.ground_truth, "CSV table of true dimensions");
  fit.add_option("--ground-truth-labels", a.ground_truth_labels,
                 "True labels, one byte per vertex");
  fit.add_option("--cache", a.cache,
                 "Folder that keeps prepared scans, so that another fit of one begins there");
  fit.add_option("--cache-mb", a.cache_mb, "What it may hold, MB; those used last stay")
      ->check(CLI::Range(1, 1'000'000))
      ->capture_default_str();
  add_pixel_ratio(fit, a.pixel_ratio);
  add_known_options(fit, a.known);
  add_annealing_options(fit, a.annealing);
}

void add_refit_options(CLI::App& refit, RefitArguments& a) {
  refit.add_option("DIR", a.folder, "Folder that 'regarment fit' wrote")->required();
  refit.add_option("--out", a.out, "Folder for the result; DIR itself by default");
  refit.add_flag("--force", a.force, "Replace a folder that is not empty, such as DIR");
  refit.add_flag("--forget", a.forget, "Leave out the help that was given for DIR");
  refit.add_option("--method", a.method, "Another method: joint, direct or annealing");
  add_threads(refit, a.threads);
  refit.add_flag("!--no-timing", a.timing, "Leave out times and thread count");
  refit.add_flag("!--no-state", a.state, "Leave no state for yet another fit");
  add_known_options(refit, a.known);
}

void add_report_options(CLI::App& report, ReportArguments& a) {
  report.add_option("DIR", a.folder, "Folder that 'regarment fit' wrote")->required();
}

void add_review_options(CLI::App& review, ReviewArguments& a) {
  review
      .add_option("DIR", a.folders,
                  "Folders of 'regarment fit' or 'regarment evaluate', or folders of such folders")
      ->required();
  review.add_option("--out", a.out, "The page, such as review.html")->required();
  review.add_flag("--force", a.force, "Replace a page that is there");
}

void add_render_options(CLI::App& render, RenderArguments& a) {
  render.add_option("MESH", a.meshes, "Meshes or point clouds")->required();
  render.add_option("--out", a.out, "Folder for the pictures")->required();
  render.add_flag("--force", a.force, "Replace a folder that is not empty");
  add_pixel_ratio(render, a.pixel_ratio);
}

void add_templates_options(CLI::App& templates, TemplatesArguments& a) {
  templates.add_option("NAME", a.name, "Template name or file");
  one_each(templates.add_option(
      "--at", a.at,
      "With --json: the triangles of the flat pattern at these dimensions, NAME=CM; "
      "others are typical"));
}

// "fit, refit or render"
std::string in_words(const std::vector<std::string>& names) {
  std::string out;
  for (std::size_t i = 0; i < names.size(); ++i)
    out += (i == 0 ? "" : i + 1 == names.size() ? " or " : ", ") + names[i];
  return out;
}

// CLI11 prints an unknown command as an argument it did not expect.
void check_command_name(const CLI::App& app, int argc, const char* const* argv) {
  std::vector<std::string> known;
  for (const CLI::App* command : app.get_subcommands({})) known.push_back(command->get_name());
  if (argc < 2) throw UsageError("no command; use " + in_words(known) + " (--help)");
  const std::string name = argv[1];
  if (name == "-h" || name == "--help" || name == "--version") return;
  if (name.starts_with("-")) {
    throw UsageError("'" + one_line(name, 60) + "' is no option before a command; see --help");
  }
  if (std::find(known.begin(), known.end(), name) != known.end()) return;
  throw UsageError("'" + one_line(name, 60) + "' is no command of this version; use " +
                   in_words(known));
}

std::string in_one_line(const CLI::ParseError& error, const std::string& command) {
  std::string text = error.what();
  if (const auto end = text.find('\n'); end != std::string::npos) text.resize(end);
  return one_line(text, 300) + "; see 'regarment " + command + (command.empty() ? "" : " ") +
         "--help'";
}

}  // namespace

Command parse_command_line(int argc, const char* const* argv) {
  FitArguments fit;
  RefitArguments refit;
  EvaluateArguments evaluate;
  BatchArguments batch;
  BatchTaskArguments batch_task;
  SynthesizeArguments synthesize;
  ReportArguments report;
  ReviewArguments review;
  RenderArguments render;
  TemplatesArguments templates;
  ServeArguments serve;
  WorkerArguments worker;
  KeyArguments key;
  ConfigArguments config;
  DoctorArguments doctor;
  BenchArguments bench;
  CLI::App app("Finds the flat dimensions of garments on 3D scans of dressed people.", "regarment");
  app.require_subcommand(1);
  app.set_version_flag("--version", "regarment " + version());
  app.footer(kHelpFooter);
  CLI::App* fit_app = add_command(app, "fit", "Measure the garments of a dressed person in a scan",
                                  fit, add_fit_options);
  CLI::App* refit_app = add_command(
      app, "refit", "Fit the scan of a result again, with help from a person, without reading it",
      refit, add_refit_options);
  CLI::App* evaluate_app =
      add_command(app, "evaluate", "Measure many scans and compare with their truth", evaluate,
                  add_evaluate_options);
  CLI::App* batch_app =
      add_command(app, "batch", "Measure the scans of a campaign, on one machine or by Slurm",
                  batch, add_batch_options);
  CLI::App* batch_task_app = add_command(app, "batch-task", "What the tasks of 'batch' run",
                                         batch_task, add_batch_task_options);
  CLI::App* synthesize_app =
      add_command(app, "synthesize", "Make scans of dressed people with known dimensions",
                  synthesize, [](CLI::App& command, SynthesizeArguments& a) {
                    add_synthesize_options(command, a);
                    add_seed(command, a.seed);
                  });
  CLI::App* report_app = add_command(app, "report", "Make the report of a stored result again",
                                     report, add_report_options);
  CLI::App* review_app =
      add_command(app, "review", "One page to go through many stored results by keyboard", review,
                  add_review_options);
  CLI::App* render_app = add_command(app, "render", "Draw meshes and clouds from four sides",
                                     render, add_render_options);
  add_command(app, "templates", "List the garment templates, or show one", templates,
              add_templates_options);
  CLI::App* serve_app = add_command(app, "serve", "Serve jobs over HTTP, with pages and workers",
                                    serve, add_serve_options);
  CLI::App* worker_app =
      add_command(app, "worker", "Run queued jobs until stopped", worker, add_worker_options);
  CLI::App* key_app =
      add_command(app, "key", "Add, list or revoke API keys of the service", key, add_key_options);
  CLI::App* config_app =
      add_command(app, "config", "Check the service's config", config, add_config_options);
  CLI::App* doctor_app = add_command(app, "doctor", "Look at what the service stands on", doctor,
                                     [](CLI::App& command, DoctorArguments& a) {
                                       add_place_options(command, a.place);
                                       add_server_option(command, a.place);
                                     });
  CLI::App* bench_app = add_command(app, "bench", "Show how fast this program is on this machine",
                                    bench, add_bench_options);
  std::string shell;
  CLI::App* completion_app = add_completion(app, shell);
  CLI::App* manual_app = add_manual(app);
  for (CLI::App* command : app.get_subcommands({})) {
    command->set_version_flag("--version", "regarment " + version());
    command->footer(kHelpFooter);
  }
  check_command_name(app, argc, argv);
  const auto used = [&] {
    const auto chosen = app.get_subcommands();
    return chosen.empty() ? &app : chosen.front();
  };
  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    return TextAnswer{used()->help()};
  } catch (const CLI::CallForVersion&) {
    return TextAnswer{"regarment " + version() + "\n"};
  } catch (const CLI::ParseError& error) {
    throw UsageError(in_one_line(error, used() == &app ? "" : used()->get_name()));
  }
  if (used() == fit_app) return check(fit), fit;
  if (used() == refit_app) return check(refit), refit;
  if (used() == evaluate_app) return check(evaluate), evaluate;
  if (used() == batch_app) return check(batch), batch;
  if (used() == batch_task_app) return check(batch_task), batch_task;
  if (used() == synthesize_app) return check(synthesize), synthesize;
  if (used() == report_app) return check(report), report;
  if (used() == review_app) return check(review), review;
  if (used() == render_app) return check(render), render;
  if (used() == serve_app) return serve;
  if (used() == worker_app) return worker;
  if (used() == key_app) return check_key(key), key;
  if (used() == config_app) return config;
  if (used() == doctor_app) return doctor;
  if (used() == bench_app) return check_bench(bench), bench;
  if (used() == completion_app) return TextAnswer{completion_script(app, shell)};
  if (used() == manual_app) return TextAnswer{manual_page(app, version())};
  return templates;
}

}  // namespace regarment
