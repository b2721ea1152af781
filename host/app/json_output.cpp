#include "json_output.hpp"

#include <fmt/format.h>

#include "run_report.hpp"

namespace sailmap::app {

using nlohmann::ordered_json;

void print_json(const ordered_json& json) { fmt::print("{}\n", dump(json)); }

CLI::Option* add_json_flag(CLI::App& command, bool& json, const char* what) {
  return command.add_flag("--json", json, what);
}

}  // namespace sailmap::app
