// Quantised against exact on images: what docs/accuracy.md reports and the tests assert.
#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "sailmap/ref/plane.hpp"

namespace sailmap::numbers {

// The ten feature maps, three conspicuities, saliency.
inline constexpr std::size_t map_count = 14;
std::string_view map_name(std::size_t map);
// One unit of the map's raw integers, in the spec's units.
double map_lsb(std::size_t map);

struct MapErrors {
  double maximum = 0;        // of the exact map
  double largest_error = 0;  // |quantised - exact|, spec units
  double mean_square = 0;
};

struct ImageErrors {
  std::array<MapErrors, map_count> maps;
  // Maps (features and conspicuities) whose m differs.
  std::array<bool, map_count> other_m{};
  int saturated = 0;    // samples at the top of their format, over all maps
  int regions = 0;      // of the exact saliency's five most salient ...
  int same_region = 0;  // ... those also among the quantised five, at the same base-level pixel
  int near_region = 0;  // ... within a pixel in x and y
  [[nodiscard]] bool same_m() const;
};

// What the exact reference is compared with: the quantised one, or itself on the image with -1, 0 or +1 added
// to every byte at random, which says what one grey level of camera noise does.
enum class Against { quantised, noisy };

ImageErrors measure(const ImageView& image, Against against = Against::quantised);

// Over a sequence.
struct Summary {
  struct Map {
    double largest_error = 0;
    double largest_share = 0;         // of the map's own maximum, over all images
    double largest_share_same_m = 0;  // over the images whose m all agree
    double smallest_maximum = 0;      // of the exact map
    double root_mean_square = 0;      // share of the maximum
    int other_m = 0;                  // images
  };
  std::array<Map, map_count> maps{};
  int images = 0;
  int images_other_m = 0;
  int images_saliency_beyond = 0;  // saliency off by more than its share
  int saturated = 0;
  int regions = 0;
  int same_region = 0;
  int near_region = 0;
  [[nodiscard]] double agreement() const { return static_cast<double>(same_region) / regions; }
};

Summary summarise(const std::vector<ImageErrors>& images);

// Every `step`-th file of a folder of images, in parallel. Throws Error naming a file that is no image.
std::vector<ImageErrors> measure_folder(const std::filesystem::path& folder, int step,
                                        Against against = Against::quantised);

}  // namespace sailmap::numbers
