// The program `sailmap`: parses the command line, runs one subcommand, turns errors into one line and an exit
// code.
#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>
#include <tbb/global_control.h>

#include <CLI/CLI.hpp>
#include <csignal>
#include <exception>
#include <opencv2/core/utility.hpp>
#include <optional>

#include "commands.hpp"
#include "sailmap/error.hpp"

namespace {

constexpr int exit_failure = 1;
constexpr int exit_usage = 2;

int parse_and_run(int argc, char** argv) {
  CLI::App app{"sailmap recognises places with a camera and builds a topological map of them."};
  app.name("sailmap");
  app.set_version_flag("--version", SAILMAP_VERSION);
  app.require_subcommand(1);
  app.fallthrough();  // options of the whole program may stand behind the subcommand
  app.get_formatter()->column_width(38);
  app.footer(
      "Results go to standard output and files, progress and messages to standard error.\n"
      "Exit codes: 0 done, 1 something failed (one line says what), 2 wrong use.");
  int threads = 0;
  app.add_option("--threads", threads, "Threads to work on; 0: one a core. Results do not depend on it")
      ->check(CLI::Range(0, 1024).description(""))
      ->capture_default_str();
  std::optional<tbb::global_control> limit;
  app.parse_complete_callback([&] {
    if (threads > 0) limit.emplace(tbb::global_control::max_allowed_parallelism, threads);
    cv::setNumThreads(threads == 0 ? -1 : threads);
  });
  sailmap::app::add_detect(app);
  sailmap::app::add_match(app);
  sailmap::app::add_run(app);
  sailmap::app::add_eval(app);
  sailmap::app::add_compare(app);
  sailmap::app::add_perturb(app);
  sailmap::app::add_simulate(app);
  sailmap::app::add_map(app);
  sailmap::app::add_loops(app);
  sailmap::app::add_tune(app);
  sailmap::app::add_report(app);
  sailmap::app::add_fabmap(app);
  sailmap::app::add_completion(app);
  sailmap::app::add_manual(app);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& fault) {
    return app.exit(fault) == 0 ? 0 : exit_usage;
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  // A file that grows over the user's limit is then an error like a full disk, not the end of the program.
  std::signal(SIGXFSZ, SIG_IGN);
  try {
    spdlog::set_default_logger(spdlog::stderr_color_st("sailmap"));
    spdlog::set_pattern("sailmap: %^%l%$: %v");
    return parse_and_run(argc, argv);
  } catch (const sailmap::app::Exit& result) {
    return result.code;
  } catch (const sailmap::app::UsageError& fault) {
    spdlog::error("{}", fault.what());
    return exit_usage;
  } catch (const std::exception& fault) {
    spdlog::error("{}", fault.what());
    return exit_failure;
  }
}
