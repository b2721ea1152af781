// The reference with the hardware's arithmetic as a front end: the golden model of the kernels.
#include "sailmap/ref/quantised.hpp"

#include <cmath>

#include "fixed_maps.hpp"
#include "frontends.hpp"
#include "sailmap/ref/model.hpp"

namespace sailmap {
namespace {

// The reference's values are multiples of 2^-fraction in the format's unit.
template <class F>
typename F::native raw_of(double value) {
  return static_cast<typename F::native>(std::ldexp(value, F::fraction));
}

template <class F>
void store(const Plane<double>& values, Map& map) {
  const auto from = values.samples();
  const auto to = raw_samples<F>(map, values.width(), values.height()).samples();
  for (std::size_t i = 0; i < from.size(); ++i) to[i] = raw_of<F>(from[i]);
}

template <class F>
MapStatistics in_spec_units(const MapStatistics& statistics) {
  return statistics_of_raw<F>(raw_of<F>(statistics.maximum), static_cast<std::uint32_t>(statistics.maxima));
}

class Quantised : public Frontend {
 public:
  [[nodiscard]] std::string_view name() const override { return "quantised"; }

  void compute(const ImageView& image, Maps& maps) override {
    check_image_size(image);
    const ref::Model model = ref::compute<ref::Quantised>(image);
    maps.image_width = image.width;
    maps.image_height = image.height;
    for_each_feature_format([&]<class F>(F, std::size_t i) {
      store<F>(model.features[i], maps.features[i]);
      maps.feature_statistics[i] = in_spec_units<F>(model.feature_statistics[i]);
    });
    for_each_conspicuity_format([&]<class F>(F, std::size_t i) {
      store<F>(model.conspicuities[i], maps.conspicuities[i]);
      maps.conspicuity_statistics[i] = in_spec_units<F>(model.conspicuity_statistics[i]);
    });
    store<hls::formats::saliency>(model.saliency, maps.saliency);
  }
};

}  // namespace

std::unique_ptr<Frontend> make_quantised() { return std::make_unique<Quantised>(); }

}  // namespace sailmap
