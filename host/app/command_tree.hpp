// The program's commands and options as its parser knows them, for whatever describes them: completion, man
// pages.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace sailmap::app {

enum class ValueKind {
  none,    // a flag
  choice,  // one of `choices`
  folder,
  file,
  other  // a number, say
};

// An option, a flag or a positional.
struct Argument {
  std::vector<std::string> names;  // "-h", "--help"; of a positional "SOURCE" alone
  bool positional = false;
  bool required = false;
  bool repeated = false;
  ValueKind kind = ValueKind::none;
  std::string value;                 // what stands for the value in the help: "FILE", "box|disk"
  std::vector<std::string> choices;  // of ValueKind::choice
  std::string standard;              // the default, when there is one to show
  std::string help;
  std::string group;  // "Options" when it has no other
};

struct Command {
  std::vector<std::string> path;  // "sailmap", "map", "info"
  std::string help;
  std::string footer;
  std::vector<Argument> arguments;  // positionals first, each in the order of the help
  std::vector<Command> commands;

  [[nodiscard]] std::string name() const;  // "sailmap map info"
};

// All that `app` has been given. Hidden options (without a group) are left out.
Command command_tree(const CLI::App& app);

}  // namespace sailmap::app
