#include "command_tree.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>

namespace sailmap::app {
namespace {

// What stands for a value is in capitals ("FILE", "OUT.svg"), unless it is what can be chosen ("box|disk").
bool names_choices(const std::string& type) {
  return !type.empty() && std::ranges::none_of(type, [](unsigned char c) { return std::isupper(c) != 0; });
}

bool begins_with_any(const std::string& text, std::initializer_list<const char*> beginnings) {
  return std::ranges::any_of(beginnings, [&text](const char* b) { return text.starts_with(b); });
}

// Positionals that are texts are names of files throughout.
ValueKind kind_of(const CLI::Option& option, const std::string& type) {
  if (option.get_expected_max() == 0) return ValueKind::none;
  if (names_choices(type)) return ValueKind::choice;
  if (type == "DIR") return ValueKind::folder;
  const bool file =
      begins_with_any(type, {"FILE", "OUT", "NEW", "CONFIG"}) || (option.get_positional() && type == "TEXT");
  return file ? ValueKind::file : ValueKind::other;
}

Argument argument_of(const CLI::Option& option) {
  Argument out;
  out.positional = option.get_positional();
  if (out.positional) {
    out.names = {option.get_name(true)};
  } else {
    for (const std::string& name : option.get_snames()) out.names.push_back("-" + name);
    for (const std::string& name : option.get_lnames()) out.names.push_back("--" + name);
  }
  out.required = option.get_required();
  out.repeated = option.get_expected_max() > 1;
  const std::string type = option.get_type_name();
  out.kind = kind_of(option, type);
  if (out.kind != ValueKind::none) out.value = type;
  if (out.kind == ValueKind::choice) out.choices = CLI::detail::split(type, '|');
  if (out.kind != ValueKind::none) out.standard = option.get_default_str();
  out.help = option.get_description();
  out.group = option.get_group();
  return out;
}

// Positionals, then groups as they first occur.
void sort_as_help(std::vector<Argument>& arguments) {
  std::vector<std::string> groups;
  for (const Argument& argument : arguments) groups.push_back(argument.group);
  std::ranges::stable_sort(arguments, {}, [&groups](const Argument& argument) {
    return argument.positional ? -1 : std::ranges::find(groups, argument.group) - groups.begin();
  });
}

Command command_of(const CLI::App& app, std::vector<std::string> path) {
  Command out;
  path.push_back(app.get_name());
  out.path = path;
  out.help = app.get_description();
  out.footer = app.get_footer();
  for (const CLI::Option* option : app.get_options({})) {
    if (!option->get_group().empty()) out.arguments.push_back(argument_of(*option));
  }
  sort_as_help(out.arguments);
  for (const CLI::App* command : app.get_subcommands({})) {
    out.commands.push_back(command_of(*command, path));
  }
  return out;
}

}  // namespace

std::string Command::name() const { return fmt::format("{}", fmt::join(path, " ")); }

Command command_tree(const CLI::App& app) { return command_of(app, {}); }

}  // namespace sailmap::app
