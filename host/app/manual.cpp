// sailmap manual: man pages, one of the program and one a subcommand.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "command_tree.hpp"
#include "commands.hpp"
#include "json_output.hpp"
#include "roff.hpp"
#include "sailmap/error.hpp"
#include "sailmap/file.hpp"

namespace sailmap::app {
namespace {

std::string page_name(const std::vector<std::string>& path) {
  return fmt::format("{}", fmt::join(path, "-"));
}

// "the value" as in the help: FILE, or the choices.
std::string term_of(const Argument& argument) {
  std::string term;
  for (const std::string& name : argument.names) {
    term += (term.empty() ? "" : ", ") + (argument.positional ? roff_italic(name) : roff_bold(name));
  }
  if (argument.kind == ValueKind::choice) {
    std::string choices;
    for (const std::string& choice : argument.choices) {
      choices += (choices.empty() ? "" : "|") + roff_bold(choice);
    }
    return argument.positional ? term + ": " + choices : term + " " + choices;
  }
  // A positional has its name for that.
  if (!argument.value.empty() && !argument.positional) term += " " + roff_italic(argument.value);
  return argument.repeated ? term + " ..." : term;
}

std::string text_of(const Argument& argument) {
  std::string text = roff_text(argument.help);
  if (!argument.help.empty() && argument.help.back() != '.') text += ".";
  if (argument.required && !argument.positional) text += " Required.";
  if (!argument.standard.empty()) text += " Default: " + roff_bold(argument.standard) + ".";
  return text;
}

std::string upper(std::string text) {
  for (char& c : text) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return text;
}

std::string arguments_of(const Command& command, const std::string& heading) {
  std::string out;
  std::string group;
  for (const Argument& argument : command.arguments) {
    const std::string title = argument.positional ? "Arguments" : argument.group;
    if (title != group) {
      // Sections are written in capitals, their parts are not.
      out += fmt::format("{} \"{}\"\n", heading, roff_text(heading == ".SH" ? upper(title) : title));
    }
    group = title;
    out += fmt::format(".TP\n{}\n{}\n", term_of(argument), text_of(argument));
  }
  return out;
}

std::string synopsis_of(const Command& command) {
  std::string out = roff_bold(command.name()) + " [" + roff_italic("OPTIONS") + "]";
  for (const Argument& argument : command.arguments) {
    if (!argument.positional) break;
    const std::string name = roff_italic(argument.names.front()) + (argument.repeated ? " ..." : "");
    out += argument.required ? " " + name : " [" + name + "]";
  }
  return command.commands.empty() ? out : out + " " + roff_italic("SUBCOMMAND");
}

std::string sentence(const std::string& text) { return roff_text(text) + (text.ends_with('.') ? "" : "."); }

// What the name section says: one line, without a capital or a full stop.
std::string phrase(std::string text) {
  if (text.size() > 1 && std::islower(static_cast<unsigned char>(text[1])) != 0) {
    text.front() = static_cast<char>(std::tolower(static_cast<unsigned char>(text.front())));
  }
  if (text.ends_with('.')) text.pop_back();
  return roff_text(text);
}

std::string head_of(const Command& command) {
  std::string out =
      fmt::format(".\\\" Made by `sailmap manual`.\n.TH \"{}\" 1 \"\" \"sailmap {}\" \"sailmap\"\n",
                  upper(page_name(command.path)), SAILMAP_VERSION);
  out += fmt::format(".SH NAME\n{} \\- {}\n", roff_text(page_name(command.path)), phrase(command.help));
  out += ".SH SYNOPSIS\n";
  std::string separator;
  const auto add = [&](const Command& c) {
    out += separator + synopsis_of(c) + "\n";
    separator = ".br\n";
  };
  if (command.commands.empty() || command.path.size() == 1) add(command);
  if (command.path.size() > 1) {
    for (const Command& child : command.commands) add(child);
  }
  return out + ".SH DESCRIPTION\n" + sentence(command.help) + "\n";
}

std::string notes_of(const Command& root) { return ".SH NOTES\n" + roff_lines(root.footer); }

std::string see_also(const Command& root, const Command& page) {
  std::vector<std::string> pages;
  if (page.path.size() > 1) pages.push_back(roff_bold(page_name(root.path)) + "(1)");
  for (const Command& command : root.commands) {
    if (command.path != page.path) pages.push_back(roff_bold(page_name(command.path)) + "(1)");
  }
  return fmt::format(".SH \"SEE ALSO\"\n{}\n", fmt::join(pages, ",\n"));
}

std::string root_page(const Command& root) {
  std::string out = head_of(root) + ".SH COMMANDS\n";
  for (const Command& command : root.commands) {
    out += fmt::format(".TP\n{}(1)\n{}\n", roff_bold(page_name(command.path)), sentence(command.help));
  }
  return out + arguments_of(root, ".SH") + notes_of(root) + see_also(root, root);
}

std::string page_of(const Command& command, const Command& root) {
  std::string out = head_of(command) + arguments_of(command, ".SH");
  for (const Command& child : command.commands) {
    out += fmt::format(".SH \"{}\"\n{}\n", roff_text(child.name()), sentence(child.help));
    out += arguments_of(child, ".SS");
  }
  return out + notes_of(root) + see_also(root, command);
}

struct Options {
  std::filesystem::path out;
  bool json = false;
};

void write(const Command& root, const Options& options) {
  make_folder(options.out);
  nlohmann::ordered_json files = nlohmann::ordered_json::array();
  const auto write_page = [&](const Command& command, const std::string& page) {
    const std::filesystem::path path = options.out / (page_name(command.path) + ".1");
    write_file(path, [&page](std::ostream& out) { out << page; });
    files.push_back(path.string());
  };
  write_page(root, root_page(root));
  for (const Command& command : root.commands) write_page(command, page_of(command, root));
  if (options.json) {
    print_json({{"out", options.out.string()}, {"files", files}});
  } else {
    fmt::print("{}: {} pages\n", options.out.string(), files.size());
  }
}

}  // namespace

void add_manual(CLI::App& app) {
  const auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand(
      "manual", "Write the man pages, sailmap.1 and one a subcommand; installed with the program");
  command->add_option("--out", options->out, "Folder for them")->required()->type_name("DIR");
  add_json_flag(*command, options->json);
  command->callback([&app, options] { write(command_tree(app), *options); });
}

}  // namespace sailmap::app
