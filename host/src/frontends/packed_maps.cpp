#include "packed_maps.hpp"

namespace sailmap {
namespace {

// Lane `index` of packed maps, 16 bits each.
template <class F, class Word>
void store_lane(std::span<const Word> words, std::size_t index, int width, int height, Map& map) {
  const auto to = raw_samples<F>(map, width, height).samples();
  for (std::size_t i = 0; i < to.size(); ++i) {
    to[i] = static_cast<typename F::native>(words[i] >> (16 * index));
  }
}

// Of the ten feature maps, then the three conspicuity maps.
template <class F>
MapStatistics statistics_at(const PackedMaps& words, std::size_t map) {
  return statistics_of_raw<F>(words.statistics[2 * map], words.statistics[2 * map + 1]);
}

void store_features(const PackedMaps& words, int width, int height, Maps& maps) {
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

}  // namespace

void unpack(const PackedMaps& words, int image_width, int image_height, Maps& maps) {
  const int width = hls::geometry::base_side(image_width);
  const int height = hls::geometry::base_side(image_height);
  maps.image_width = image_width;
  maps.image_height = image_height;
  store_features(words, width, height, maps);
  for_each_conspicuity_format([&]<class F>(F, std::size_t i) {
    store_lane<F>(words.conspicuity_maps, i, width, height, maps.conspicuities[i]);
    maps.conspicuity_statistics[i] = statistics_at<F>(words, feature_count + i);
  });
  store_lane<hls::formats::saliency>(words.saliency, 0, width, height, maps.saliency);
}

}  // namespace sailmap
