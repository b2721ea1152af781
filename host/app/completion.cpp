// sailmap completion: what a shell needs to complete words after `sailmap`.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <memory>
#include <string>

#include "command_tree.hpp"
#include "commands.hpp"
#include "options.hpp"

namespace sailmap::app {
namespace {

// The words of a command line before the cursor are followed down the tree of commands; then what may stand
// at the cursor is a value, an option, a subcommand or a positional. Values are words, or @file, @folder or
// @value for what no list can name. Bash splits `--option=value` into three words.
constexpr const char* head = R"bash(# Completion of sailmap in bash, made by `sailmap completion bash`.

_sailmap_complete() { # WHAT WORD: fills COMPREPLY
  case $1 in
    @file) compopt -o filenames 2>/dev/null; mapfile -t COMPREPLY < <(compgen -f -- "$2") ;;
    @folder) compopt -o filenames 2>/dev/null; mapfile -t COMPREPLY < <(compgen -d -- "$2") ;;
    @value) COMPREPLY=() ;;
    *) mapfile -t COMPREPLY < <(compgen -W "$1" -- "$2") ;;
  esac
}

_sailmap() {
  local word=${COMP_WORDS[COMP_CWORD]} path=sailmap value='' item i positionals=0
  for ((i = 1; i < COMP_CWORD; ++i)); do
    item=${COMP_WORDS[i]}
    if [[ $item == = ]]; then
      continue
    elif [[ -n $value ]]; then
      value=''
    elif [[ $item == -* ]]; then
      value=$(_sailmap_value "$path" "$item")
    elif [[ " $(_sailmap_commands "$path") " == *" $item "* ]]; then
      path+=" $item"
    else
      ((++positionals))
    fi
  done
  [[ $word == = ]] && word=''
  if [[ -n $value ]]; then
    _sailmap_complete "$value" "$word"
  elif [[ $word == -* ]]; then
    _sailmap_complete "$(_sailmap_options "$path")" "$word"
  elif [[ -n $(_sailmap_commands "$path") ]]; then
    _sailmap_complete "$(_sailmap_commands "$path")" "$word"
  else
    _sailmap_complete "$(_sailmap_positional "$path" "$positionals")" "$word"
  fi
}

)bash";

constexpr const char* tail = "complete -F _sailmap sailmap\n";

std::string words_of(const Argument& argument) {
  switch (argument.kind) {
    case ValueKind::none:
      return "";
    case ValueKind::choice:
      return fmt::format("{}", fmt::join(argument.choices, " "));
    case ValueKind::folder:
      return "@folder";
    case ValueKind::file:
      return "@file";
    case ValueKind::other:
      break;
  }
  return "@value";
}

template <class Visit>
void for_each(const Command& command, Visit visit) {
  visit(command);
  for (const Command& child : command.commands) for_each(child, visit);
}

// A shell function that prints what `body` gives for the command $1; lines of `body` are cases.
template <class Cases>
std::string function(const std::string& name, const std::string& subject, const Command& root, Cases cases) {
  std::string out = fmt::format("{}() {{\n  case {} in\n", name, subject);
  for_each(root, [&](const Command& command) { out += cases(command); });
  return out + "  esac\n}\n\n";
}

std::string line(const std::string& pattern, const std::string& words) {
  return words.empty() ? "" : fmt::format("    {}) echo '{}' ;;\n", pattern, words);
}

// Options of the whole program may stand behind its subcommands, but for these.
bool of_root_alone(const Argument& argument) {
  return argument.names.back() == "--help" || argument.names.back() == "--version";
}

std::string options_of(const Command& command, const Command& root) {
  std::vector<std::string> names;
  const auto add = [&names](const Argument& argument) {
    if (argument.positional) return;
    names.insert(names.end(), argument.names.begin(), argument.names.end());
  };
  for (const Argument& argument : command.arguments) add(argument);
  for (const Argument& argument : root.arguments) {
    if (&command != &root && !of_root_alone(argument)) add(argument);
  }
  return fmt::format("{}", fmt::join(names, " "));
}

std::string values_of(const Command& command, const Command& root) {
  std::string out;
  for (const Argument& argument : command.arguments) {
    if (argument.positional) continue;
    for (const std::string& name : argument.names) {
      const std::string before = &command == &root ? "sailmap*" : fmt::format("'{}'", command.name());
      out += line(before + "' " + name + "'", words_of(argument));
    }
  }
  return out;
}

// The last one takes what comes after it.
std::string positionals_of(const Command& command) {
  std::string out;
  for (std::size_t i = 0; i < command.arguments.size() && command.arguments[i].positional; ++i) {
    const bool last = i + 1 == command.arguments.size() || !command.arguments[i + 1].positional;
    out += line(fmt::format("'{} '{}", command.name(), last ? "*" : std::to_string(i)),
                words_of(command.arguments[i]));
  }
  return out;
}

std::string bash_completion(const Command& root) {
  const std::string command = "$1";
  const std::string command_and_more = "\"$1 $2\"";
  return std::string(head) +
         function("_sailmap_commands", command, root,
                  [](const Command& c) {
                    std::string words;
                    for (const Command& child : c.commands) {
                      words += (words.empty() ? "" : " ") + child.path.back();
                    }
                    return line("'" + c.name() + "'", words);
                  }) +
         function("_sailmap_options", command, root,
                  [&root](const Command& c) { return line("'" + c.name() + "'", options_of(c, root)); }) +
         function("_sailmap_value", command_and_more, root,
                  [&root](const Command& c) { return values_of(c, root); }) +
         function("_sailmap_positional", command_and_more, root,
                  [](const Command& c) { return positionals_of(c); }) +
         tail;
}

}  // namespace

void add_completion(CLI::App& app) {
  CLI::App* command = app.add_subcommand(
      "completion", "Print what a shell needs to complete sailmap's words; installed with the program");
  const auto shell = std::make_shared<std::string>();
  one_of(command->add_option("SHELL", *shell, "Which shell: `source <(sailmap completion bash)`"), {"bash"})
      ->required();
  command->callback([&app, shell] { fmt::print("{}", bash_completion(command_tree(app))); });
}

}  // namespace sailmap::app
