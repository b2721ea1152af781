// Range analysis and accuracy of the signature: the bounds of hls/signature_ranges.hpp and accuracy.hpp
// against what maps at their extremes really cause.
#include "sailmap/hls/signature_ranges.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <map>
#include <random>
#include <string>

#include "frames.hpp"
#include "numbers/images.hpp"
#include "sailmap/hls/accuracy.hpp"
#include "sailmap/hls/config.hpp"
#include "signature_run.hpp"

namespace sailmap::testing {
namespace {

namespace point = ref::point;
namespace ranges = hls::ranges;
using ref::Quantised;

std::map<std::string, std::int64_t> largest_seen;

// The quantised policy, taking notes.
struct Recording : Quantised {
  template <class Point>
  static double at(double value) {
    const double out = Quantised::at<Point>(value);
    auto& largest = largest_seen[Point::name()];
    largest = std::max(largest, static_cast<std::int64_t>(std::ldexp(out, Point::fraction)));
    return out;
  }
};

constexpr ref::RegionParameters largest_boxes = {20, 0, 16};

// A frame's maps as the front end would make them of these feature maps of the intensity, raw; nothing else
// is there, and the saliency has one peak in the middle.
ref::Model model_of(const Plane<double>& on, const Plane<double>& off) {
  ref::Model model;
  const Plane<double> empty(on.width(), on.height());
  model.features.fill(empty);
  model.conspicuities.fill(empty);
  model.saliency = empty;
  model.saliency(on.width() / 2, on.height() / 2) = 1;
  std::array<Plane<double>, 2> normalised;
  for (std::size_t i = 0; i < 2; ++i) {
    model.features[i] = i == 0 ? on : off;
    for (double& v : model.features[i].samples()) v = std::ldexp(v, -point::intensity_feature::fraction);
    model.feature_statistics[i] = ref::statistics(model.features[i], 0);
    normalised[i] =
        ref::normalise<Quantised, point::normalised>(model.features[i], model.feature_statistics[i]);
  }
  model.conspicuities[0] = ref::stored<Quantised, point::intensity_conspicuity>(
      ref::conspicuity<Quantised, point::intensity_conspicuity_sum>(normalised));
  return model;
}

// Two plateaus at the end of the word: X~ just below 1 all over a region, and C_I just below 2.
SignatureCall plateaus() {
  const Plane<double> flat(40, 40, 65535);
  return {160, 160, model_of(flat, flat), largest_boxes};
}

// X~ just below the last bit of C_I all over a region, but for one pixel: C_I is 0 but there, and v_i large.
SignatureCall faint_region() {
  Plane<double> on(40, 40, 1);
  on(0, 0) = 32768;
  on(20, 20) = 2;
  return {160, 160, model_of(on, Plane<double>(40, 40)), largest_boxes};
}

TEST(SignatureRanges, HoldAndAreReachedWithinABit) {
  largest_seen.clear();
  for (const SignatureCall& call : {plateaus(), faint_region()}) {
    ref::salient_regions<Recording>(call.model, call.parameters);
  }
  for (const RgbImage& image : extreme_images()) {
    ref::salient_regions<Recording>(ref::compute<Quantised>(image.view()), largest_boxes);
  }
  struct Bound {
    const char* name;
    std::int64_t largest;
    int word;
    bool reached;  // of the sums of feature maps one in a region of another kind is as good as all
  };
  const Bound bounds[] = {
      {"intensity_region_sum", ranges::region_area * 65535, point::intensity_region_sum::word, true},
      {"colour_region_sum", ranges::region_area * ranges::colour_feature, point::colour_region_sum::word,
       false},
      {"orientation_region_sum", ranges::region_area * ranges::orientation_feature,
       point::orientation_region_sum::word, false},
      {"intensity_conspicuity_region_sum", ranges::region_area * ranges::intensity_conspicuity,
       point::intensity_conspicuity_region_sum::word, true},
      {"colour_conspicuity_region_sum", ranges::region_area * ranges::colour_conspicuity,
       point::colour_conspicuity_region_sum::word, false},
      {"orientation_conspicuity_region_sum", ranges::region_area * ranges::orientation_conspicuity,
       point::orientation_conspicuity_region_sum::word, false},
      {"normalised_region_sum", ranges::normalised_region_sum, point::normalised_region_sum::word, true},
      {"descriptor_entry", ranges::descriptor_entry, point::descriptor_entry::word, true}};
  EXPECT_EQ(largest_seen.size(), std::size(bounds)) << "a point without a bound, or the other way round";
  for (const Bound& bound : bounds) {
    const std::int64_t largest = largest_seen.at(bound.name);
    EXPECT_LE(largest, bound.largest) << bound.name;
    EXPECT_GT(largest, 0) << bound.name;
    if (bound.reached) {
      EXPECT_GE(std::bit_width(static_cast<std::uint64_t>(largest)), bound.word) << bound.name;
    }
  }
}

// The kernel at those ends.
TEST(SignatureRanges, TheKernelComputesTheExtremesRightly) {
  const std::vector<SignatureCall> calls = {plateaus(), faint_region()};
  const std::vector<std::uint32_t> records = simulated_records<hls::Config<160, 160, 1>>(calls);
  EXPECT_EQ(records, expected_records(calls));
  EXPECT_THAT(regions_found(records), ::testing::Each(1));
  EXPECT_GT(records[248 + 8 + 2], 1U << 24);  // v of intensity_on of the faint region, above 256
}

// Eq. 3-4 of the raw maps in real numbers, without any rounding on the way.
std::array<double, 10> exact_descriptor(const ref::Model& model, const ref::RegionBox& box) {
  std::array<double, 10> v{};
  for (std::size_t i = 0; i < v.size(); ++i) {
    const std::size_t kind = i < 2 ? 0 : i < 6 ? 1 : 2;
    double feature = 0;
    double conspicuity = 0;
    for (int y = box.y0; y < box.y1; ++y) {
      for (int x = box.x0; x < box.x1; ++x) {
        feature += model.features[i](x, y);
        conspicuity += model.conspicuities[kind](x, y);
      }
    }
    if (conspicuity > 0) v[i] = feature * model.feature_statistics[i].gain() / conspicuity;
  }
  return v;
}

// Returns the largest part of the stated error that was used.
double expect_within_the_bound(const ref::Model& model, const ref::RegionParameters& parameters) {
  namespace accuracy = hls::accuracy;
  double used = 0;
  for (const ref::SalientRegion& region : ref::salient_regions<Quantised>(model, parameters)) {
    const auto exact =
        exact_descriptor(model, ref::region_box(region.x, region.y, parameters.box_side,
                                                model.saliency.width(), model.saliency.height()));
    for (std::size_t i = 0; i < exact.size(); ++i) {
      const double limit = accuracy::descriptor_share * exact[i] + accuracy::descriptor_bound;
      const double error = std::abs(region.descriptor[i] - exact[i]);
      EXPECT_LE(error, limit) << "entry " << i << ", " << exact[i];
      used = std::max(used, error / limit);
    }
  }
  return used;
}

// And is no fig leaf: half of it is used.
TEST(SignatureAccuracy, EntriesKeepTheirBoundOnTheSameMaps) {
  const unsigned seed = std::random_device{}();
  std::cout << "seed " << seed << '\n';
  std::mt19937 random(seed);
  double used = 0;
  for (const SignatureCall& call : {plateaus(), faint_region()}) {
    used = std::max(used, expect_within_the_bound(call.model, call.parameters));
  }
  for (const RgbImage& image : extreme_images()) {
    used = std::max(used, expect_within_the_bound(ref::compute<Quantised>(image.view()), {}));
  }
  for (int i = 0; i < 20; ++i) {
    const csim::Frame frame = i % 2 == 0 ? noise_frame(160, 120, random) : patches_frame(160, 120, random);
    used = std::max(used, expect_within_the_bound(ref::compute<Quantised>(view(frame)), {20, 0, 10}));
  }
  EXPECT_GT(used, 0.5);
}

}  // namespace
}  // namespace sailmap::testing
