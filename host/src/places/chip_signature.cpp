#include "chip_signature.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <variant>

#include "sailmap/error.hpp"
#include "sailmap/hls/signature_arithmetic.hpp"
#include "sailmap/hls/signature_record.hpp"

namespace sailmap {
namespace {

namespace record = hls::signature_record;
using hls::formats::descriptor_entry;

// Exact, as the kernel's: at most 256 samples of 16 bits.
std::uint32_t raw_sum(const Map& map, const Box& box) {
  const auto* plane = std::get_if<Plane<std::uint16_t>>(&map.samples);
  if (plane == nullptr) throw Error("signature on the chip: the maps are not the hardware's integers");
  std::uint32_t sum = 0;
  for (int y = box.y0; y < box.y1; ++y) {
    for (int x = box.x0; x < box.x1; ++x) sum += (*plane)(x, y);
  }
  return sum;
}

hls::Gain gain_of(const Map& map, const MapStatistics& statistics) {
  return hls::gain(static_cast<std::uint32_t>(std::lround(statistics.maximum / map.lsb)),
                   static_cast<std::uint32_t>(statistics.maxima));
}

// What divides the entries of each kind.
std::array<std::uint32_t, conspicuity_count> divisors(const Maps& maps, const Box& box) {
  using namespace hls::formats;
  return {hls::entry_divisor<intensity_conspicuity_region_sum>(raw_sum(maps.conspicuities[0], box)),
          hls::entry_divisor<colour_conspicuity_region_sum>(raw_sum(maps.conspicuities[1], box)),
          hls::entry_divisor<orientation_conspicuity_region_sum>(raw_sum(maps.conspicuities[2], box))};
}

using Gains = std::array<hls::Gain, feature_count>;

Descriptor descriptor_of(const Maps& maps, const Gains& gains, const Box& box) {
  const auto divisor = divisors(maps, box);
  Descriptor v{};
  for (std::size_t i = 0; i < feature_count; ++i) {
    const std::uint64_t normalised = hls::normalised_region_sum(raw_sum(maps.features[i], box), gains[i]);
    const std::uint32_t entry = hls::descriptor_entry(normalised, divisor[kind_of_feature[i]]);
    v[i] = std::ldexp(static_cast<float>(entry), -descriptor_entry::fraction);
  }
  return v;
}

}  // namespace

void check_chip_regions(const RegionConfig& config) {
  const auto demand = [](bool holds, const std::string& fault) {
    if (!holds) throw Error("signature on the chip: " + fault);
  };
  demand(config.inhibition == Inhibition::box, "inhibition of return is the box there");
  demand(config.descriptor == DescriptorKind::conspicuity, "the descriptor is eq. 3-4 (conspicuity) there");
  demand(!config.describe_place, "the method context needs the maps, which stay there");
  demand(config.max_regions >= 1 && config.max_regions <= record::max_regions,
         fmt::format("max_regions must be 1 to {}", record::max_regions));
  demand(config.box_side >= record::min_box_side && config.box_side <= record::max_box_side,
         fmt::format("box_side must be {} to {}", record::min_box_side, record::max_box_side));
  demand(config.stop_ratio >= 0 && config.stop_ratio <= 1, "stop_ratio must be within 0 and 1");
  const double raw = config.stop_ratio * record::max_stop_ratio;
  demand(raw == std::round(raw),
         fmt::format("stop_ratio must be a multiple of 1/{}, such as {}", record::max_stop_ratio,
                     std::round(raw) / record::max_stop_ratio));
}

Signature chip_signature(const Maps& maps, const RegionConfig& config) {
  check_chip_regions(config);
  Gains gains{};
  for (std::size_t i = 0; i < feature_count; ++i) {
    gains[i] = gain_of(maps.features[i], maps.feature_statistics[i]);
  }
  Signature signature{maps.image_width, maps.image_height, {}};
  // The host's search: raw integers times a power of two, and a ratio of 17 bits, are exact in a double.
  for (const Peak& peak : find_peaks(maps.saliency, config)) {
    const Box box = region_box(peak, config.box_side, maps.saliency.width(), maps.saliency.height());
    signature.regions.push_back({static_cast<std::int16_t>(peak.x * hls::geometry::base_scale),
                                 static_cast<std::int16_t>(peak.y * hls::geometry::base_scale),
                                 static_cast<float>(peak.saliency), descriptor_of(maps, gains, box)});
  }
  return signature;
}

}  // namespace sailmap
