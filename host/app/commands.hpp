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

}  // namespace sailmap::app
