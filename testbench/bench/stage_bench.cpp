// The stages of the `fixed` front end, each alone: all that one frame asks of it.
#include <benchmark/benchmark.h>

#include <array>
#include <string>
#include <vector>

#include "bench_image.hpp"
#include "frontends/fixed/across_scales.hpp"
#include "frontends/fixed/centre_surround.hpp"
#include "frontends/fixed/channels.hpp"
#include "frontends/fixed/local_maxima.hpp"
#include "frontends/fixed/normalise.hpp"
#include "frontends/fixed/orientation.hpp"
#include "frontends/fixed/pyramid.hpp"
#include "sailmap/frontend.hpp"

namespace sailmap::bench {
namespace {

using namespace hls::geometry;
using Levels = std::array<fixed::PaddedPlane<std::int32_t>, map_levels>;
constexpr std::array channels = {fixed::intensity, fixed::green, fixed::blue, fixed::red, fixed::yellow};

// All stages' buffers, filled from the image as far as the stage wants them.
struct Stages {
  cv::Mat image;
  fixed::Pyramid pyramid;
  fixed::CentreSurround centre_surround;
  fixed::Orientation orientation;
  fixed::AcrossScales across_scales;
  std::array<Levels, orientation_maps> levels;
  fixed::SumPlane sums = fixed::make_sum_plane();
  Maps maps;
  std::vector<fixed::GainedMap> gained;

  explicit Stages(Size size) : image(image_of_size(size.width, size.height)) {
    make_frontend("fixed")->compute(view_of(image), maps);
    pyramid.compute(view_of(image));
    contrast(fixed::intensity);
    across_scales.compute(levels[0], sums, samples(maps.features[0]));
    for (std::size_t i = 0; i < feature_count; ++i) {
      const MapStatistics& statistics = maps.feature_statistics[i];
      gained.push_back({samples(maps.features[i]),
                        hls::gain(static_cast<std::uint32_t>(statistics.maximum / maps.features[i].lsb),
                                  static_cast<std::uint32_t>(statistics.maxima))});
    }
  }

  static std::uint16_t* samples(Map& map) {
    return std::get<Plane<std::uint16_t>>(map.samples).samples().data();
  }
  static std::size_t index_of(int level) { return static_cast<std::size_t>(level - base_level); }

  void contrast(fixed::Channel channel) {
    for (int level = base_level; level <= top_level; ++level) {
      const std::size_t l = index_of(level);
      centre_surround.compute(pyramid.plane(level, channel), levels[0][l],
                              channel == fixed::intensity ? &levels[1][l] : nullptr);
    }
  }
};

void all_channels(Stages& s) {
  static std::array<std::vector<fixed::Sample>, fixed::channel_count> rows;
  std::array<fixed::Sample*, fixed::channel_count> pointers{};
  for (std::size_t c = 0; c < rows.size(); ++c) {
    rows[c].resize(static_cast<std::size_t>(s.image.cols));
    pointers[c] = rows[c].data();
  }
  for (int y = 0; y < s.image.rows; ++y) fixed::channels(view_of(s.image), y, pointers);
}
void channels_and_pyramid(Stages& s) { s.pyramid.compute(view_of(s.image)); }
void all_contrasts(Stages& s) {
  for (const fixed::Channel channel : channels) s.contrast(channel);
}
void all_orientations(Stages& s) {
  for (int level = base_level; level <= top_level; ++level) {
    const std::size_t l = Stages::index_of(level);
    s.orientation.compute(s.pyramid.plane(level, fixed::intensity),
                          {&s.levels[0][l], &s.levels[1][l], &s.levels[2][l], &s.levels[3][l]});
  }
}
void all_scales(Stages& s) {
  // The same levels ten times: what they hold grows less with each, and takes as long.
  for (auto& feature : s.maps.features)
    s.across_scales.compute(s.levels[0], s.sums, Stages::samples(feature));
}
void all_local_maxima(Stages& s) {
  const int half = static_cast<int>(s.maps.feature_statistics[0].maximum / s.maps.features[0].lsb / 2);
  for (std::size_t i = 0; i < feature_count + conspicuity_count; ++i) {
    benchmark::DoNotOptimize(fixed::count_local_maxima(s.sums, half << 5));
  }
}
void all_normalisations(Stages& s) {
  const std::span<const fixed::GainedMap> maps = s.gained;
  fixed::intensity_conspicuity(maps.first(2), s.sums, Stages::samples(s.maps.conspicuities[0]));
  fixed::colour_conspicuity(maps.subspan(2, 4), s.sums, Stages::samples(s.maps.conspicuities[1]));
  fixed::orientation_conspicuity(maps.subspan(6, 4), s.sums, Stages::samples(s.maps.conspicuities[2]));
  fixed::saliency(maps.first(3), s.sums.width(), s.sums.height(), Stages::samples(s.maps.saliency));
}

// Numbers that a stage reads and writes at least: each input and each output once.
struct Traffic {
  double image;   // bytes a pixel of the image
  double levels;  // bytes a pixel of all levels from the base on
  double base;    // bytes a pixel of the base level
};
double bytes(const Traffic& traffic, Size size) {
  const auto pixels = [&](int level) {
    return static_cast<double>(((size.width - 1) >> level) + 1) * (((size.height - 1) >> level) + 1);
  };
  double levels = 0;
  for (int level = base_level; level <= top_level; ++level) levels += pixels(level);
  return traffic.image * pixels(0) + traffic.levels * levels + traffic.base * pixels(base_level);
}

struct Stage {
  const char* name;
  void (*run)(Stages&);
  Traffic traffic;
};

const bool registered = [] {
  constexpr double channel = 2;  // bytes of a sample: of a channel,
  constexpr double sum = 4;      // of a contrast or an exact sum,
  constexpr double map = 2;      // of a map
  const Stage stages[] = {
      {"channels", all_channels, {3 + 5 * channel, 0, 0}},
      {"channels_and_pyramid", channels_and_pyramid, {3 + 5 * channel * (1 + 1.0 / 4), 5 * channel, 0}},
      {"centre_surround", all_contrasts, {0, 5 * channel + 6 * sum, 0}},
      {"orientation", all_orientations, {0, channel + 4 * sum, 0}},
      {"across_scales", all_scales, {0, 10 * sum, 10 * (sum + map)}},
      {"local_maxima", all_local_maxima, {0, 0, 13 * sum}},
      {"normalise", all_normalisations, {0, 0, 13 * map + 3 * sum + 4 * map}}};
  for (const Size size : {vga, full_hd}) {
    for (const Stage& stage : stages) {
      const std::string full = "stage/" + std::string(stage.name) + "/" + size_name(size.width, size.height);
      benchmark::RegisterBenchmark(full.c_str(), [=](benchmark::State& state) {
        Stages s(size);
        for (auto _ : state) stage.run(s);
        state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(bytes(stage.traffic, size)));
      })->Unit(benchmark::kMicrosecond);
    }
  }
  return true;
}();

}  // namespace
}  // namespace sailmap::bench
