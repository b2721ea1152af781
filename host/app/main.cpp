// The program `sailmap`: parses the command line, runs one subcommand, turns errors into one line and an exit
// code.
#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>

#include <CLI/CLI.hpp>
#include <exception>

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
  app.get_formatter()->column_width(38);
  app.footer(
      "Results go to standard output and files, progress and messages to standard error.\n"
      "Exit codes: 0 done, 1 something failed (one line says what), 2 wrong use.");
  sailmap::app::add_detect(app);
  sailmap::app::add_match(app);
  sailmap::app::add_run(app);
  sailmap::app::add_eval(app);
  sailmap::app::add_simulate(app);
  sailmap::app::add_map(app);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& fault) {
    return app.exit(fault) == 0 ? 0 : exit_usage;
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    spdlog::set_default_logger(spdlog::stderr_color_st("sailmap"));
    spdlog::set_pattern("sailmap: %^%l%$: %v");
    return parse_and_run(argc, argv);
  } catch (const sailmap::app::UsageError& fault) {
    spdlog::error("{}", fault.what());
    return exit_usage;
  } catch (const std::exception& fault) {
    spdlog::error("{}", fault.what());
    return exit_failure;
  }
}
