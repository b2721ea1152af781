// Each stage of the front end alone, against the quantised reference's function of the same section.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <iostream>
#include <random>

#include "expected.hpp"
#include "frames.hpp"
#include "sailmap/hls/front_end.hpp"
#include "stage_run.hpp"

namespace sailmap::testing {
namespace {

using Config = hls::Config<512, 400, 1>;
using ref::Quantised;
namespace point = ref::point;
using hls::geometry::level_side;

// Five channels or four colours of raw numbers.
using Raw = std::vector<std::uint16_t>;

class Stages : public ::testing::Test {
 protected:
  Stages() {
    const unsigned seed = std::random_device{}();
    std::cout << "seed " << seed << '\n';
    random.seed(seed);
  }

  // Uniform, or mostly one of the two ends of the range, which is where sums are largest.
  Raw raw_plane(int pixels, int largest, bool extreme) {
    Raw plane(static_cast<std::size_t>(pixels));
    std::uniform_int_distribution<int> value(0, largest);
    std::bernoulli_distribution coin(0.5);
    for (auto& v : plane)
      v = static_cast<std::uint16_t>(extreme ? (coin(random) ? largest : 0) : value(random));
    return plane;
  }

  // Values at a point, 0 to `largest` raw.
  template <class Point>
  Plane<double> values(int width, int height, std::int64_t largest) {
    Plane<double> plane(width, height);
    std::uniform_int_distribution<std::int64_t> value(0, largest);
    for (double& v : plane.samples()) {
      v = std::ldexp(static_cast<double>(value(random)), -Point::fraction);
    }
    return plane;
  }

  std::mt19937 random;
};

// The largest raw pyramid samples: white, and a pure colour.
constexpr int largest_grey_sum = 765;
constexpr int largest_intensity = 765 << point::intensity::fraction;
constexpr int largest_colour = 3 << point::colour::fraction;

template <class Point>
Plane<double> real(const Raw& raw_values, int width, int height) {
  Plane<double> plane(width, height);
  for (std::size_t i = 0; i < raw_values.size(); ++i) {
    plane.samples()[i] = std::ldexp(raw_values[i], -Point::fraction);
  }
  return plane;
}

template <class Point>
Raw raw_of(const Plane<double>& plane) {
  return lanes<std::uint16_t, Point, 1>({&plane});
}

// Planes as lanes of one word, the first low.
template <class Word>
std::vector<Word> pack(const std::vector<Raw>& planes) {
  std::vector<Word> words(planes[0].size());
  for (std::size_t lane = 0; lane < planes.size(); ++lane) {
    for (std::size_t i = 0; i < words.size(); ++i) {
      words[i] = static_cast<Word>(words[i] | static_cast<std::uint64_t>(planes[lane][i]) << (16 * lane));
    }
  }
  return words;
}

// `Count` neighbours of one plane as lanes of one word.
template <int Count>
std::vector<hls::lanes_t<Count>> group(const Raw& plane) {
  std::vector<hls::lanes_t<Count>> words(plane.size() / Count);
  for (std::size_t i = 0; i < words.size() * Count; ++i) {
    words[i / Count] = static_cast<hls::lanes_t<Count>>(
        words[i / Count] | static_cast<std::uint64_t>(plane[i]) << (16 * (i % Count)));
  }
  return words;
}

TEST_F(Stages, ChannelsOfAllGreysAndRandomColours) {
  csim::Frame frame = noise_frame(256, 200, random);
  for (int v = 0; v < 256; ++v) {
    const auto byte = static_cast<std::uint8_t>(v);
    set_pixel(frame, v, 0, byte, byte, byte);
    set_pixel(frame, v, 1, byte, 0, 0);
    set_pixel(frame, v, 2, 0, byte, 255);
    set_pixel(frame, v, 3, 255, 255, byte);
    set_pixel(frame, v, 4, static_cast<std::uint8_t>(v / 8), static_cast<std::uint8_t>(v % 40), 20);
  }
  const ref::Channels want = ref::channels<Quantised>(view(frame));
  std::array<std::vector<std::uint8_t>, 3> components;
  for (std::size_t i = 0; i < frame.rgb.size(); ++i) components[i % 3].push_back(frame.rgb[i]);
  const std::size_t pixels = components[0].size();
  StageRun run;
  Raw intensity;
  std::vector<std::uint64_t> colours;
  SAILMAP_STAGE((hls::channels_1<Config>), run.feed(components[0]), run.feed(components[1]),
                run.feed(components[2]), run.take(pixels, intensity), run.take(pixels, colours),
                std::uint16_t{256}, std::uint16_t{200});
  run.run();
  EXPECT_EQ(intensity, raw_of<point::grey_sum>(want.intensity));
  EXPECT_EQ(colours,
            (lanes<std::uint64_t, point::colour, 4>({&want.green, &want.blue, &want.red, &want.yellow})));
}

// The five channels of a level, and what the reference makes of them.
struct PyramidCase {
  int width, height;
  std::vector<Raw> in;    // intensity, green, blue, red, yellow
  std::vector<Raw> want;  // the same at the next level
};

template <int Fine>
PyramidCase pyramid_case(int width, int height, const std::vector<Raw>& in) {
  using Grey = std::conditional_t<Fine == 0, point::grey_sum, point::intensity>;
  PyramidCase out{width, height, in, {}};
  out.want.push_back(
      raw_of<point::intensity>(ref::reduce<Quantised, point::intensity>(real<Grey>(in[0], width, height))));
  for (std::size_t i = 1; i < 5; ++i) {
    out.want.push_back(raw_of<point::colour>(
        ref::reduce<Quantised, point::colour>(real<point::colour>(in[i], width, height))));
  }
  return out;
}

template <int Fine>
void expect_pixels_reduced(const PyramidCase& c) {
  StageRun run;
  Raw intensity;
  std::vector<std::uint64_t> colours;
  const std::size_t pixels = c.want[0].size();
  SAILMAP_STAGE((hls::reduce_pixels<Config, Fine>), run.feed(c.in[0]),
                run.feed(pack<std::uint64_t>({c.in[1], c.in[2], c.in[3], c.in[4]})),
                run.take(pixels, intensity), run.take(pixels, colours),
                static_cast<std::uint16_t>(c.width << Fine), static_cast<std::uint16_t>(c.height << Fine));
  run.run();
  EXPECT_EQ(intensity, c.want[0]);
  EXPECT_EQ(colours, pack<std::uint64_t>({c.want[1], c.want[2], c.want[3], c.want[4]}));
}

template <int Fine, int Count, int Channel>
void expect_lanes_reduced(const PyramidCase& c) {
  StageRun run;
  std::vector<hls::lanes_t<Count / 2>> got;
  SAILMAP_STAGE((hls::reduce_lanes<Config, Fine, Count, Channel>), run.feed(group<Count>(c.in[Channel])),
                run.take(c.want[Channel].size() / (Count / 2), got),
                static_cast<std::uint16_t>(c.width << Fine), static_cast<std::uint16_t>(c.height << Fine));
  run.run();
  EXPECT_EQ(got, group<Count / 2>(c.want[Channel])) << "channel " << Channel;
}

TEST_F(Stages, PyramidOfAnySize) {
  for (const auto& [w, h] : {std::pair{64, 64}, {65, 64}, {67, 81}, {80, 75}, {130, 5}, {4, 4}, {5, 9}}) {
    for (const bool extreme : {false, true}) {
      SCOPED_TRACE(std::to_string(w) + "x" + std::to_string(h));
      std::vector<Raw> in = {raw_plane(w * h, largest_intensity, extreme)};
      for (int i = 0; i < 4; ++i) in.push_back(raw_plane(w * h, largest_colour, extreme));
      expect_pixels_reduced<1>(pyramid_case<1>(w, h, in));
      if (w % 2 == 0) expect_lanes_reduced<1, 2, 0>(pyramid_case<1>(w, h, in));
      if (w % 4 == 0) expect_lanes_reduced<1, 4, 1>(pyramid_case<1>(w, h, in));
      in[0] = raw_plane(w * h, largest_grey_sum, extreme);
      expect_pixels_reduced<0>(pyramid_case<0>(w, h, in));
      if (w % 4 == 0) expect_lanes_reduced<0, 4, 0>(pyramid_case<0>(w, h, in));
    }
  }
}

constexpr std::array<std::pair<int, int>, 6> level_2_sizes = {
    {{16, 16}, {17, 25}, {40, 16}, {16, 60}, {61, 33}, {128, 100}}};

std::uint16_t full(int side) { return static_cast<std::uint16_t>(side << hls::geometry::base_level); }

TEST_F(Stages, CentreSurround) {
  for (const auto& [w, h] : level_2_sizes) {
    for (const bool extreme : {false, true}) {
      SCOPED_TRACE(std::to_string(w) + "x" + std::to_string(h));
      const Raw intensity = raw_plane(w * h, largest_intensity, extreme);
      std::vector<Raw> colours;
      std::vector<Plane<double>> want_colours;
      for (int i = 0; i < 4; ++i) {
        colours.push_back(raw_plane(w * h, largest_colour, extreme));
        want_colours.push_back(
            ref::centre_surround<Quantised, point::colour_contrast>(real<point::colour>(colours.back(), w, h))
                .on);
      }
      const ref::Contrast want =
          ref::centre_surround<Quantised, point::intensity_contrast>(real<point::intensity>(intensity, w, h));
      StageRun run;
      std::vector<std::uint64_t> on_off;
      std::vector<std::uint64_t> green_blue;
      std::vector<std::uint64_t> red_yellow;
      SAILMAP_STAGE((hls::centre_surround<Config, 2>), run.feed(intensity),
                    run.feed(pack<std::uint64_t>(colours)), run.take(intensity.size(), on_off),
                    run.take(intensity.size(), green_blue), run.take(intensity.size(), red_yellow), full(w),
                    full(h));
      run.run();
      EXPECT_EQ(on_off, wide_pair<point::intensity_contrast>(want.on, want.off));
      EXPECT_EQ(green_blue, wide_pair<point::colour_contrast>(want_colours[0], want_colours[1]));
      EXPECT_EQ(red_yellow, wide_pair<point::colour_contrast>(want_colours[2], want_colours[3]));
    }
  }
}

TEST_F(Stages, Orientation) {
  for (const auto& [w, h] : level_2_sizes) {
    for (const bool extreme : {false, true}) {
      SCOPED_TRACE(std::to_string(w) + "x" + std::to_string(h));
      const Raw intensity = raw_plane(w * h, largest_intensity, extreme);
      std::vector<Plane<double>> want;
      for (int i = 0; i < 4; ++i) {
        want.push_back(ref::gabor_energy<Quantised>(real<point::intensity>(intensity, w, h), i));
      }
      StageRun run;
      std::vector<std::uint64_t> ori_0_45;
      std::vector<std::uint64_t> ori_90_135;
      SAILMAP_STAGE((hls::orientation_energy<Config, 2>), run.feed(intensity),
                    run.take(intensity.size(), ori_0_45), run.take(intensity.size(), ori_90_135), full(w),
                    full(h));
      run.run();
      EXPECT_EQ(ori_0_45, wide_pair<point::gabor_energy>(want[0], want[1]));
      EXPECT_EQ(ori_90_135, wide_pair<point::gabor_energy>(want[2], want[3]));
    }
  }
}

// Three levels through both across-scales stages, as a pair of colours.
TEST_F(Stages, AcrossScales) {
  for (const auto& [w, h] : level_2_sizes) {
    SCOPED_TRACE(std::to_string(w) + "x" + std::to_string(h));
    std::array<ref::LevelMaps, 2> maps;
    std::vector<Plane<double>> want;
    for (ref::LevelMaps& levels : maps) {
      for (int level = 0; level < 3; ++level) {
        const int lw = level_side(w, level);
        const int lh = level_side(h, level);
        // What three of may be added up: half the word.
        levels[static_cast<std::size_t>(level)] =
            values<point::colour_contrast>(lw, lh, point::colour_contrast::max_raw() / 2);
      }
      want.push_back(ref::across_scales<Quantised, point::colour_partial, point::colour_sum>(levels));
    }
    const auto level_words = [&](std::size_t level) {
      return wide_pair<point::colour_contrast>(maps[0][level], maps[1][level]);
    };
    StageRun run;
    std::vector<std::uint64_t> got;
    auto& partial = run.between<std::uint64_t>();
    SAILMAP_STAGE((hls::across_scales<Config, 3, hls::green_blue_pair>), run.feed(level_words(2)),
                  run.feed(level_words(1)), partial, full(w), full(h));
    SAILMAP_STAGE((hls::across_scales<Config, 2, hls::green_blue_pair>), partial, run.feed(level_words(0)),
                  run.take(want[0].samples().size(), got), full(w), full(h));
    run.run();
    EXPECT_EQ(got, wide_pair<point::colour_sum>(want[0], want[1]));
  }
}

TEST_F(Stages, JoinPairs) {
  std::vector<std::uint32_t> low(16 * 16);
  std::vector<std::uint32_t> high(low.size());
  std::vector<std::uint8_t> low_flags(low.size());
  std::vector<std::uint8_t> high_flags(low.size());
  std::vector<std::uint64_t> want;
  std::vector<std::uint8_t> want_flags;
  for (std::size_t i = 0; i < low.size(); ++i) {
    low[i] = static_cast<std::uint32_t>(random());
    high[i] = static_cast<std::uint32_t>(random());
    const unsigned place = i == 0 ? hls::start_of_frame : i + 2 == low.size() ? hls::last_but_one : 0;
    low_flags[i] = static_cast<std::uint8_t>(random() % 4 + place);
    high_flags[i] = static_cast<std::uint8_t>(random() % 4 + place);
    want.push_back(std::uint64_t{high[i]} * 0x100000000U + low[i]);
    want_flags.push_back(static_cast<std::uint8_t>(high_flags[i] % 4 * 4 + low_flags[i]));
  }
  StageRun run;
  std::vector<std::uint64_t> got;
  std::vector<std::uint8_t> flags;
  SAILMAP_STAGE((hls::join_pairs<Config, hls::colour_kind>), run.feed(low), run.feed(low_flags),
                run.feed(high), run.feed(high_flags), run.take(want.size(), got),
                run.take(want.size(), flags), full(16), full(16));
  run.run();
  EXPECT_EQ(got, want);
  EXPECT_EQ(flags, want_flags);
}

// Maxima, store, gains and normalisation of one kind; few different values, so that neighbours are often
// equal, in the sums or only once they are rounded.
TEST_F(Stages, StatisticsAndNormalisation) {
  for (const auto& [w, h] : level_2_sizes) {
    for (const std::int64_t largest : std::initializer_list<std::int64_t>{0, 1, 3, 40, 700, 1541120}) {
      SCOPED_TRACE(std::to_string(w) + "x" + std::to_string(h) + " up to " + std::to_string(largest));
      const std::array<Plane<double>, 2> sums = {
          values<point::intensity_sum>(w, h, largest),
          values<point::intensity_sum>(w, h, std::min<std::int64_t>(100, largest))};
      std::vector<std::uint32_t> want_statistics;
      std::array<Plane<double>, 2> maps;
      std::array<Plane<double>, 2> normalised;
      for (std::size_t i = 0; i < 2; ++i) {
        maps[i] = ref::stored<Quantised, point::intensity_feature>(sums[i]);
        const MapStatistics statistics = ref::statistics(sums[i], maps[i], Quantised::tie);
        append_statistics<point::intensity_feature>(statistics, want_statistics);
        normalised[i] = ref::normalise<Quantised, point::normalised>(maps[i], statistics);
      }
      const Plane<double> want = ref::sum_of<Quantised, point::intensity_conspicuity_sum>(normalised);

      StageRun run;
      std::vector<std::uint32_t> maps_out;
      std::vector<std::uint32_t> statistics;
      std::vector<std::uint32_t> sum;
      // Maximum and m of the maps of the other kinds, of which this is not about, and their gains.
      const std::vector<std::uint32_t> others = {1, 1, 2, 1, 3, 4, 0, 0};
      const std::vector<std::uint32_t> want_other_gains = {0xffff, 0, 0xffff, 1, 0xaaaa, 2, 0, 0};
      std::vector<std::uint32_t> other_gains;
      std::vector<std::uint32_t> other_gains_2;
      want_statistics.insert(want_statistics.end(), others.begin(), others.end());
      want_statistics.insert(want_statistics.end(), others.begin(), others.end());
      auto& checked = run.between<std::uint32_t>();
      auto& flags = run.between<std::uint8_t>();
      auto& raw_statistics = run.between<std::uint32_t>();
      auto& stored = run.between<std::uint32_t>();
      auto& gains = run.between<std::uint32_t>();
      const std::size_t pixels = sums[0].samples().size();
      SAILMAP_STAGE((hls::local_maxima<Config, hls::on_off_pair>),
                    run.feed(wide_pair<point::intensity_sum>(sums[0], sums[1])), checked, flags, full(w),
                    full(h));
      SAILMAP_STAGE((hls::store<Config, 2, hls::intensity_kind, 0>), checked, flags, raw_statistics,
                    run.take(pixels, maps_out), stored, full(w), full(h));
      SAILMAP_STAGE((hls::gains_of_features<Config>), raw_statistics, run.feed(others), run.feed(others),
                    run.take(20, statistics), gains, run.take(8, other_gains), run.take(8, other_gains_2));
      SAILMAP_STAGE((hls::normalise<Config, 2, hls::intensity_kind>), gains, stored,
                    run.take(2 * pixels, sum), full(w), full(h));
      run.run();
      EXPECT_EQ(statistics, want_statistics);
      EXPECT_EQ(other_gains, want_other_gains);
      EXPECT_EQ(other_gains_2, want_other_gains);
      EXPECT_EQ(maps_out, (lanes<std::uint32_t, point::intensity_feature, 2>({&maps[0], &maps[1]})));
      for (std::size_t i = 0; i < pixels; ++i) {
        ASSERT_EQ(sum[i], raw<point::intensity_conspicuity_sum>(want.samples()[i])) << i;
        ASSERT_EQ(sum[pixels + i], sum[i]) << i;
      }
    }
  }
}

}  // namespace
}  // namespace sailmap::testing
