#include "measure.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <opencv2/imgcodecs.hpp>
#include <random>

#include "sailmap/error.hpp"
#include "sailmap/frontend.hpp"
#include "sailmap/hls/accuracy.hpp"
#include "sailmap/signature.hpp"

namespace sailmap::numbers {
namespace {

namespace accuracy = hls::accuracy;

constexpr std::size_t first_conspicuity = feature_count;
constexpr std::size_t saliency = feature_count + conspicuity_count;

const Map& map_of(const Maps& maps, std::size_t map) {
  return map < first_conspicuity ? maps.features[map]
         : map < saliency        ? maps.conspicuities[map - first_conspicuity]
                                 : maps.saliency;
}

MapErrors compare(const Plane<double>& exact, const Plane<double>& quantised) {
  MapErrors out;
  const auto a = exact.samples();
  const auto b = quantised.samples();
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double error = std::abs(a[i] - b[i]);
    out.maximum = std::max(out.maximum, a[i]);
    out.largest_error = std::max(out.largest_error, error);
    out.mean_square += error * error / static_cast<double>(a.size());
  }
  return out;
}

// Samples at the largest raw value; none where the map is of real numbers.
int at_end_of_word(const Map& map) {
  const auto* raw = std::get_if<Plane<std::uint16_t>>(&map.samples);
  if (raw == nullptr) return 0;
  return static_cast<int>(std::ranges::count(raw->samples(), std::uint16_t{0xffff}));
}

std::vector<std::uint8_t> with_noise(const ImageView& image) {
  std::mt19937 random(1);
  std::vector<std::uint8_t> out;
  for (int y = 0; y < image.height; ++y) {
    const std::uint8_t* row = image.data + y * image.stride;
    for (int i = 0; i < 3 * image.width; ++i) {
      const int noisy = row[i] + static_cast<int>(random() % 3) - 1;
      out.push_back(static_cast<std::uint8_t>(std::clamp(noisy, 0, 255)));
    }
  }
  return out;
}

void compare_maxima(const Maps& exact, const Maps& quantised, ImageErrors& out) {
  for (std::size_t i = 0; i < feature_count; ++i) {
    out.other_m[i] = exact.feature_statistics[i].maxima != quantised.feature_statistics[i].maxima;
  }
  for (std::size_t i = 0; i < conspicuity_count; ++i) {
    out.other_m[first_conspicuity + i] =
        exact.conspicuity_statistics[i].maxima != quantised.conspicuity_statistics[i].maxima;
  }
}

void compare_regions(const Maps& exact, const Maps& quantised, ImageErrors& out) {
  RegionConfig config;
  config.max_regions = 5;
  const std::vector<Peak> expected = find_peaks(exact.saliency, config);
  const std::vector<Peak> actual = find_peaks(quantised.saliency, config);
  out.regions = static_cast<int>(expected.size());
  for (const Peak& peak : expected) {
    const auto within = [&peak](int distance) {
      return [&peak, distance](const Peak& other) {
        return std::abs(other.x - peak.x) <= distance && std::abs(other.y - peak.y) <= distance;
      };
    };
    out.same_region += std::ranges::any_of(actual, within(0)) ? 1 : 0;
    out.near_region += std::ranges::any_of(actual, within(1)) ? 1 : 0;
  }
}

}  // namespace

std::string_view map_name(std::size_t map) {
  return map < first_conspicuity ? feature_names.at(map)
         : map < saliency        ? conspicuity_names.at(map - first_conspicuity)
                                 : "saliency";
}

double map_lsb(std::size_t map) {
  using namespace hls::formats;
  if (map < hls::geometry::intensity_maps) return accuracy::lsb<intensity_feature>();
  if (map < hls::geometry::intensity_maps + hls::geometry::colour_maps)
    return accuracy::lsb<colour_feature>();
  if (map < first_conspicuity) return accuracy::lsb<orientation_feature>();
  if (map == first_conspicuity) return accuracy::lsb<intensity_conspicuity>();
  if (map == first_conspicuity + 1) return accuracy::lsb<colour_conspicuity>();
  if (map == first_conspicuity + 2) return accuracy::lsb<orientation_conspicuity>();
  return accuracy::lsb<hls::formats::saliency>();
}

bool ImageErrors::same_m() const {
  return std::ranges::none_of(other_m, [](bool other) { return other; });
}

ImageErrors measure(const ImageView& image, Against against) {
  Maps exact;
  Maps quantised;
  make_frontend("reference")->compute(image, exact);
  if (against == Against::quantised) {
    make_frontend("quantised")->compute(image, quantised);
  } else {
    const std::vector<std::uint8_t> pixels = with_noise(image);
    make_frontend("reference")
        ->compute({image.width, image.height, pixels.data(), std::ptrdiff_t{3} * image.width, image.order},
                  quantised);
  }
  ImageErrors out;
  for (std::size_t i = 0; i < map_count; ++i) {
    const Map& map = map_of(quantised, i);
    out.maps[i] = compare(map_of(exact, i).values(), map.values());
    out.saturated += at_end_of_word(map);
  }
  compare_maxima(exact, quantised, out);
  compare_regions(exact, quantised, out);
  return out;
}

Summary summarise(const std::vector<ImageErrors>& images) {
  Summary out;
  out.images = static_cast<int>(images.size());
  for (const ImageErrors& image : images) {
    for (std::size_t i = 0; i < map_count; ++i) {
      const MapErrors& errors = image.maps[i];
      Summary::Map& map = out.maps[i];
      const double share = errors.maximum > 0 ? errors.largest_error / errors.maximum : 0;
      map.largest_error = std::max(map.largest_error, errors.largest_error);
      map.largest_share = std::max(map.largest_share, share);
      if (image.same_m()) map.largest_share_same_m = std::max(map.largest_share_same_m, share);
      map.smallest_maximum =
          &image == &images.front() ? errors.maximum : std::min(map.smallest_maximum, errors.maximum);
      if (errors.maximum > 0) map.root_mean_square += errors.mean_square / (errors.maximum * errors.maximum);
      map.other_m += image.other_m[i] ? 1 : 0;
    }
    const MapErrors& s = image.maps[saliency];
    out.images_other_m += image.same_m() ? 0 : 1;
    out.images_saliency_beyond += s.largest_error > accuracy::saliency_share * s.maximum ? 1 : 0;
    out.saturated += image.saturated;
    out.regions += image.regions;
    out.same_region += image.same_region;
    out.near_region += image.near_region;
  }
  for (Summary::Map& map : out.maps) map.root_mean_square = std::sqrt(map.root_mean_square / out.images);
  return out;
}

std::vector<ImageErrors> measure_folder(const std::filesystem::path& folder, int step, Against against) {
  std::vector<std::filesystem::path> all;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) all.push_back(entry.path());
  std::ranges::sort(all);
  std::vector<ImageErrors> out((all.size() + static_cast<std::size_t>(step) - 1) /
                               static_cast<std::size_t>(step));
  tbb::parallel_for(std::size_t{0}, out.size(), [&](std::size_t i) {
    const auto& path = all[i * static_cast<std::size_t>(step)];
    const cv::Mat image = cv::imread(path.string(), cv::IMREAD_COLOR);
    if (image.empty()) throw Error(path.string() + ": no image");
    out[i] =
        measure({image.cols, image.rows, image.data, static_cast<std::ptrdiff_t>(image.step[0])}, against);
  });
  return out;
}

}  // namespace sailmap::numbers
