// Options that several subcommands share. Defaults in the help come from the configuration structs
// themselves.
#pragma once

#include <CLI/CLI.hpp>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "experiment.hpp"
#include "sailmap/topological_map.hpp"

namespace sailmap::app {

// Options by the JSON pointer of the configuration value they set ("/match/method").
using OptionKeys = std::map<std::string, CLI::Option*>;

// The option takes one of these names and shows them as what it takes; completion and man pages read them
// there.
CLI::Option* one_of(CLI::Option* option, const std::vector<std::string>& names);
std::vector<std::string> to_strings(const std::vector<std::string_view>& names);
// --frontend, and what the front end xrt needs.
void add_frontend_option(CLI::App& command, std::string& frontend);
OptionKeys add_region_options(CLI::App& command, RegionConfig& config);
// --method and the constraints.
OptionKeys add_match_options(CLI::App& command, MatchConfig& config);
// The paper's two geometric constraints.
OptionKeys add_constraint_options(CLI::App& command, MatchConfig& config);
// --method, with fabmap among them, and --vocabulary.
std::vector<CLI::Option*> add_recogniser_options(CLI::App& command, Recogniser& recogniser);
// `more`: defaults to be named beside those of the methods on signatures.
CLI::Option* add_threshold_option(CLI::App& command, double& threshold, const std::string& more = "");
// Thresholds that the command line did not set become those of the method, and its descriptors are asked for.
// To be called when all is parsed.
void settle_thresholds(const CLI::App& command, MapConfig& config);
// --temporal, for every method.
CLI::Option* add_temporal_option(CLI::App& command, int& images);
// --threshold and what else decides a detection.
OptionKeys add_detection_options(CLI::App& command, DetectionConfig& config);
// All of the above and those of the map itself.
OptionKeys add_map_options(CLI::App& command, MapConfig& config);

}  // namespace sailmap::app
