#include "json_output.hpp"

#include <fmt/format.h>

namespace sailmap::app {

using nlohmann::ordered_json;

void print_json(const ordered_json& json) {
  fmt::print("{}\n", json.dump(-1, ' ', false, ordered_json::error_handler_t::replace));
}

CLI::Option* add_json_flag(CLI::App& command, bool& json, const char* what) {
  return command.add_flag("--json", json, what);
}

}  // namespace sailmap::app
