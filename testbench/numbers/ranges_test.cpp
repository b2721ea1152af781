// The range analysis against the values that extreme images really cause at each point: never above the
// bound, and of all images together within a bit of it.
#include "sailmap/hls/ranges.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <map>
#include <string>

#include "images.hpp"
#include "sailmap/ref/model.hpp"
#include "sailmap/ref/quantised.hpp"

namespace sailmap {
namespace {

std::map<std::string, std::int64_t>& largest_seen() {
  static std::map<std::string, std::int64_t> seen;
  return seen;
}

// The quantised policy, taking notes.
struct Recording : ref::Quantised {
  template <class Point>
  static double at(double value) {
    const double out = ref::Quantised::at<Point>(value);
    auto& largest = largest_seen()[Point::name()];
    largest = std::max(largest, static_cast<std::int64_t>(std::abs(std::ldexp(out, Point::fraction))));
    return out;
  }
};

// The largest seen at each point, over the extreme images and noise.
const std::map<std::string, std::int64_t>& seen() {
  static const bool done = [] {
    for (const auto& image : testing::extreme_images()) ref::compute<Recording>(image.view());
    ref::compute<Recording>(testing::noise(97, 64, 1).view());
    return true;
  }();
  EXPECT_TRUE(done);
  return largest_seen();
}

struct Bound {
  const char* name;
  int word;
  std::int64_t largest;
};

#define SAILMAP_BOUND(point, value) \
  Bound { #point, hls::formats::point::word, hls::ranges::value }
constexpr Bound bounds[] = {
    SAILMAP_BOUND(grey_sum, grey_sum),
    SAILMAP_BOUND(colour_reciprocal, colour_reciprocal_entry),
    SAILMAP_BOUND(colour, colour),
    SAILMAP_BOUND(intensity, intensity),
    SAILMAP_BOUND(intensity_contrast, intensity_contrast),
    SAILMAP_BOUND(colour_contrast, colour_contrast),
    Bound{"gabor_column", hls::formats::gabor_column::word - 1, hls::ranges::gabor_column_most},
    Bound{"gabor_response", hls::formats::gabor_response::word,
          hls::ranges::response_of(hls::ranges::largest_window_sum())},
    Bound{"gabor_scale", hls::formats::gabor_scale::word, hls::ranges::largest_scale()},
    SAILMAP_BOUND(gabor_energy, gabor_energy),
    SAILMAP_BOUND(intensity_partial, intensity_partial),
    SAILMAP_BOUND(colour_partial, colour_partial),
    SAILMAP_BOUND(orientation_partial, orientation_partial),
    SAILMAP_BOUND(intensity_sum, intensity_sum),
    SAILMAP_BOUND(colour_sum, colour_sum),
    SAILMAP_BOUND(orientation_sum, orientation_sum),
    SAILMAP_BOUND(intensity_feature, intensity_feature),
    SAILMAP_BOUND(colour_feature, colour_feature),
    SAILMAP_BOUND(orientation_feature, orientation_feature),
    SAILMAP_BOUND(normalised, normalised),
    SAILMAP_BOUND(intensity_conspicuity_sum, intensity_conspicuity_sum),
    SAILMAP_BOUND(colour_conspicuity_sum, colour_conspicuity_sum),
    SAILMAP_BOUND(orientation_conspicuity_sum, orientation_conspicuity_sum),
    SAILMAP_BOUND(intensity_conspicuity, intensity_conspicuity),
    SAILMAP_BOUND(colour_conspicuity, colour_conspicuity),
    SAILMAP_BOUND(orientation_conspicuity, orientation_conspicuity),
    SAILMAP_BOUND(normalised_conspicuity, normalised),
    SAILMAP_BOUND(saliency, saliency),
};
#undef SAILMAP_BOUND

class Ranges : public ::testing::TestWithParam<Bound> {};

TEST_P(Ranges, HoldTightly) {
  const Bound& bound = GetParam();
  ASSERT_TRUE(seen().contains(bound.name)) << "the reference does not round there";
  const std::int64_t largest = seen().at(bound.name);
  EXPECT_LE(largest, bound.largest);
  EXPECT_GE(std::bit_width(static_cast<std::uint64_t>(largest)), bound.word - 1) << largest;
}

INSTANTIATE_TEST_SUITE_P(EachPoint, Ranges, ::testing::ValuesIn(bounds),
                         [](const auto& test) { return std::string(test.param.name); });

// Every point at which the reference rounds has a bound here.
TEST(AllRanges, AreTested) {
  for (const auto& [name, largest] : seen()) {
    const auto named = [&name = name](const Bound& bound) { return name == bound.name; };
    const bool block = name == "square_root" || name == "gain";  // by construction in [1, 2) and below 1
    EXPECT_TRUE(block || std::any_of(std::begin(bounds), std::end(bounds), named)) << name;
  }
}

}  // namespace
}  // namespace sailmap
