// The C simulation of the kernels as a front end: what the hardware says, bit for bit.
#include <array>
#include <cstdint>
#include <vector>

#include "fixed_maps.hpp"
#include "frontends.hpp"
#include "sailmap/csim/signature.hpp"
#include "sailmap/csim/simulate.hpp"
#include "signature_record.hpp"

namespace sailmap {
namespace {

csim::Frame frame_of(const ImageView& image) {
  csim::Frame frame{image.width, image.height, {}};
  frame.rgb.reserve(3 * static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height));
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const auto [r, g, b] = image.at(x, y);
      for (const int component : {r, g, b}) frame.rgb.push_back(static_cast<std::uint8_t>(component));
    }
  }
  return frame;
}

// Lane `index` of packed maps, 16 bits each.
template <class F, class Word>
void store_lane(const std::vector<Word>& words, std::size_t index, int width, int height, Map& map) {
  const auto to = raw_samples<F>(map, width, height).samples();
  for (std::size_t i = 0; i < to.size(); ++i) {
    to[i] = static_cast<typename F::native>(words[i] >> (16 * index));
  }
}

// Of the ten feature maps, then the three conspicuity maps.
template <class F>
MapStatistics statistics_at(const csim::FrontEndWords& words, std::size_t map) {
  return statistics_of_raw<F>(words.statistics[2 * map], words.statistics[2 * map + 1]);
}

void store_features(const csim::FrontEndWords& words, int width, int height, Maps& maps) {
  using namespace hls::geometry;
  for_each_feature_format([&]<class F>(F, std::size_t i) {
    if (i < intensity_maps) {
      store_lane<F>(words.intensity_maps, i, width, height, maps.features[i]);
    } else if (i < intensity_maps + colour_maps) {
      store_lane<F>(words.colour_maps, i - intensity_maps, width, height, maps.features[i]);
    } else {
      store_lane<F>(words.orientation_maps, i - intensity_maps - colour_maps, width, height,
                    maps.features[i]);
    }
    maps.feature_statistics[i] = statistics_at<F>(words, i);
  });
}

class Csim : public Frontend {
 public:
  [[nodiscard]] std::string_view name() const override { return "csim"; }

  void compute(const ImageView& image, Maps& maps) override { simulate(image, maps); }

  void describe(const ImageView& image, const RegionConfig& regions, Maps& maps,
                Signature& signature) override {
    const csim::FrontEndWords words = simulate(image, maps);
    if (regions.signature == SignatureMaker::host) {
      signature = make_signature(maps, regions);
      return;
    }
    const ChipParameters asked = chip_parameters(regions);
    csim::Scheduler scheduler;
    const std::vector<std::uint32_t> record = csim::simulate_signature(
        words, image.width, image.height, {asked.max_regions, asked.stop_ratio, asked.box_side}, scheduler);
    signature = signature_of_record(record, image.width, image.height);
  }

 private:
  // Fills the maps; returns what they were made of.
  static csim::FrontEndWords simulate(const ImageView& image, Maps& maps) {
    check_image_size(image);
    const std::array<csim::Frame, 1> frames = {frame_of(image)};
    csim::Scheduler scheduler;
    csim::FrontEndWords words = csim::simulate(frames, csim::widest_beat(image.width), scheduler).front();
    const int width = hls::geometry::base_side(image.width);
    const int height = hls::geometry::base_side(image.height);
    maps.image_width = image.width;
    maps.image_height = image.height;
    store_features(words, width, height, maps);
    for_each_conspicuity_format([&]<class F>(F, std::size_t i) {
      store_lane<F>(words.conspicuity_maps, i, width, height, maps.conspicuities[i]);
      maps.conspicuity_statistics[i] = statistics_at<F>(words, feature_count + i);
    });
    store_lane<hls::formats::saliency>(words.saliency, 0, width, height, maps.saliency);
    return words;
  }
};

}  // namespace

std::unique_ptr<Frontend> make_csim() { return std::make_unique<Csim>(); }

}  // namespace sailmap
