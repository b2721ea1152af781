// Writes the words of one synthesis top's test bench (scripts/vitis/testbench.hpp has the format), in and
// out, from the quantised reference: write_vectors TOP BEAT FILE [IMAGE.ppm...]. Three frames of different
// size, or those images; no kernel code takes part.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <exception>
#include <fstream>
#include <functional>
#include <iostream>
#include <map>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "beats.hpp"
#include "call.hpp"
#include "csim/expected.hpp"
#include "csim/expected_signature.hpp"
#include "csim/frames.hpp"
#include "ppm.hpp"
#include "sailmap/hls/kinds.hpp"
#include "sailmap/hls/memory_registers.h"

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

// `count` neighbouring words of `bits` bits as one, the left one low.
template <class Word, class Part>
std::vector<Word> grouped(const std::vector<Part>& parts, std::size_t count, int bits) {
  std::vector<Word> words(parts.size() / count);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const std::uint64_t shifted = std::uint64_t{parts[i]} << (bits * static_cast<int>(i % count));
    words[i / count] = static_cast<Word>(words[i / count] | shifted);
  }
  return words;
}

// A plane, `Word` full of neighbours.
template <class Word, class Point>
std::vector<Word> neighbours(const Plane<double>& plane) {
  return grouped<Word>(lanes<std::uint16_t, Point, 1>({&plane}), sizeof(Word) / 2, 16);
}

constexpr std::array<const char*, 4> colour_names = {"green", "blue", "red", "yellow"};

// Red, green or blue bytes, `beat` a word.
std::vector<std::uint64_t> bytes(const csim::Frame& frame, std::size_t component, std::size_t beat) {
  std::vector<std::uint8_t> samples;
  for (std::size_t i = component; i < frame.rgb.size(); i += 3) samples.push_back(frame.rgb[i]);
  return grouped<std::uint64_t>(samples, beat, 8);
}

void components(Call& call, const csim::Frame& frame, std::size_t beat) {
  call.words("red", bytes(frame, 0, beat));
  call.words("green", bytes(frame, 1, beat));
  call.words("blue", bytes(frame, 2, beat));
}

void channels(Call& call, const csim::Frame& frame, const Stages& stages) {
  components(call, frame, 4);
  call.words("intensity_out", neighbours<std::uint64_t, point::grey_sum>(stages.intensity[0]));
  for (std::size_t i = 0; i < 4; ++i) {
    call.words(std::string(colour_names[i]) + "_out",
               neighbours<std::uint64_t, point::colour>(stages.colours[i][0]));
  }
}

void reduce_lanes(Call& call, const csim::Frame& /*frame*/, const Stages& stages) {
  call.words("in", neighbours<std::uint64_t, point::colour>(stages.colours[0][0]));
  call.words("out", neighbours<std::uint32_t, point::colour>(stages.colours[0][1]));
}

void reduce_pixels(Call& call, const csim::Frame& /*frame*/, const Stages& stages) {
  call.words("intensity", neighbours<std::uint16_t, point::intensity>(stages.intensity[2]));
  call.words("colours", four<point::colour>(stages.colours_of(2)));
  call.words("intensity_out", neighbours<std::uint16_t, point::intensity>(stages.intensity[3]));
  call.words("colours_out", four<point::colour>(stages.colours_of(3)));
}

void delay_line(Call& call, const csim::Frame& /*frame*/, const Stages& stages) {
  call.words("in", four<point::colour>(stages.colours_of(2)));
  call.words("out", four<point::colour>(stages.colours_of(2)));
}

void centre_surround(Call& call, const csim::Frame& /*frame*/, const Stages& stages) {
  const ref::Contrast grey = ref::centre_surround<Quantised, point::intensity_contrast>(stages.intensity[2]);
  Planes contrasts;
  for (const ref::LevelMaps& levels : stages.contrasts) contrasts.push_back(levels[0]);
  call.words("intensity", neighbours<std::uint16_t, point::intensity>(stages.intensity[2]));
  call.words("colours", four<point::colour>(stages.colours_of(2)));
  call.words("on_off", wide_pair<point::intensity_contrast>(grey.on, grey.off));
  call.words("green_blue", wide_pair<point::colour_contrast>(contrasts[0], contrasts[1]));
  call.words("red_yellow", wide_pair<point::colour_contrast>(contrasts[2], contrasts[3]));
}

void orientation(Call& call, const csim::Frame& /*frame*/, const Stages& stages) {
  Planes energies;
  for (int i = 0; i < 4; ++i) energies.push_back(ref::gabor_energy<Quantised>(stages.intensity[2], i));
  call.words("intensity", neighbours<std::uint16_t, point::intensity>(stages.intensity[2]));
  call.words("ori_0_45", wide_pair<point::gabor_energy>(energies[0], energies[1]));
  call.words("ori_90_135", wide_pair<point::gabor_energy>(energies[2], energies[3]));
}

void across_scales(Call& call, const csim::Frame& /*frame*/, const Stages& stages) {
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

void local_maxima(Call& call, const csim::Frame& /*frame*/, const Stages& stages) {
  call.words("in", wide_pair<point::colour_sum>(stages.sums[0], stages.sums[1]));
  call.words("out",
             lanes<std::uint32_t, point::colour_feature, 2>({&stages.features[0], &stages.features[1]}));
  call.words("flags", local_maximum_flags(stages.sums, 0, 2));
}

void join_pairs(Call& call, const csim::Frame& /*frame*/, const Stages& stages) {
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

void store(Call& call, const csim::Frame& /*frame*/, const Stages& stages) {
  call.words("in", four<point::colour_feature>(stages.features));
  call.words("in_flags", local_maximum_flags(stages.sums, 0, 4));
  call.words("statistics", statistics_words(stages));
  call.words("maps_out", four<point::colour_feature>(stages.features));
  call.words("out", twice(four<point::colour_feature>(stages.features)));
}

// Three of the colour maps stand for the conspicuity maps: their flags are of the same sort.
void peaks(Call& call, const csim::Frame& /*frame*/, const Stages& stages) {
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

void gains(Call& call, const csim::Frame& /*frame*/, const Stages& stages) {
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

void normalise(Call& call, const csim::Frame& /*frame*/, const Stages& stages) {
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

void map_words(Call& call, const csim::FrontEndWords& words) {
  call.words("intensity_maps", words.intensity_maps);
  call.words("colour_maps", words.colour_maps);
  call.words("orientation_maps", words.orientation_maps);
  call.words("conspicuity_maps", words.conspicuity_maps);
  call.words("saliency", words.saliency);
  call.words("statistics", words.statistics);
}

void front_end(Call& call, const csim::Frame& frame, std::size_t beat, std::uint32_t /*number*/) {
  components(call, frame, beat);
  map_words(call, expected(frame));
}

// Every region that there is room for, whatever its saliency, so that the most is simulated.
constexpr ref::RegionParameters all_regions = {20, 0, 10};

void record(Call& call, const csim::Frame& frame, const ref::Model& model) {
  call.parameters(all_regions);
  call.words("record", expected_record(model, frame.width, frame.height, all_regions));
}

void signature(Call& call, const csim::Frame& frame, const Stages& /*stages*/) {
  const ref::Model model = ref::compute<Quantised>(view(frame));
  map_words(call, words_of(model));
  record(call, frame, model);
}

void signature_front_end(Call& call, const csim::Frame& frame, std::size_t beat, std::uint32_t /*number*/) {
  components(call, frame, beat);
  record(call, frame, ref::compute<Quantised>(view(frame)));
}

void memory(Call& call, const csim::Frame& frame, std::size_t beat, std::uint32_t tag) {
  const csim::FrontEndWords words = expected(frame);
  call.scalar("frame", tag);
  call.text_words("pixels", memory_beats(frame, beat));
  call.words("intensity_maps", words.intensity_maps);
  call.words("colour_maps", words.colour_maps);
  call.words("orientation_maps", words.orientation_maps);
  call.words("conspicuity_maps", words.conspicuity_maps);
  call.words("saliency", words.saliency);
  call.words("statistics", words.statistics);
  // Version alone of the report: its other words depend on the configuration.
  call.words("report", std::vector<std::uint32_t>{SAILMAP_MEMORY_VERSION});
}

void signature_memory(Call& call, const csim::Frame& frame, std::size_t beat, std::uint32_t tag) {
  call.scalar("frame", tag);
  call.text_words("pixels", memory_beats(frame, beat));
  record(call, frame, ref::compute<Quantised>(view(frame)));
  // As of the maps: version alone.
  call.words("report", std::vector<std::uint32_t>{SAILMAP_SIGNATURE_VERSION});
}

void axi(Call& call, const csim::Frame& frame, std::size_t beat, std::uint32_t frames) {
  const csim::FrontEndWords words = expected(frame);
  const auto row = static_cast<std::size_t>(hls::geometry::base_side(frame.width));
  call.packets("video", video(frame, beat), static_cast<std::size_t>(frame.width) / beat);
  call.packets("intensity_maps", words.intensity_maps, row);
  call.packets("colour_maps", words.colour_maps, row);
  call.packets("orientation_maps", words.orientation_maps, row);
  call.packets("conspicuity_maps", words.conspicuity_maps, row);
  call.packets("saliency", words.saliency, row);
  call.packets("statistics", words.statistics, words.statistics.size());
  // What a good frame writes: frames so far, then faults. `refused`, the last word, is not among it.
  call.words("status", std::vector<std::uint32_t>{frames, 0, 0, 0, 0, 0, 0});
}

using StageWriter = std::function<void(Call&, const csim::Frame&, const Stages&)>;
const std::map<std::string, StageWriter> stage_writers = {{"sailmap_channels", channels},
                                                          {"sailmap_reduce_lanes", reduce_lanes},
                                                          {"sailmap_reduce_pixels", reduce_pixels},
                                                          {"sailmap_delay_line", delay_line},
                                                          {"sailmap_centre_surround", centre_surround},
                                                          {"sailmap_orientation", orientation},
                                                          {"sailmap_across_scales", across_scales},
                                                          {"sailmap_local_maxima", local_maxima},
                                                          {"sailmap_join_pairs", join_pairs},
                                                          {"sailmap_store", store},
                                                          {"sailmap_peaks", peaks},
                                                          {"sailmap_gains", gains},
                                                          {"sailmap_normalise", normalise},
                                                          {"sailmap_signature", signature}};

std::vector<csim::Frame> three_frames() {
  std::mt19937 random(20);
  return {patches_frame(72, 64, random), noise_frame(64, 70, random), constant_frame(64, 64, 200, 30, 90)};
}

// Whole front ends, with the number of the frame from 1 on.
using WholeWriter = std::function<void(Call&, const csim::Frame&, std::size_t beat, std::uint32_t number)>;
const std::map<std::string, WholeWriter> whole_writers = {
    {"sailmap_front_end", front_end},
    {"sailmap_signature_front_end", signature_front_end},
    {"sailmap_axi", axi},
    {"sailmap_memory", memory},
    {"sailmap_signature_memory", signature_memory}};

void write(const std::string& top, std::size_t beat, const std::string& path,
           const std::vector<csim::Frame>& frames) {
  const auto stage = stage_writers.find(top);
  const auto whole = whole_writers.find(top);
  if (stage == stage_writers.end() && whole == whole_writers.end()) {
    throw std::runtime_error("unknown top " + top);
  }
  if (beat != 1 && beat != 2 && beat != 4 && beat != 8) throw std::runtime_error("a beat is 1, 2, 4 or 8");
  std::ofstream file(path);
  std::uint32_t count = 0;
  for (const csim::Frame& frame : frames) {
    Call call;
    ++count;
    if (top != "sailmap_gains") call.size(frame);
    if (whole != whole_writers.end()) {
      whole->second(call, frame, beat, count);
    } else {
      stage->second(call, frame, Stages(frame));
    }
    file << call.text();
  }
  if (!file.flush()) throw std::runtime_error(path + ": cannot be written");
}

}  // namespace
}  // namespace sailmap::testing

int main(int argc, char** argv) {
  try {
    if (argc < 4) throw std::runtime_error("usage: write_vectors TOP BEAT FILE [IMAGE.ppm...]");
    std::vector<sailmap::csim::Frame> frames;
    for (int i = 4; i < argc; ++i) frames.push_back(sailmap::testing::read_ppm(argv[i]));
    if (frames.empty()) frames = sailmap::testing::three_frames();
    sailmap::testing::write(argv[1], std::stoul(argv[2]), argv[3], frames);
    return 0;
  } catch (const std::exception& error) {
    std::cerr << "write_vectors: " << error.what() << '\n';
    return 1;
  }
}
