// The subcommands. Each add_... puts its options into the program's parser, with a callback that does the
// work.
#pragma once

#include <CLI/CLI.hpp>
#include <stdexcept>

namespace sailmap::app {

// Options that contradict each other.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// The work is done and its result is an exit code: of `map diff`, say.
struct Exit {
  int code = 0;
};

void add_detect(CLI::App& app);
void add_match(CLI::App& app);
void add_run(CLI::App& app);
void add_eval(CLI::App& app);
void add_compare(CLI::App& app);
void add_perturb(CLI::App& app);
void add_simulate(CLI::App& app);
void add_map(CLI::App& app);
// Into the subcommand `map`.
void add_map_upkeep(CLI::App& map);
void add_report(CLI::App& app);
void add_fabmap(CLI::App& app);
void add_loops(CLI::App& app);
void add_tune(CLI::App& app);
// Beneath `map`.
void add_map_export(CLI::App& map);
void add_map_diff(CLI::App& map);
// These describe all the others, whenever those were added.
void add_completion(CLI::App& app);
void add_manual(CLI::App& app);

}  // namespace sailmap::app
