// sailmap map diff: what two maps disagree about. Exit codes as of diff(1): 0 nothing, 1 something, 2
// trouble.
#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "commands.hpp"
#include "json_output.hpp"
#include "load_map.hpp"
#include "map_comparison.hpp"
#include "sailmap/error.hpp"

namespace sailmap::app {
namespace {

using nlohmann::ordered_json;

constexpr int exit_differ = 1;
constexpr int exit_trouble = 2;

struct Options {
  std::string a;
  std::string b;
  double tolerance = 0;
  bool json = false;
};

std::string text_of(const EdgeOfImages& edge) {
  return fmt::format("{} edge from {} to {}", name(edge.kind), text_of(edge.from), text_of(edge.to));
}

ordered_json json_of(const ImageKey& key) { return {{"name", key.name}, {"occurrence", key.occurrence}}; }

ordered_json json_of(const EdgeOfImages& edge) {
  return {{"from", json_of(edge.from)}, {"to", json_of(edge.to)}, {"kind", name(edge.kind)}};
}

ordered_json json_of(const DetectionOfImage& d) {
  return {{"reason", name(d.reason)},
          {"node", d.node ? json_of(*d.node) : ordered_json()},
          {"similarity", d.node ? ordered_json(d.similarity) : ordered_json()}};
}

template <class T>
ordered_json list_of(const std::vector<T>& items) {
  ordered_json out = ordered_json::array();
  for (const T& item : items) out.push_back(json_of(item));
  return out;
}

template <class T>
ordered_json json_of(const OnlyIn<T>& only) {
  return {{"only_in_a", list_of(only.a)}, {"only_in_b", list_of(only.b)}};
}

ordered_json json_of(const MapComparison& c, const Options& options) {
  ordered_json parameters = ordered_json::array();
  for (const ParameterChange& p : c.parameters) {
    parameters.push_back({{"parameter", p.name}, {"a", p.a}, {"b", p.b}});
  }
  ordered_json detections = ordered_json::array();
  for (const DetectionChange& d : c.detections) {
    detections.push_back({{"image", json_of(d.image)}, {"a", json_of(d.a)}, {"b", json_of(d.b)}});
  }
  return {{"a", options.a},
          {"b", options.b},
          {"tolerance", options.tolerance},
          {"equal", c.equal()},
          {"parameters", parameters},
          {"images", json_of(c.images)},
          {"regions", list_of(c.regions)},
          {"nodes", json_of(c.nodes)},
          {"edges", json_of(c.edges)},
          {"detections", detections}};
}

template <class T, class Text>
void print_only(const OnlyIn<T>& only, const char* what, Text text) {
  for (const T& item : only.a) fmt::print("- {}{}\n", what, text(item));
  for (const T& item : only.b) fmt::print("+ {}{}\n", what, text(item));
}

std::string text_of(const DetectionOfImage& d) {
  if (!d.node) return std::string(name(d.reason));
  return fmt::format("{} at {}, similarity {}", name(d.reason), text_of(*d.node), d.similarity);
}

// As in a patch: - is said of the first map, + of the second, ! of both.
void print(const MapComparison& c, const Options& options) {
  if (c.equal()) return;
  fmt::print("- {}\n+ {}\n", options.a, options.b);
  for (const ParameterChange& p : c.parameters) {
    fmt::print("- {} {}\n+ {} {}\n", p.name, p.a.dump(), p.name, p.b.dump());
  }
  const auto key_text = [](const ImageKey& key) { return text_of(key); };
  print_only(c.images, "image ", key_text);
  for (const ImageKey& image : c.regions) fmt::print("! regions of {}\n", text_of(image));
  print_only(c.nodes, "node of ", key_text);
  print_only(c.edges, "", [](const EdgeOfImages& edge) { return text_of(edge); });
  for (const DetectionChange& d : c.detections) {
    fmt::print("- {}: {}\n+ {}: {}\n", text_of(d.image), text_of(d.a), text_of(d.image), text_of(d.b));
  }
}

bool differ(const Options& options) {
  const MapComparison c = compare(load_map(options.a), load_map(options.b), options.tolerance);
  if (options.json) {
    print_json(json_of(c, options));
  } else {
    print(c, options);
  }
  return !c.equal();
}

}  // namespace

void add_map_diff(CLI::App& map) {
  const auto options = std::make_shared<Options>();
  CLI::App* command =
      map.add_subcommand("diff",
                         "What two maps disagree about: parameters, images, their regions, nodes, edges, "
                         "verdicts, similarities. Images are the "
                         "same when their names are; exit codes: 0 nothing, 1 something, 2 trouble");
  command->add_option("A", options->a, "The first map: lines with -")->required();
  command->add_option("B", options->b, "The second map: lines with +")->required();
  command
      ->add_option("--tolerance", options->tolerance,
                   "Similarities that differ by no more than this part of the larger are the same")
      ->check(CLI::Range(0.0, 1.0).description(""))
      ->capture_default_str();
  add_json_flag(*command, options->json);
  command->callback([options] {
    try {
      if (differ(*options)) throw Exit{exit_differ};
    } catch (const Error& fault) {
      spdlog::error("{}", fault.what());
      throw Exit{exit_trouble};
    }
  });
}

}  // namespace sailmap::app
