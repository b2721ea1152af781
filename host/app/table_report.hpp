// The table for people and for programs.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "eval_table.hpp"

namespace sailmap::app {

// Aligned text; what was skipped, and why, beneath.
std::string to_text(const Table& table);

std::string to_markdown(const Table& table);

// One line a data set and method, with a header; numbers in full.
std::string to_csv(const Table& table);

// Of each cell all that `eval --json` says.
nlohmann::ordered_json to_json(const Table& table);

// As the paper's Fig. 8: recall above, precision beneath (SVG).
void write_table_plot(const std::filesystem::path& path, const Table& table);

}  // namespace sailmap::app
