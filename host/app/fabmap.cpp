// sailmap fabmap train: the visual words that the methods `fabmap` and `bow` of `eval` need.
#include "sailmap/fabmap.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "commands.hpp"
#include "json_output.hpp"
#include "sailmap/error.hpp"
#include "sailmap/image_source.hpp"

namespace sailmap::app {
namespace {

struct Options {
  std::string source;
  std::filesystem::path out;
  int every = 1;
  bool json = false;
  fabmap::TrainingConfig config;
};

std::vector<std::filesystem::path> chosen_images(const Options& options) {
  const std::vector<std::filesystem::path> all = list_images(options.source);
  std::vector<std::filesystem::path> chosen;
  for (std::size_t i = 0; i < all.size(); i += static_cast<std::size_t>(options.every)) {
    chosen.push_back(all[i]);
  }
  return chosen;
}

void train(const Options& options) {
  const std::vector<std::filesystem::path> images = chosen_images(options);
  fabmap::Vocabulary vocabulary;
  try {
    vocabulary = fabmap::train(
        images.size(), [&images](std::size_t i) { return read_image(images[i]); }, options.config);
  } catch (const Error& fault) {
    throw Error(options.source + ": " + fault.what());
  }
  fabmap::write_vocabulary(options.out, vocabulary);
  std::size_t words = 0;
  for (const fabmap::Words& image : vocabulary.training) words += image.size();
  const double words_per_image = static_cast<double>(words) / static_cast<double>(images.size());
  if (options.json) {
    print_json({{"source", options.source},
                {"out", options.out.string()},
                {"words", vocabulary.tree.size()},
                {"images", images.size()},
                {"words_per_image", words_per_image}});
    return;
  }
  fmt::print("{}: {} words from {} images, {:.1f} words an image\n", options.out.string(),
             vocabulary.tree.size(), images.size(), words_per_image);
}

void add_train(CLI::App& fabmap) {
  const auto options = std::make_shared<Options>();
  CLI::App* command = fabmap.add_subcommand(
      "train", "Learn words and their dependence from images of places that are not to be recognised");
  command->add_option("FOLDER", options->source, "Folder of images, glob in quotes, or list file (.txt)")
      ->required();
  command->add_option("--out", options->out, "The vocabulary file")->required()->type_name("FILE");
  const auto count = [&](const char* flag, int& value, const char* help, int least) {
    command->add_option(flag, value, help)
        ->check(CLI::Range(least, 1000000).description(""))
        ->capture_default_str();
  };
  count("--words", options->config.words, "Words of the vocabulary", 2);
  count("--features", options->config.features, "SIFT keypoints an image, at most", 1);
  count("--sample", options->config.sample, "Descriptors that are clustered, at most", 2);
  count("--iterations", options->config.iterations, "Rounds of k-means, at most", 1);
  count("--every", options->every, "Take every so many-th image", 1);
  command->add_option("--seed", options->config.seed, "The same seed gives the same words")
      ->capture_default_str();
  add_json_flag(*command, options->json);
  command->callback([options] { train(*options); });
}

}  // namespace

void add_fabmap(CLI::App& app) {
  CLI::App* command =
      app.add_subcommand("fabmap", "FAB-MAP, the paper's comparison, and bow: learn their vocabulary");
  command->require_subcommand(1);
  add_train(*command);
}

}  // namespace sailmap::app
