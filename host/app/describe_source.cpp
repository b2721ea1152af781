#include "describe_source.hpp"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <memory>
#include <utility>

#include "image_pipeline.hpp"
#include "progress.hpp"
#include "sailmap/error.hpp"
#include "sailmap/image_source.hpp"

namespace sailmap::app {
namespace {

// The image files of the chosen side.
std::vector<std::filesystem::path> chosen_images(const std::string& source, const DescribeOptions& options) {
  std::vector<std::filesystem::path> all = list_images(source);
  if (!options.oxford) return all;
  if (all.size() % 2 != 0) {
    throw Error(source + ": " + std::to_string(all.size()) +
                " images, an odd number, cannot be left and right interleaved");
  }
  std::vector<std::filesystem::path> chosen;
  for (std::size_t i = options.side == Side::left ? 0 : 1; i < all.size(); i += 2) chosen.push_back(all[i]);
  return chosen;
}

std::unique_ptr<ImageSource> open_chosen(const std::string& source, const DescribeOptions& options) {
  if (is_image_list(source)) return open_images(chosen_images(source, options));
  if (options.oxford) throw Error(source + ": an oxford layout is a folder, glob or list of images");
  return open_source(source);
}

int count_frames(ImageSource& source) {
  int count = 0;
  while (source.next()) ++count;
  return count;
}

void append(DescribedSource& out, const std::string& name, Signature signature) {
  if (!out.signatures.empty() && (signature.width != out.signatures.front().width ||
                                  signature.height != out.signatures.front().height)) {
    const Signature& first = out.signatures.front();
    throw Error(name + ": " + std::to_string(signature.width) + "x" + std::to_string(signature.height) +
                " pixels, but the images before are " + std::to_string(first.width) + "x" +
                std::to_string(first.height));
  }
  out.signatures.push_back(std::move(signature));
}

}  // namespace

SourceInfo inspect_source(const std::string& source, const DescribeOptions& options) {
  if (is_image_list(source)) return {static_cast<int>(chosen_images(source, options).size())};
  const auto opened = open_chosen(source, options);
  if (!std::filesystem::exists(source))
    throw Error(source + ": a camera cannot be evaluated, its images have no truth");
  // The frame count that a video's header claims is an estimate; only reading it through tells.
  return {count_frames(*opened)};
}

DescribedSource describe_source(const std::string& source, const DescribeOptions& options) {
  const auto images = open_chosen(source, options);
  const auto start = std::chrono::steady_clock::now();
  Progress progress("describe", images->size());
  DescribedSource out;
  ImagePipeline pipeline;
  pipeline.frontend = options.frontend;
  pipeline.regions = options.regions;
  pipeline.use = [&](const std::string& name, Signature signature) {
    append(out, name, std::move(signature));
    progress.step_to(static_cast<int>(out.signatures.size()));
    return true;
  };
  run_pipeline(*images, pipeline);
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  out.images_per_second = seconds > 0 ? static_cast<double>(out.signatures.size()) / seconds : 0;
  return out;
}

}  // namespace sailmap::app
