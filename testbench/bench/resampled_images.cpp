#include "resampled_images.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <utility>

#include "sailmap/frontend.hpp"
#include "sailmap/image_source.hpp"
#include "sailmap_data.hpp"

namespace sailmap::bench {
namespace {

std::filesystem::path folder() { return testing::data_folder() / "gardens_point" / "images"; }

constexpr std::size_t way_length = 200;  // images; the sequence goes along it twice
constexpr std::size_t first_query = 150;

std::int16_t on_grid(double position, int side) {
  return static_cast<std::int16_t>(4 * std::clamp(static_cast<int>(position / 4), 0, side / 4 - 1));
}

}  // namespace

bool ResampledImages::available() { return std::filesystem::exists(folder()); }

ResampledImages::ResampledImages() {
  const auto frontend = make_frontend("fixed");
  const auto paths = list_images(folder().string());
  sailmap::Maps maps;
  for (std::size_t i = 0; i < paths.size(); i += 5) {
    frontend->compute(view_of(read_image(paths[i])), maps);
    (i % way_length < first_query ? images_ : queries_).push_back(make_signature(maps, {}));
  }
}

Region ResampledImages::moved(Region region, const Signature& image, double dx, double dy) {
  std::normal_distribution<double> normal;
  region.x = on_grid(region.x + dx + 8 * normal(random_), image.width);
  region.y = on_grid(region.y + dy + 8 * normal(random_), image.height);
  Descriptor v{};
  std::array<float, conspicuity_count> sums{};
  for (std::size_t i = 0; i < feature_count; ++i) {
    const double noise = std::exp(0.15 * normal(random_));
    v[i] = static_cast<float>(std::max(region.descriptor[i], 1e-4F) * noise);
    sums[kind_of_feature[i]] += v[i];
  }
  for (std::size_t i = 0; i < feature_count; ++i) region.descriptor[i] = v[i] / sums[kind_of_feature[i]];
  return region;
}

Signature ResampledImages::next() {
  const Signature& image = any();
  const Signature& other = any();
  std::normal_distribution<double> normal;
  const double dx = 40 * normal(random_);
  const double dy = 20 * normal(random_);
  const bool mirrored = std::bernoulli_distribution(0.5)(random_);
  Signature out{image.width, image.height, {}};
  for (std::size_t i = 0; i < image.regions.size(); ++i) {
    const bool foreign = i < other.regions.size() && std::bernoulli_distribution(0.25)(random_);
    Region region = foreign ? other.regions[i] : image.regions[i];
    if (mirrored) {
      region.x = static_cast<std::int16_t>(image.width - 1 - region.x);
      std::swap(region.descriptor[7], region.descriptor[9]);  // 45 and 135 degrees
    }
    out.regions.push_back(moved(region, image, dx, dy));
  }
  return out;
}

}  // namespace sailmap::bench
