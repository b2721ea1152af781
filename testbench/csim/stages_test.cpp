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
      std::vector<Raw> want_colours;
      for (int i = 0; i < 4; ++i) {
        colours.push_back(raw_plane(w * h, largest_colour, extreme));
        want_colours.push_back(raw_of<point::colour_contrast>(
            ref::centre_surround<Quantised, point::colour_contrast>(real<point::colour>(colours.back(), w, h))
                .on));
      }
      const ref::Contrast want =
          ref::centre_surround<Quantised, point::intensity_contrast>(real<point::intensity>(intensity, w, h));
      StageRun run;
      std::vector<std::uint32_t> on_off;
      std::vector<std::uint64_t> opponents;
      SAILMAP_STAGE((hls::centre_surround<Config, 2>), run.feed(intensity),
                    run.feed(pack<std::uint64_t>(colours)), run.take(intensity.size(), on_off),
                    run.take(intensity.size(), opponents), full(w), full(h));
      run.run();
      EXPECT_EQ(on_off, (lanes<std::uint32_t, point::intensity_contrast, 2>({&want.on, &want.off})));
      EXPECT_EQ(opponents, pack<std::uint64_t>(want_colours));
    }
  }
}

TEST_F(Stages, Orientation) {
  for (const auto& [w, h] : level_2_sizes) {
    for (const bool extreme : {false, true}) {
      SCOPED_TRACE(std::to_string(w) + "x" + std::to_string(h));
      const Raw intensity = raw_plane(w * h, largest_intensity, extreme);
      std::vector<Raw> want;
      for (int i = 0; i < 4; ++i) {
        want.push_back(raw_of<point::gabor_energy>(
            ref::gabor_energy<Quantised>(real<point::intensity>(intensity, w, h), i)));
      }
      StageRun run;
      std::vector<std::uint64_t> energies;
      SAILMAP_STAGE((hls::orientation_energy<Config, 2>), run.feed(intensity),
                    run.take(intensity.size(), energies), full(w), full(h));
      run.run();
      EXPECT_EQ(energies, pack<std::uint64_t>(want));
    }
  }
}

// Three levels through both across-scales stages, as colours.
TEST_F(Stages, AcrossScales) {
  for (const auto& [w, h] : level_2_sizes) {
    SCOPED_TRACE(std::to_string(w) + "x" + std::to_string(h));
    std::array<std::vector<Raw>, 3> levels;
    std::vector<Raw> want;
    for (int map = 0; map < 4; ++map) {
      ref::LevelMaps maps;
      for (int level = 0; level < 3; ++level) {
        const int lw = level_side(w, level);
        const int lh = level_side(h, level);
        // A third of the range each: three of them must fit the sum.
        levels[static_cast<std::size_t>(level)].push_back(raw_plane(lw * lh, 65535 / 2, false));
        maps[static_cast<std::size_t>(level)] =
            real<point::colour_contrast>(levels[static_cast<std::size_t>(level)].back(), lw, lh);
      }
      want.push_back(raw_of<point::colour_feature>(
          ref::across_scales<Quantised, point::colour_partial, point::colour_feature>(maps)));
    }
    StageRun run;
    std::vector<std::uint64_t> got;
    auto& partial = run.between<std::uint64_t>();
    SAILMAP_STAGE((hls::across_scales<Config, 3, 4, hls::colour_kind>),
                  run.feed(pack<std::uint64_t>(levels[2])), run.feed(pack<std::uint64_t>(levels[1])), partial,
                  full(w), full(h));
    SAILMAP_STAGE((hls::across_scales<Config, 2, 4, hls::colour_kind>), partial,
                  run.feed(pack<std::uint64_t>(levels[0])), run.take(want[0].size(), got), full(w), full(h));
    run.run();
    EXPECT_EQ(got, pack<std::uint64_t>(want));
  }
}

// Maxima, store, gains and normalisation of one kind; few different values, so that neighbours are often
// equal.
TEST_F(Stages, StatisticsAndNormalisation) {
  for (const auto& [w, h] : level_2_sizes) {
    for (const int largest : {0, 1, 3, 700, 65535}) {
      SCOPED_TRACE(std::to_string(w) + "x" + std::to_string(h) + " up to " + std::to_string(largest));
      std::vector<Raw> maps = {raw_plane(w * h, largest, false),
                               raw_plane(w * h, std::min(2, largest), false)};
      std::vector<std::uint32_t> want_statistics;
      std::array<Plane<double>, 2> normalised;
      for (std::size_t i = 0; i < 2; ++i) {
        const Plane<double> map = real<point::intensity_feature>(maps[i], w, h);
        const MapStatistics statistics = ref::statistics(map, Quantised::tie);
        append_statistics<point::intensity_feature>(statistics, want_statistics);
        normalised[i] = ref::normalise<Quantised, point::normalised>(map, statistics);
      }
      const Plane<double> want = ref::sum_of<Quantised, point::intensity_conspicuity>(normalised);

      StageRun run;
      std::vector<std::uint32_t> replayed;
      std::vector<std::uint32_t> statistics;
      Raw sum;
      auto& checked = run.between<std::uint32_t>();
      auto& flags = run.between<std::uint8_t>();
      auto& raw_statistics = run.between<std::uint32_t>();
      auto& stored = run.between<std::uint32_t>();
      auto& gains = run.between<std::uint32_t>();
      const std::size_t pixels = maps[0].size();
      SAILMAP_STAGE((hls::local_maxima<Config, 2, hls::intensity_kind>), run.feed(pack<std::uint32_t>(maps)),
                    checked, flags, full(w), full(h));
      SAILMAP_STAGE((hls::store<Config, 2, hls::intensity_kind, 0>), checked, flags, raw_statistics, stored,
                    full(w), full(h));
      SAILMAP_STAGE((hls::gains<Config, 2, hls::intensity_kind>), raw_statistics, run.take(4, statistics),
                    gains);
      SAILMAP_STAGE((hls::normalise<Config, 2, hls::intensity_kind>), gains, stored,
                    run.take(pixels, replayed), run.take(pixels, sum), full(w), full(h));
      run.run();
      EXPECT_EQ(statistics, want_statistics);
      EXPECT_EQ(replayed, pack<std::uint32_t>(maps));
      EXPECT_EQ(sum, raw_of<point::intensity_conspicuity>(want));
    }
  }
}

}  // namespace
}  // namespace sailmap::testing
