// sailmap match: are two images the same place, and why.
#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "commands.hpp"
#include "describe_image.hpp"
#include "map/config_json.hpp"
#include "options.hpp"
#include "sailmap/context.hpp"
#include "sailmap/detection.hpp"
#include "sailmap/figures.hpp"
#include "sailmap/similarity.hpp"

namespace sailmap::app {
namespace {

struct Options {
  std::string query;
  std::string candidate;
  std::string out;
  std::string frontend;
  bool json = false;
  MapConfig config;
};

std::string explain(const Detection& detection, const MatchResult& result, const Options& options,
                    const Signature& a, const Signature& b) {
  const DetectionConfig& d = options.config.detection;
  const std::string facts = fmt::format("similarity {:.3f} ({}), {} of {} and {} regions matched",
                                        result.similarity, name(options.config.match.method),
                                        result.matches.size(), a.regions.size(), b.regions.size());
  switch (detection.reason) {
    case Reason::accepted:
      return fmt::format("same place: {}, above the threshold of {:g}", facts, d.threshold);
    case Reason::no_regions:
      return "not the same place: an image has no salient region (it is flat)";
    case Reason::too_few_regions:
      return fmt::format("not the same place: {}, fewer than the {} demanded", facts, d.min_matches);
    default:
      return fmt::format("not the same place: {}, not above the threshold of {:g}", facts, d.threshold);
  }
}

void match_images(const Options& options) {
  const auto frontend = make_frontend(options.frontend);
  const DescribedImage a = describe_image(options.query, *frontend, options.config.regions);
  const DescribedImage b = describe_image(options.candidate, *frontend, options.config.regions);
  const bool context = options.config.match.method == Method::context;
  const Signature query = context ? with_context_regions(a.signature) : a.signature;
  const Signature candidate = context ? with_context_regions(b.signature) : b.signature;
  const MatchResult result = match(a.signature, b.signature, options.config.match);
  Detection detection =
      decide({{0, result.similarity}}, options.config.detection, [&](int) { return result.matches; });
  if (a.signature.regions.empty() || b.signature.regions.empty()) detection.reason = Reason::no_regions;
  const std::string verdict = explain(detection, result, options, query, candidate);
  if (!options.out.empty()) {
    write_image(options.out, match_figure(a.image, b.image, query, candidate, result,
                                          options.config.regions.box_side, verdict));
  }
  if (options.json) {
    const nlohmann::ordered_json json = {{"query", options.query},
                                         {"candidate", options.candidate},
                                         {"same_place", detection.accepted()},
                                         {"similarity", result.similarity},
                                         {"threshold", options.config.detection.threshold},
                                         {"reason", name(detection.reason)},
                                         {"matches", to_json(detection).at("matches")}};
    fmt::print("{}\n", json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
  } else {
    fmt::print("{}\n", verdict);
  }
}

}  // namespace

void add_match(CLI::App& app) {
  const auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("match", "Tell whether two images show the same place");
  command->add_option("A", options->query, "The first image (the query)")->required();
  command->add_option("B", options->candidate, "The second image, of the same size")->required();
  command->add_option("--out", options->out, "Figure: both images side by side, matched regions joined")
      ->type_name("FILE");
  command->add_flag("--json", options->json, "Print the result as one line of JSON");
  add_frontend_option(*command, options->frontend);
  add_region_options(*command, options->config.regions);
  add_match_options(*command, options->config.match);
  add_detection_options(*command, options->config.detection);
  command->callback([options, command] {
    settle_thresholds(*command, options->config);
    check_signature(options->frontend, options->config.regions);
    match_images(*options);
  });
}

}  // namespace sailmap::app
