// sailmap perturb: copies of images, each changed in one way.
#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "commands.hpp"
#include "json_output.hpp"
#include "options.hpp"
#include "progress.hpp"
#include "sailmap/error.hpp"
#include "sailmap/figures.hpp"
#include "sailmap/file.hpp"
#include "sailmap/image_source.hpp"
#include "sailmap/perturbation.hpp"

namespace sailmap::app {
namespace {

namespace fs = std::filesystem;

struct Options {
  std::string source;
  fs::path out;
  std::string kind;
  double strength = 0;
  std::uint64_t seed = 1;
  bool json = false;
};

// PNG, which keeps every pixel as it is. The names stay, and so the natural order.
std::vector<fs::path> targets(const std::vector<fs::path>& images, const fs::path& folder) {
  std::vector<fs::path> out;
  std::set<fs::path> taken;
  for (const fs::path& image : images) {
    out.push_back(folder / image.stem().concat(".png"));
    if (!taken.insert(out.back()).second) throw Error(image.string() + ": another image has the same name");
    if (fs::exists(out.back())) throw Error(out.back().string() + ": exists already");
  }
  return out;
}

void perturb_all(const Options& options) {
  const PerturbationKind kind = perturbation_from_name(options.kind);
  const std::vector<fs::path> images = list_images(options.source);
  const std::vector<fs::path> results = targets(images, options.out);
  make_folder(options.out);
  Progress progress("perturb", static_cast<int>(images.size()));
  for (std::size_t i = 0; i < images.size(); ++i) {
    write_image(results[i], perturb(read_image(images[i]), kind, options.strength, options.seed + i));
    progress.step_to(static_cast<int>(i) + 1);
  }
  progress.clear();
  if (options.json) {
    print_json({{"source", options.source},
                {"out", options.out.string()},
                {"images", images.size()},
                {"kind", options.kind},
                {"strength", options.strength},
                {"seed", options.seed}});
    return;
  }
  fmt::print("{}: {} images, {} {:g}\n", options.out.string(), images.size(), options.kind, options.strength);
}

std::string strengths() {
  std::string text = "How strong:";
  for (const std::string_view kind : perturbation_names()) {
    text += fmt::format("\n{}: {}", kind, strength_of(perturbation_from_name(kind)));
  }
  return text;
}

}  // namespace

void add_perturb(CLI::App& app) {
  const auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("perturb", "Copy images, each changed in one way");
  command
      ->add_option("SOURCE", options->source, "Folder of images, glob in quotes, list file (.txt) or image")
      ->required();
  command->add_option("--out", options->out, "Folder for the copies, PNG")->required()->type_name("DIR");
  one_of(command->add_option("--kind", options->kind, "What happens to them"),
         to_strings(perturbation_names()))
      ->required();
  command->add_option("--strength", options->strength, strengths())->required()->type_name("X");
  command->add_option("--seed", options->seed, "Decides noise and where the occlusion is")
      ->capture_default_str();
  add_json_flag(*command, options->json);
  command->callback([options] { perturb_all(*options); });
}

}  // namespace sailmap::app
