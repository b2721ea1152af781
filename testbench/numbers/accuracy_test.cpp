// Quantised against exact: within what hls/accuracy.hpp states, on photographs, noise and extreme images.
#include "sailmap/hls/accuracy.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "images.hpp"
#include "measure.hpp"
#include "recognition.hpp"
#include "sailmap/maps.hpp"
#include "sailmap/ref/orientation.hpp"
#include "sailmap_data.hpp"

namespace sailmap::numbers {
namespace {

namespace accuracy = hls::accuracy;
using testing::data_folder;

constexpr std::array bounds = {accuracy::intensity_feature_bound, accuracy::colour_feature_bound,
                               accuracy::orientation_feature_bound};
constexpr std::array photographs = {accuracy::intensity_feature_photographs,
                                    accuracy::colour_feature_photographs,
                                    accuracy::orientation_feature_photographs};
constexpr std::array floors = {accuracy::intensity_feature_floor, accuracy::colour_feature_floor,
                               accuracy::orientation_feature_floor};
constexpr std::size_t saliency = map_count - 1;

void expect_within(const ImageErrors& image, const std::array<double, 3>& limits) {
  for (std::size_t i = 0; i < feature_count; ++i) {
    EXPECT_LE(image.maps[i].largest_error, limits.at(kind_of_feature.at(i))) << map_name(i);
  }
}

// The bounds hold, and are no fig leaves: some image comes within a factor of twenty, in each map.
TEST(Accuracy, NoiseAndExtremesKeepTheBounds) {
  std::vector<testing::RgbImage> images = testing::extreme_images();
  for (const int most : {255, 40, 8, 1}) images.push_back(testing::noise(173, 121, 1, most));
  std::array<double, feature_count> largest{};
  for (const auto& image : images) {
    const ImageErrors errors = measure(image.view());
    expect_within(errors, bounds);
    for (std::size_t i = 0; i < feature_count; ++i) {
      largest.at(i) = std::max(largest.at(i), errors.maps[i].largest_error);
    }
  }
  for (std::size_t i = 0; i < feature_count; ++i) {
    EXPECT_GE(largest.at(i), bounds.at(kind_of_feature.at(i)) / 20) << map_name(i);
  }
}

TEST(Accuracy, FlatImagesStayFlat) {
  for (const int grey : {0, 1, 26, 128, 255}) {
    const auto image = testing::image_of(64, 77, [grey](int, int) { return testing::Rgb{grey, grey, grey}; });
    for (const MapErrors& map : measure(image.view()).maps) EXPECT_EQ(map.largest_error, 0) << grey;
  }
}

TEST(Accuracy, WindowsAreThoseOfTheSpec) {
  for (int i = 0; i < 4; ++i) {
    const auto distance = [](const ref::GaborWindow& exact, auto integer, double scale) {
      double sum = 0;
      for (int y = 0; y < hls::gabor::taps; ++y) {
        for (int x = 0; x < hls::gabor::taps; ++x) {
          sum += std::abs(exact.at(static_cast<std::size_t>(y)).at(static_cast<std::size_t>(x)) -
                          integer(x, y) / scale);
        }
      }
      return sum;
    };
    const ref::GaborPair exact = ref::gabor_pair(i);
    const auto even = [i](int x, int y) { return hls::gabor::even(i, x, y); };
    const auto odd = [i](int x, int y) { return hls::gabor::odd(i, x, y); };
    EXPECT_LE(distance(exact.even, even, static_cast<double>(hls::gabor::even_scale(i))),
              hls::gabor::max_window_error);
    EXPECT_LE(distance(exact.odd, odd, static_cast<double>(hls::gabor::odd_scale(i))),
              hls::gabor::max_window_error);
  }
}

class OnSequence : public ::testing::TestWithParam<std::pair<const char*, int>> {};

void expect_shares_of_features(const ImageErrors& image) {
  for (std::size_t i = 0; i < feature_count; ++i) {
    const MapErrors& map = image.maps[i];
    if (map.maximum < floors.at(kind_of_feature.at(i))) continue;
    EXPECT_LE(map.largest_error, accuracy::feature_share * map.maximum) << map_name(i);
  }
}

void expect_shares_after_normalisation(const ImageErrors& image) {
  for (std::size_t i = feature_count; i < map_count; ++i) {
    const double share = i == saliency ? accuracy::saliency_share : accuracy::conspicuity_share;
    EXPECT_LE(image.maps[i].largest_error, share * image.maps[i].maximum) << map_name(i);
  }
}

TEST_P(OnSequence, IsAsStated) {
  const auto& [name, step] = GetParam();
  SAILMAP_NEEDS_DATA(name);
  const std::vector<ImageErrors> images = measure_folder(data_folder() / name / "images", step);
  for (const ImageErrors& image : images) {
    expect_within(image, photographs);
    expect_shares_of_features(image);
    if (image.same_m()) expect_shares_after_normalisation(image);
  }
  EXPECT_GE(summarise(images).agreement(), accuracy::region_agreement);
}

class Recognises : public ::testing::TestWithParam<Sequence> {};

TEST_P(Recognises, AsTheExactReference) {
  const auto& [name, exclude_recent] = GetParam();
  SAILMAP_NEEDS_DATA(name);
  const Recognition exact = recognise(data_folder() / name, exclude_recent, "reference");
  const Recognition quantised = recognise(data_folder() / name, exclude_recent, "quantised");
  EXPECT_NEAR(quantised.paper_weighted, exact.paper_weighted, accuracy::average_precision_change);
  EXPECT_NEAR(quantised.paper, exact.paper, accuracy::average_precision_change);
}

TEST_P(Recognises, WithTheSignatureOfTheChipAsWithTheHosts) {
  const auto& [name, exclude_recent] = GetParam();
  SAILMAP_NEEDS_DATA(name);
  const SignatureDifference difference = compare_signatures(data_folder() / name / "images");
  EXPECT_GT(difference.regions, 0);
  EXPECT_EQ(difference.other_regions, 0);
  EXPECT_LE(difference.largest_entry, accuracy::descriptor_photographs);
  const Recognition host = recognise(data_folder() / name, exclude_recent, "fixed");
  const Recognition chip = recognise(data_folder() / name, exclude_recent, "fixed", SignatureMaker::chip);
  EXPECT_NEAR(chip.paper_weighted, host.paper_weighted, accuracy::chip_average_precision_change);
  EXPECT_NEAR(chip.paper, host.paper, accuracy::chip_average_precision_change);
}

INSTANTIATE_TEST_SUITE_P(Real, Recognises, ::testing::ValuesIn(sequences),
                         [](const auto& test) { return std::string(test.param.name); });

INSTANTIATE_TEST_SUITE_P(Real, OnSequence,
                         ::testing::Values(std::pair{"rtabmap_corridor", 5}, std::pair{"gardens_point", 20}),
                         [](const auto& test) { return std::string(test.param.first); });

}  // namespace
}  // namespace sailmap::numbers
