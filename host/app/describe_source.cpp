#include "describe_source.hpp"

#include <tbb/parallel_pipeline.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>
#include <thread>
#include <utility>

#include "describe_image.hpp"
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

struct Described {
  std::string name;
  Signature signature;
};

void append(DescribedSource& out, Described described) {
  if (!out.signatures.empty() && (described.signature.width != out.signatures.front().width ||
                                  described.signature.height != out.signatures.front().height)) {
    const Signature& first = out.signatures.front();
    throw Error(described.name + ": " + std::to_string(described.signature.width) + "x" +
                std::to_string(described.signature.height) + " pixels, but the images before are " +
                std::to_string(first.width) + "x" + std::to_string(first.height));
  }
  out.signatures.push_back(std::move(described.signature));
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
  const std::size_t in_flight = std::size_t{2} * std::max(1U, std::thread::hardware_concurrency());
  tbb::parallel_pipeline(
      in_flight,
      tbb::make_filter<void, std::shared_ptr<Frame>>(tbb::filter_mode::serial_in_order,
                                                     [&](tbb::flow_control& flow) -> std::shared_ptr<Frame> {
                                                       std::optional<Frame> frame = images->next();
                                                       if (frame)
                                                         return std::make_shared<Frame>(std::move(*frame));
                                                       flow.stop();
                                                       return nullptr;
                                                     }) &
          tbb::make_filter<std::shared_ptr<Frame>, std::shared_ptr<Described>>(
              tbb::filter_mode::parallel,
              [&](const std::shared_ptr<Frame>& frame) {
                thread_local std::unique_ptr<Frontend> frontend;
                if (!frontend || frontend->name() != options.frontend)
                  frontend = make_frontend(options.frontend);
                DescribedImage d = describe_image(frame->name, frame->image, *frontend, options.regions);
                return std::make_shared<Described>(Described{frame->name, std::move(d.signature)});
              }) &
          tbb::make_filter<std::shared_ptr<Described>, void>(
              tbb::filter_mode::serial_in_order, [&](const std::shared_ptr<Described>& described) {
                append(out, std::move(*described));
                progress.step_to(static_cast<int>(out.signatures.size()));
              }));
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  out.images_per_second = seconds > 0 ? static_cast<double>(out.signatures.size()) / seconds : 0;
  return out;
}

}  // namespace sailmap::app
