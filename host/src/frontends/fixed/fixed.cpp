// The fast front end: the hardware's integers, several at a time, bit for bit those of `quantised`.
#include <array>
#include <span>

#include "../fixed_maps.hpp"
#include "../frontends.hpp"
#include "across_scales.hpp"
#include "centre_surround.hpp"
#include "local_maxima.hpp"
#include "normalise.hpp"
#include "orientation.hpp"
#include "pyramid.hpp"

namespace sailmap {
namespace {

namespace formats = hls::formats;
using namespace hls::geometry;

// A map as eq. 1 sees it: raw maximum and m.
struct RawStatistics {
  std::uint32_t maximum = 0;
  std::uint32_t maxima = 0;
};

// `largest`: of the sums.
template <class Sum, class Stored>
RawStatistics statistics_of(const fixed::SumPlane& sums, std::int32_t largest) {
  const std::uint32_t maximum = hls::requantise<Sum, Stored>(static_cast<std::uint32_t>(largest));
  if (maximum == 0) return {};
  return {maximum, fixed::count_local_maxima(sums, fixed::least_above_half<Sum, Stored>(maximum))};
}

class Fixed : public Frontend {
 public:
  [[nodiscard]] std::string_view name() const override { return "fixed"; }

  void compute(const ImageView& image, Maps& maps) override {
    check_image_size(image);
    maps.image_width = image.width;
    maps.image_height = image.height;
    width_ = base_side(image.width);
    height_ = base_side(image.height);
    pyramid_.compute(image);
    intensity_features(maps);
    colour_features(maps);
    orientation_features(maps);
    conspicuities(maps);
    fixed::saliency(conspicuity_gains_, width_, height_, samples_of<formats::saliency>(maps.saliency));
  }

 private:
  using Levels = std::array<fixed::PaddedPlane<std::int32_t>, map_levels>;

  [[nodiscard]] static constexpr std::size_t index_of(int level) {
    return static_cast<std::size_t>(level - base_level);
  }

  template <class F>
  std::uint16_t* samples_of(Map& map) const {
    return raw_samples<F>(map, width_, height_).samples().data();
  }

  // Feature map `index` from its levels.
  template <class Sum, class Feature>
  void feature(Levels& levels, std::size_t index, Maps& maps) {
    std::uint16_t* samples = samples_of<Feature>(maps.features[index]);
    const std::int32_t largest = across_scales_.compute(levels, sums_, samples);
    const RawStatistics raw = statistics_of<Sum, Feature>(sums_, largest);
    maps.feature_statistics[index] = statistics_of_raw<Feature>(raw.maximum, raw.maxima);
    feature_gains_[index] = {samples, hls::gain(raw.maximum, raw.maxima)};
  }

  void intensity_features(Maps& maps) {
    for (int level = base_level; level <= top_level; ++level) {
      const std::size_t l = index_of(level);
      centre_surround_.compute(pyramid_.plane(level, fixed::intensity), levels_[0][l], &levels_[1][l]);
    }
    for (std::size_t i = 0; i < intensity_maps; ++i) {
      feature<formats::intensity_sum, formats::intensity_feature>(levels_[i], i, maps);
    }
  }

  void colour_features(Maps& maps) {
    std::size_t index = intensity_maps;
    for (const auto channel : {fixed::green, fixed::blue, fixed::red, fixed::yellow}) {
      for (int level = base_level; level <= top_level; ++level) {
        centre_surround_.compute(pyramid_.plane(level, channel), levels_[0][index_of(level)], nullptr);
      }
      feature<formats::colour_sum, formats::colour_feature>(levels_[0], index++, maps);
    }
  }

  void orientation_features(Maps& maps) {
    for (int level = base_level; level <= top_level; ++level) {
      const std::size_t l = index_of(level);
      orientation_.compute(pyramid_.plane(level, fixed::intensity),
                           {&levels_[0][l], &levels_[1][l], &levels_[2][l], &levels_[3][l]});
    }
    for (std::size_t i = 0; i < orientation_maps; ++i) {
      feature<formats::orientation_sum, formats::orientation_feature>(levels_[i],
                                                                      intensity_maps + colour_maps + i, maps);
    }
  }

  // The conspicuity map of one kind, whose feature maps are `count` from `first`.
  template <class Sum, class Stored, class Compute>
  void conspicuity(std::size_t kind, std::size_t first, std::size_t count, const Compute& compute,
                   Maps& maps) {
    std::uint16_t* samples = samples_of<Stored>(maps.conspicuities[kind]);
    const std::int32_t largest =
        compute(std::span<const fixed::GainedMap>(feature_gains_).subspan(first, count), sums_, samples);
    const RawStatistics raw = statistics_of<Sum, Stored>(sums_, largest);
    maps.conspicuity_statistics[kind] = statistics_of_raw<Stored>(raw.maximum, raw.maxima);
    conspicuity_gains_[kind] = {samples, hls::gain(raw.maximum, raw.maxima)};
  }

  void conspicuities(Maps& maps) {
    using namespace formats;
    conspicuity<intensity_conspicuity_sum, intensity_conspicuity>(0, 0, intensity_maps,
                                                                  fixed::intensity_conspicuity, maps);
    conspicuity<colour_conspicuity_sum, colour_conspicuity>(1, intensity_maps, colour_maps,
                                                            fixed::colour_conspicuity, maps);
    conspicuity<orientation_conspicuity_sum, orientation_conspicuity>(
        2, intensity_maps + colour_maps, orientation_maps, fixed::orientation_conspicuity, maps);
  }

  int width_ = 0;  // of the maps
  int height_ = 0;
  fixed::Pyramid pyramid_;
  fixed::CentreSurround centre_surround_;
  fixed::Orientation orientation_;
  fixed::AcrossScales across_scales_;
  // Contrasts or energies of as many maps as are computed together.
  std::array<Levels, orientation_maps> levels_;
  fixed::SumPlane sums_ = fixed::make_sum_plane();
  std::array<fixed::GainedMap, feature_count> feature_gains_{};
  std::array<fixed::GainedMap, conspicuity_count> conspicuity_gains_{};
};

}  // namespace

std::unique_ptr<Frontend> make_fixed() { return std::make_unique<Fixed>(); }

}  // namespace sailmap
