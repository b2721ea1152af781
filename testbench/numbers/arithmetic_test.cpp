// The kernels' integer steps against real arithmetic and against the reference's quantised policy.
#include "sailmap/hls/arithmetic.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "sailmap/hls/ranges.hpp"
#include "sailmap/ref/quantised.hpp"

namespace sailmap {
namespace {

using ref::Quantised;
namespace formats = hls::formats;

// 0 to most - 1.
class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) {}
  std::uint32_t operator()(std::int64_t most) {
    return static_cast<std::uint32_t>(engine_() % static_cast<std::uint64_t>(most));
  }

 private:
  std::mt19937_64 engine_;
};

template <class Point>
double raw_of(double value) {
  return std::ldexp(Quantised::at<Point>(value), Point::fraction);
}

TEST(Isqrt, IsTheFloorOfSmallRoots) {
  for (std::uint64_t n = 0; n < 70000; ++n) {
    const std::uint64_t root = hls::isqrt(n);
    EXPECT_LE(root * root, n);
    EXPECT_GT((root + 1) * (root + 1), n);
  }
}

TEST(Isqrt, ChangesAtSquares) {
  std::mt19937_64 random(1);
  for (int i = 0; i < 100000; ++i) {
    const std::uint64_t root = 1 + (random() >> (34 + i % 30));
    EXPECT_EQ(hls::isqrt(root * root), root);
    EXPECT_EQ(hls::isqrt(root * root - 1), root - 1);
  }
}

TEST(Reciprocal, IsTheFloorOfTheQuotient) {
  std::mt19937_64 random(1);
  for (int i = 0; i < 300000; ++i) {
    const std::uint64_t divisor = (std::uint64_t{1} << 32) + 65537 + random() % (std::uint64_t{3} << 32);
    EXPECT_EQ(hls::reciprocal(divisor), (std::uint64_t{1} << 48) / divisor);
  }
  EXPECT_EQ(hls::reciprocal(std::uint64_t{1} << 32), 65535);  // saturates
}

// Mantissa and shift of every m against the policy's doubles, for maxima of every length.
TEST(Gain, IsTheQuantisedPolicys) {
  Random random(1);
  const auto expect_same = [](std::uint32_t maximum, std::uint32_t maxima) {
    const hls::Gain gain = hls::gain(maximum, maxima);
    const double expected = Quantised::gain(maximum, static_cast<int>(maxima));
    EXPECT_EQ(std::ldexp(gain.mantissa, -gain.shift - formats::gain::fraction), expected)
        << maximum << ' ' << maxima;
  };
  for (std::uint32_t maxima = 1; maxima <= hls::ranges::maxima_count; ++maxima) {
    expect_same(1 + random(65535), maxima);
  }
  for (std::uint32_t maximum = 1; maximum <= 65535; ++maximum) {
    for (const std::uint32_t maxima : {1U, 2U, 3U, 4U, 100U}) expect_same(maximum, maxima);
  }
  EXPECT_EQ(hls::gain(0, 0).mantissa, 0);
  EXPECT_EQ(Quantised::gain(0, 0), 0);
}

// Against real arithmetic: what the gain and the rounding of the result may cost.
TEST(Gain, NormalisesWithinItsError) {
  Random random(2);
  for (int i = 0; i < 200000; ++i) {
    const std::uint32_t maximum = 1 + random(65535);
    const std::uint32_t maxima = 1 + random(hls::ranges::maxima_count >> (i % 18));
    const std::uint32_t value = random(maximum + 1);
    const double exact = value / (maximum * std::sqrt(maxima));
    const std::uint32_t raw = hls::normalise(value, hls::gain(maximum, maxima));
    const double error = std::ldexp(raw, -formats::normalised::fraction) - exact;
    EXPECT_LE(error, exact * 0x1p-17);             // the root rounds down, the gain with it up
    EXPECT_GE(error, -0x1p-20 - exact * 0x1p-14);  // the gain and the result round down
    EXPECT_LT(raw, std::uint32_t{1} << formats::normalised::fraction);
  }
}

TEST(Channels, AreThePolicys) {
  for (int s = 0; s <= 765; ++s) {
    const double k = 10 * s > 765 ? Quantised::at<formats::colour_reciprocal>(1.5 / s) : 0;
    const auto reciprocal = static_cast<std::uint32_t>(hls::colour_reciprocal(s));
    EXPECT_EQ(reciprocal, std::ldexp(k, formats::colour_reciprocal::fraction)) << s;
    for (int doubled = -510; doubled <= std::min(2 * s, 510); ++doubled) {
      EXPECT_EQ(hls::tuned_colour(reciprocal, doubled), raw_of<formats::colour>(k * std::max(doubled, 0)));
    }
  }
}

TEST(Contrast, IsThePolicys) {
  Random random(3);
  for (int i = 0; i < 200000; ++i) {
    const auto centre = static_cast<std::int32_t>(random(hls::ranges::colour));
    const auto small = centre + static_cast<std::int32_t>(random(48 * hls::ranges::colour));
    const auto large = centre + static_cast<std::int32_t>(random(224 * hls::ranges::colour));
    for (const int sign : {1, -1}) {
      // In the spec's words: centre less the mean of the rest, in raw units of the level.
      const double first = std::max(0.0, sign * (centre - (small - centre) / 48.0));
      const double second = std::max(0.0, sign * (centre - (large - centre) / 224.0));
      const double raw = 21 * (first + second) / 8;  // the unit, and three fraction bits fewer
      EXPECT_NEAR(hls::contrast(centre, small, large, sign), raw, 0.5 + 1e-6);
    }
  }
}

TEST(Gabor, EnergyIsThatOfUnitWindows) {
  for (int i = 0; i < 4; ++i) {
    const auto even_scale = static_cast<double>(hls::gabor::even_scale(i));
    const auto odd_scale = static_cast<double>(hls::gabor::odd_scale(i));
    for (std::uint32_t even = 0; even < 700000; even += 6997) {
      for (std::uint32_t odd = 0; odd < 700000; odd += 7001) {
        const double unit = std::ldexp(1, -formats::gabor_response::fraction);
        const double exact =
            std::ldexp((even / even_scale + odd / odd_scale) * unit, formats::gabor_energy::fraction);
        if (exact > 765 << formats::gabor_energy::fraction) continue;
        EXPECT_NEAR(hls::gabor_energy(i, even, odd), exact, 0.5 + exact * 3e-5);
      }
    }
  }
}

TEST(AcrossScales, RoundOnceASum) {
  Random random(4);
  for (int i = 0; i < 100000; ++i) {
    const std::uint32_t finer = random(hls::ranges::intensity_contrast);
    std::uint32_t coarse = 0;
    for (int k = 0; k < 4; ++k) coarse += random(hls::ranges::intensity_contrast);
    EXPECT_EQ(hls::partial_sum(coarse, finer), std::floor((coarse / 4.0 + finer) / 2 + 0.5));
    const double sum = coarse / 4.0 * 2 + finer;  // a partial is worth two of a level, in raw units
    EXPECT_EQ(hls::level_sum(coarse, finer), 2 * sum);
    EXPECT_EQ(hls::feature(hls::level_sum(coarse, finer)), std::floor(sum / 16 + 0.5));
  }
}

TEST(Sums, OfNormalisedMaps) {
  constexpr std::uint32_t most = (std::uint32_t{1} << formats::normalised::fraction) - 1;
  for (std::uint32_t sum = 0; sum <= 4 * most; sum += 3) {
    EXPECT_EQ(hls::colour_conspicuity(sum), std::floor(sum / 64.0));
    EXPECT_EQ(hls::orientation_conspicuity(sum), std::floor(sum / 64.0));
  }
  for (std::uint32_t sum = 0; sum <= 2 * most; sum += 3) {
    EXPECT_EQ(hls::intensity_conspicuity(sum), std::floor(sum / 32.0));
  }
  for (std::uint32_t sum = 0; sum <= 3 * most; sum += 3) {
    EXPECT_EQ(hls::saliency(sum), std::floor(sum / 64.0 + 0.5));
  }
  EXPECT_EQ(hls::colour_conspicuity(4 * most), 65535);
  EXPECT_EQ(hls::intensity_conspicuity(2 * most), 65535);
}

}  // namespace
}  // namespace sailmap
