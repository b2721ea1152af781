// Spec section 8: the ten-number descriptor of a region, and the signature of an image.
#include <array>

#include "chip_signature.hpp"
#include "sailmap/signature.hpp"

namespace sailmap {
namespace {

double ratio(double numerator, double denominator) { return denominator > 0 ? numerator / denominator : 0; }

// Eq. 3-4: v_i = mean of X~_i / mean of the conspicuity map of its kind, over the box.
Descriptor against_conspicuity(const Maps& maps, const Box& box) {
  std::array<double, conspicuity_count> conspicuity{};
  for (std::size_t kind = 0; kind < conspicuity_count; ++kind) {
    conspicuity[kind] = maps.conspicuities[kind].mean(box);
  }
  Descriptor v{};
  for (std::size_t i = 0; i < feature_count; ++i) {
    const double normalised_mean = maps.features[i].mean(box) * maps.feature_statistics[i].gain();
    v[i] = static_cast<float>(ratio(normalised_mean, conspicuity[kind_of_feature[i]]));
  }
  return v;
}

// Eq. 5: v_i = mean of X_i over the box / mean of X_i over the rest of the image.
Descriptor against_background(const Maps& maps, const Box& box) {
  const Box all{0, 0, maps.saliency.width(), maps.saliency.height()};
  const int outside_area = all.area() - box.area();
  Descriptor v{};
  for (std::size_t i = 0; i < feature_count; ++i) {
    const double inside = maps.features[i].mean(box);
    const double total = maps.features[i].mean(all) * all.area();
    const double outside = outside_area > 0 ? (total - inside * box.area()) / outside_area : 0;
    v[i] = static_cast<float>(ratio(inside, outside));
  }
  return v;
}

}  // namespace

Descriptor describe(const Maps& maps, const Box& box, DescriptorKind kind) {
  return kind == DescriptorKind::conspicuity ? against_conspicuity(maps, box) : against_background(maps, box);
}

Signature make_signature(const Maps& maps, const RegionConfig& config) {
  if (config.signature == SignatureMaker::chip) return chip_signature(maps, config);
  Signature signature{maps.image_width, maps.image_height, {}};
  const std::vector<Peak> peaks = find_peaks(maps.saliency, config);
  signature.regions.reserve(peaks.size());
  for (const Peak& peak : peaks) {
    const Box box = region_box(peak, config.box_side, maps.saliency.width(), maps.saliency.height());
    signature.regions.push_back({static_cast<std::int16_t>(peak.x * hls::geometry::base_scale),
                                 static_cast<std::int16_t>(peak.y * hls::geometry::base_scale),
                                 static_cast<float>(peak.saliency), describe(maps, box, config.descriptor)});
  }
  if (config.describe_place) signature.place = describe_place(maps);
  return signature;
}

}  // namespace sailmap
