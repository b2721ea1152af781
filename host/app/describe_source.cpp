#include "describe_source.hpp"

#include <tbb/parallel_for.h>

#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>
#include <utility>

#include "image_pipeline.hpp"
#include "progress.hpp"
#include "sailmap/error.hpp"
#include "sailmap/frontend.hpp"
#include "sailmap/image_source.hpp"

namespace sailmap::app {
namespace {

std::unique_ptr<ImageSource> open_selected(const std::string& source, const Selection& selection) {
  if (is_image_list(source)) return open_images(selected_images(source, selection));
  if (selection.oxford) throw Error(source + ": an oxford layout is a folder, glob or list of images");
  return open_source(source);
}

int count_frames(ImageSource& source) {
  int count = 0;
  while (source.next()) ++count;
  return count;
}

void append(std::vector<Signature>& images, const std::string& name, Signature signature) {
  if (!images.empty() &&
      (signature.width != images.front().width || signature.height != images.front().height)) {
    const Signature& first = images.front();
    throw Error(name + ": " + std::to_string(signature.width) + "x" + std::to_string(signature.height) +
                " pixels, but the images before are " + std::to_string(first.width) + "x" +
                std::to_string(first.height));
  }
  images.push_back(std::move(signature));
}

// How many images a second, from its making until it is asked.
class Rate {
 public:
  [[nodiscard]] double of(std::size_t images) const {
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    return seconds > 0 ? static_cast<double>(images) / seconds : 0;
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

// At most so many images, fewer at the end of the source.
std::vector<PendingFrame> next_batch(ImageSource& source, std::size_t most) {
  std::vector<PendingFrame> batch;
  while (batch.size() < most) {
    std::optional<PendingFrame> frame = source.next_pending();
    if (!frame) break;
    batch.push_back(std::move(*frame));
  }
  return batch;
}

}  // namespace

std::vector<std::filesystem::path> selected_images(const std::string& source, const Selection& selection) {
  std::vector<std::filesystem::path> all = list_images(source);
  if (!selection.oxford) return all;
  if (all.size() % 2 != 0) {
    throw Error(source + ": " + std::to_string(all.size()) +
                " images, an odd number, cannot be left and right interleaved");
  }
  std::vector<std::filesystem::path> selected;
  for (std::size_t i = selection.side == Side::left ? 0 : 1; i < all.size(); i += 2) {
    selected.push_back(all[i]);
  }
  return selected;
}

int count_images(const std::string& source, const Selection& selection) {
  if (is_image_list(source)) return static_cast<int>(selected_images(source, selection).size());
  const auto opened = open_selected(source, selection);
  if (!std::filesystem::exists(source))
    throw Error(source + ": a camera cannot be evaluated, its images have no truth");
  // The frame count that a video's header claims is an estimate; only reading it through tells.
  return count_frames(*opened);
}

Described<Signature> describe_source(const std::string& source, const Selection& selection,
                                     const std::string& frontend, const RegionConfig& regions) {
  check_signature(frontend, regions);
  const auto images = open_selected(source, selection);
  const Rate rate;
  Progress progress("describe", images->size());
  Described<Signature> out;
  ImagePipeline pipeline;
  pipeline.frontend = frontend;
  pipeline.regions = regions;
  pipeline.use = [&](PipelineImage image) {
    append(out.images, image.name, std::move(image.signature));
    progress.step_to(static_cast<int>(out.images.size()));
    return true;
  };
  run_pipeline(*images, pipeline);
  out.images_per_second = rate.of(out.images.size());
  return out;
}

Described<fabmap::Histogram> find_words(const std::string& source, const Selection& selection,
                                        const fabmap::Vocabulary& vocabulary) {
  constexpr std::size_t at_once = 64;
  const auto images = open_selected(source, selection);
  const Rate rate;
  Progress progress("find words", images->size());
  Described<fabmap::Histogram> out;
  for (auto batch = next_batch(*images, at_once); !batch.empty(); batch = next_batch(*images, at_once)) {
    const std::size_t before = out.images.size();
    out.images.resize(before + batch.size());
    tbb::parallel_for(std::size_t{0}, batch.size(), [&](std::size_t i) {
      out.images[before + i] = fabmap::histogram_of(batch[i].read(), vocabulary);
    });
    progress.step_to(static_cast<int>(out.images.size()));
  }
  out.images_per_second = rate.of(out.images.size());
  return out;
}

}  // namespace sailmap::app
