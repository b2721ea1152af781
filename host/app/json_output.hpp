// JSON on standard output, for scripts.
#pragma once

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

namespace sailmap::app {

// One line. Names of images are paths, and those may hold any bytes: what is not UTF-8 becomes U+FFFD.
void print_json(const nlohmann::ordered_json& json);

// The flag --json; `what` begins with a capital letter.
CLI::Option* add_json_flag(CLI::App& command, bool& json, const char* what = "As one line of JSON");

}  // namespace sailmap::app
