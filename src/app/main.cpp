// The program: reads the command line, runs one command, turns errors into an exit status.

#include <unistd.h>

#include <new>

#include "app/commands.h"
#include "base/error.h"
#include "base/one_line.h"

namespace regarment {
namespace {

constexpr int kInternal = 1;
constexpr int kTemporary = 75;

// The one line of a failure, whatever the message holds.
int fail(int status, const std::string& message) {
  const std::string line = "regarment: " + one_line(message, 2000) + "\n";
  // Nothing is left to be told when this cannot be written.
  (void)!::write(STDERR_FILENO, line.data(), line.size());
  return status;
}

struct Run {
  const StopSignal& stop;

  void operator()(const TextAnswer& answer) const { Console::answer(answer.text); }
  void operator()(const FitArguments& arguments) const {
    Console console(arguments.speech, stop);
    run_fit(arguments, console);
  }
  void operator()(const RefitArguments& arguments) const {
    Console console(arguments.speech, stop);
    run_refit(arguments, console);
  }
  void operator()(const EvaluateArguments& arguments) const {
    Console console(arguments.speech, stop);
    run_evaluate(arguments, console);
  }
  void operator()(const BatchArguments& arguments) const {
    Console console(arguments.speech, stop);
    run_batch(arguments, console);
  }
  void operator()(const BatchTaskArguments& arguments) const {
    Console console(arguments.speech, stop);
    run_batch_task(arguments, console);
  }
  void operator()(const SynthesizeArguments& arguments) const {
    Console console(arguments.speech, stop);
    run_synthesize(arguments, console);
  }
  void operator()(const ReportArguments& arguments) const {
    Console console(arguments.speech, stop);
    run_report(arguments, console);
  }
  void operator()(const ReviewArguments& arguments) const {
    Console console(arguments.speech, stop);
    run_review(arguments, console);
  }
  void operator()(const RenderArguments& arguments) const {
    Console console(arguments.speech, stop);
    run_render(arguments, console);
  }
  void operator()(const BenchArguments& arguments) const {
    Console console(arguments.speech, stop);
    run_bench(arguments, console);
  }
  void operator()(const TemplatesArguments& arguments) const {
    Console console(arguments.speech, stop);
    run_templates(arguments, console);
  }
  void operator()(const KeyArguments& arguments) const {
    Console console(arguments.speech, stop);
    run_key(arguments, console);
  }
  void operator()(const ConfigArguments& arguments) const {
    Console console(arguments.speech, stop);
    run_config(arguments, console);
  }
  void operator()(const DoctorArguments& arguments) const {
    Console console(arguments.speech, stop);
    run_doctor(arguments, console);
  }
  void operator()(const ServeArguments& arguments) const { run_serve(arguments, stop); }
  void operator()(const WorkerArguments& arguments) const {
    Console console(arguments.speech, stop);
    run_worker_command(arguments, console, stop);
  }
};

int run(int argc, const char* const* argv) {
  const StopSignal stop;
  try {
    std::visit(Run{stop}, parse_command_line(argc, argv));
    return 0;
  } catch (const Stopped&) {
    return stop.tell();
  } catch (const Error& error) {
    if (stop.asked()) return stop.tell();
    return fail(error.exit_status(), error.what());
  } catch (const std::bad_alloc&) {
    return fail(kTemporary, "out of memory; give the program more or a scan with fewer vertices");
  } catch (const std::exception& error) {
    return fail(kInternal, std::string("internal error: ") + error.what() + "; please report it");
  }
}

}  // namespace
}  // namespace regarment

int main(int argc, char** argv) { return regarment::run(argc, argv); }
