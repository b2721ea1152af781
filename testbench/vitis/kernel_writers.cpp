// The words of the kernels, from the stages of the reference; no kernel code takes part.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "csim/expected.hpp"
#include "sailmap/hls/kinds.hpp"
#include "writers.hpp"

namespace sailmap::testing {
namespace {

namespace point = ref::point;
using ref::Quantised;
using Planes = std::vector<Plane<double>>;

// What the reference makes of one frame on the way to the feature maps; colours are green, blue, red, yellow.
struct Stages {
  explicit Stages(const csim::Frame& frame) {
    ref::Channels channels = ref::channels<Quantised>(view(frame));
    intensity = ref::pyramid<Quantised, point::intensity>(channels.intensity);
    for (Plane<double>* colour : {&channels.green, &channels.blue, &channels.red, &channels.yellow}) {
      colours.push_back(ref::pyramid<Quantised, point::colour>(*colour));
      contrasts.push_back(ref::each_level(colours.back(), [](const Plane<double>& level) {
        return ref::centre_surround<Quantised, point::colour_contrast>(level).on;
      }));
      sums.push_back(
          ref::across_scales<Quantised, point::colour_partial, point::colour_sum>(contrasts.back()));
      features.push_back(ref::stored<Quantised, point::colour_feature>(sums.back()));
      statistics.push_back(ref::statistics(sums.back(), features.back(), Quantised::tie));
    }
  }
  [[nodiscard]] Planes colours_of(std::size_t level) const {
    return {colours[0][level], colours[1][level], colours[2][level], colours[3][level]};
  }

  ref::Pyramid intensity;
  std::vector<ref::Pyramid> colours;
  std::vector<ref::LevelMaps> contrasts;
  Planes sums;  // exact, before they are rounded to the features
  Planes features;
  std::vector<MapStatistics> statistics;
};

// Four maps as lanes.
template <class Point>
std::vector<std::uint64_t> four(const Planes& maps) {
  return lanes<std::uint64_t, Point, 4>({&maps[0], &maps[1], &maps[2], &maps[3]});
}

// A map a word of its own a pixel.
template <class Point>
std::vector<std::uint32_t> raw_words(const Plane<double>& map) {
  std::vector<std::uint32_t> words;
  for (const double v : map.samples()) words.push_back(static_cast<std::uint32_t>(raw<Point>(v)));
  return words;
}

// A plane, `Word` full of neighbours.
template <class Word, class Point>
std::vector<Word> neighbours(const Plane<double>& plane) {
  return grouped<Word>(lanes<std::uint16_t, Point, 1>({&plane}), sizeof(Word) / 2, 16);
}

constexpr std::array<const char*, 4> colour_names = {"green", "blue", "red", "yellow"};

void channels(Call& call, const csim::Frame& frame, std::size_t /*beat*/, std::uint32_t /*number*/) {
  const Stages stages(frame);
  components(call, frame, 4);
  call.words("intensity_out", neighbours<std::uint64_t, point::grey_sum>(stages.intensity[0]));
  for (std::size_t i = 0; i < 4; ++i) {
    call.words(std::string(colour_names[i]) + "_out",
               neighbours<std::uint64_t, point::colour>(stages.colours[i][0]));
  }
}

void reduce_lanes(Call& call, const Stages& stages) {
  call.words("in", neighbours<std::uint64_t, point::colour>(stages.colours[0][0]));
  call.words("out", neighbours<std::uint32_t, point::colour>(stages.colours[0][1]));
}

void reduce_pixels(Call& call, const Stages& stages) {
  call.words("intensity", neighbours<std::uint16_t, point::intensity>(stages.intensity[2]));
  call.words("colours", four<point::colour>(stages.colours_of(2)));
  call.words("intensity_out", neighbours<std::uint16_t, point::intensity>(stages.intensity[3]));
  call.words("colours_out", four<point::colour>(stages.colours_of(3)));
}

void delay_line(Call& call, const Stages& stages) {
  call.words("in", four<point::colour>(stages.colours_of(2)));
  call.words("out", four<point::colour>(stages.colours_of(2)));
}

void centre_surround(Call& call, const Stages& stages) {
  const ref::Contrast grey = ref::centre_surround<Quantised, point::intensity_contrast>(stages.intensity[2]);
  Planes contrasts;
  for (const ref::LevelMaps& levels : stages.contrasts) contrasts.push_back(levels[0]);
  call.words("intensity", neighbours<std::uint16_t, point::intensity>(stages.intensity[2]));
  call.words("colours", four<point::colour>(stages.colours_of(2)));
  call.words("on_off", wide_pair<point::intensity_contrast>(grey.on, grey.off));
  call.words("green_blue", wide_pair<point::colour_contrast>(contrasts[0], contrasts[1]));
  call.words("red_yellow", wide_pair<point::colour_contrast>(contrasts[2], contrasts[3]));
}

void orientation(Call& call, const Stages& stages) {
  Planes energies;
  for (int i = 0; i < 4; ++i) energies.push_back(ref::gabor_energy<Quantised>(stages.intensity[2], i));
  call.words("intensity", neighbours<std::uint16_t, point::intensity>(stages.intensity[2]));
  call.words("ori_0_45", wide_pair<point::gabor_energy>(energies[0], energies[1]));
  call.words("ori_90_135", wide_pair<point::gabor_energy>(energies[2], energies[3]));
}

void across_scales(Call& call, const Stages& stages) {
  Planes partials;
  Planes fine;
  for (const ref::LevelMaps& levels : stages.contrasts) {
    const Plane<double>& middle = levels[1];
    Plane<double> sum = ref::interpolate(levels[2], middle.width(), middle.height());
    for (std::size_t i = 0; i < sum.samples().size(); ++i) {
      sum.samples()[i] = Quantised::at<point::colour_partial>(sum.samples()[i] + middle.samples()[i]);
    }
    partials.push_back(sum);
    fine.push_back(levels[0]);
  }
  call.words("coarse", wide_pair<point::colour_partial>(partials[0], partials[1]));
  call.words("fine", wide_pair<point::colour_contrast>(fine[0], fine[1]));
  call.words("out", wide_pair<point::colour_sum>(stages.sums[0], stages.sums[1]));
}

// A bit for each of `count` maps from `first` on, and those of the first pixel and of the last but one.
std::vector<std::uint8_t> local_maximum_flags(const Planes& maps, std::size_t first, std::size_t count) {
  std::vector<std::uint8_t> flags;
  for (int y = 0; y < maps[0].height(); ++y) {
    for (int x = 0; x < maps[0].width(); ++x) {
      unsigned word = 0;
      for (std::size_t i = 0; i < count; ++i) {
        word |= (ref::is_local_maximum(maps[first + i], x, y) ? 1U : 0U) << i;
      }
      flags.push_back(static_cast<std::uint8_t>(word));
    }
  }
  flags.front() = static_cast<std::uint8_t>(flags.front() | hls::start_of_frame);
  auto& last = flags[flags.size() - 2];
  last = static_cast<std::uint8_t>(last | hls::last_but_one);
  return flags;
}

void local_maxima(Call& call, const Stages& stages) {
  call.words("in", wide_pair<point::colour_sum>(stages.sums[0], stages.sums[1]));
  call.words("out",
             lanes<std::uint32_t, point::colour_feature, 2>({&stages.features[0], &stages.features[1]}));
  call.words("flags", local_maximum_flags(stages.sums, 0, 2));
}

void join_pairs(Call& call, const Stages& stages) {
  const Planes& maps = stages.features;
  call.words("low", lanes<std::uint32_t, point::colour_feature, 2>({&maps[0], &maps[1]}));
  call.words("low_flags", local_maximum_flags(stages.sums, 0, 2));
  call.words("high", lanes<std::uint32_t, point::colour_feature, 2>({&maps[2], &maps[3]}));
  call.words("high_flags", local_maximum_flags(stages.sums, 2, 2));
  call.words("out", four<point::colour_feature>(maps));
  call.words("flags", local_maximum_flags(stages.sums, 0, 4));
}

std::vector<std::uint32_t> statistics_words(const Stages& stages) {
  std::vector<std::uint32_t> words;
  for (const MapStatistics& map : stages.statistics) append_statistics<point::colour_feature>(map, words);
  return words;
}

void store(Call& call, const Stages& stages) {
  call.words("in", four<point::colour_feature>(stages.features));
  call.words("in_flags", local_maximum_flags(stages.sums, 0, 4));
  call.words("statistics", statistics_words(stages));
  call.words("maps_out", four<point::colour_feature>(stages.features));
  call.words("out", twice(four<point::colour_feature>(stages.features)));
}

// Three of the colour maps stand for the conspicuity maps: their flags are of the same sort.
void peaks(Call& call, const Stages& stages) {
  const Planes& maps = stages.features;
  const auto words = lanes<std::uint64_t, point::colour_feature, 3>({&maps[0], &maps[1], &maps[2]});
  std::vector<std::uint32_t> statistics = statistics_words(stages);
  statistics.resize(6);
  call.words("in", twice(words));
  call.words("in_flags", twice(local_maximum_flags(stages.sums, 0, 3)));
  call.words("statistics", statistics);
  call.words("maps_out", words);
  call.words("out", words);
}

// Mantissa and shift of each map's gain: (raw * mantissa * 16) >> shift is the raw normalised value.
std::vector<std::uint32_t> gain_words(const Stages& stages) {
  std::vector<std::uint32_t> words;
  for (const MapStatistics& map : stages.statistics) {
    const auto maximum = static_cast<double>(raw<point::colour_feature>(map.maximum));
    const int shift = maximum > 0 ? std::ilogb(maximum) + std::ilogb(std::sqrt(map.maxima)) : 0;
    const double mantissa = std::ldexp(Quantised::gain(maximum, map.maxima), point::gain::fraction + shift);
    words.push_back(static_cast<std::uint32_t>(mantissa));
    words.push_back(static_cast<std::uint32_t>(shift));
  }
  return words;
}

void gains(Call& call, const Stages& stages) {
  // The colours stand for all kinds: two of them for intensity, in another order for orientation.
  using Words = std::vector<std::uint32_t>;
  const auto two = [](const Words& words) { return Words(words.begin(), words.begin() + 4); };
  const auto turned = [](Words words) {
    std::rotate(words.begin(), words.begin() + 4, words.end());
    return words;
  };
  const Words statistics = statistics_words(stages);
  const Words gains = gain_words(stages);
  Words all = two(statistics);
  for (const Words& kind : {statistics, turned(statistics)}) all.insert(all.end(), kind.begin(), kind.end());
  call.words("intensity", two(statistics));
  call.words("colour", statistics);
  call.words("orientation", turned(statistics));
  call.words("statistics_out", all);
  call.words("intensity_gains", two(gains));
  call.words("colour_gains", gains);
  call.words("orientation_gains", turned(gains));
}

void normalise(Call& call, const Stages& stages) {
  Planes normalised;
  for (std::size_t i = 0; i < 4; ++i) {
    normalised.push_back(
        ref::normalise<Quantised, point::normalised>(stages.features[i], stages.statistics[i]));
  }
  const Plane<double> sum = ref::sum_of<Quantised, point::colour_conspicuity_sum>(normalised);
  call.words("gains", gain_words(stages));
  call.words("maps", twice(four<point::colour_feature>(stages.features)));
  call.words("sum_out", twice(raw_words<point::colour_conspicuity_sum>(sum)));
}

Writer of(void (*write)(Call&, const Stages&)) {
  return [write](Call& call, const csim::Frame& frame, std::size_t /*beat*/, std::uint32_t /*number*/) {
    write(call, Stages(frame));
  };
}

}  // namespace

Writers kernel_writers() {
  return {{"sailmap_channels", channels},
          {"sailmap_reduce_lanes", of(reduce_lanes)},
          {"sailmap_reduce_pixels", of(reduce_pixels)},
          {"sailmap_delay_line", of(delay_line)},
          {"sailmap_centre_surround", of(centre_surround)},
          {"sailmap_orientation", of(orientation)},
          {"sailmap_across_scales", of(across_scales)},
          {"sailmap_local_maxima", of(local_maxima)},
          {"sailmap_join_pairs", of(join_pairs)},
          {"sailmap_store", of(store)},
          {"sailmap_peaks", of(peaks)},
          {"sailmap_gains", of(gains)},
          {"sailmap_normalise", of(normalise)}};
}

}  // namespace sailmap::testing
