// An image's signature, eq. 6: its salient regions, each with position, saliency and ten-number descriptor
// (spec 8).
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "sailmap/maps.hpp"
#include "sailmap/on_demand.hpp"
#include "sailmap/place_descriptor.hpp"

namespace sailmap {

// Single precision, and positions in 16 bits: a map of a million places holds twenty million regions of 48
// bytes, and the rounding (2^-24 of a number) is far below that of the fixed-point front ends.
using Descriptor = std::array<float, feature_count>;

struct Region {
  std::int16_t x = 0;  // level-0 pixels: base position times 4
  std::int16_t y = 0;
  float saliency = 0;  // S at the region's peak
  Descriptor descriptor{};
  bool operator==(const Region&) const = default;
};

// Regions by falling saliency.
struct Signature {
  int width = 0;  // of the image, level-0 pixels
  int height = 0;
  std::vector<Region> regions;
  OnDemand<PlaceDescriptor> place{};  // for the method `context`; empty unless RegionConfig asks for it
  bool operator==(const Signature&) const = default;
};

enum class Inhibition { box, disk, gaussian };
enum class DescriptorKind {
  conspicuity,  // eq. 3-4: against the conspicuity map of the feature's kind
  background    // eq. 5 (VOCUS): against the mean outside the box
};

enum class SignatureMaker {
  host,  // in floating point, from any maps
  chip   // what the signature kernel of the hardware says, bit for bit; check_chip_regions says what it does
};

struct RegionConfig {
  int max_regions = 20;      // 1 ..
  double stop_ratio = 0.25;  // stop when S <= MSR * stop_ratio; 0 ..  1
  int box_side = 10;         // region box, base-level pixels; 2 ..
  Inhibition inhibition = Inhibition::box;
  double inhibition_radius = 5;  // disk: radius; gaussian: sigma; base-level pixels; > 0
  DescriptorKind descriptor = DescriptorKind::conspicuity;
  SignatureMaker signature = SignatureMaker::host;
  bool describe_place = false;  // fill Signature::place too, which the method `context` compares
};

// The peak of one salient region, base-level pixels, and the saliency there.
struct Peak {
  int x = 0;
  int y = 0;
  double saliency = 0;
};

// [x - side/2, x + side/2) x [y - side/2, y + side/2), cut at the map's border.
Box region_box(const Peak& peak, int side, int map_width, int map_height);

// Repeated arg-max with inhibition of return (spec 8). Empty when S is 0 everywhere.
// Throws Error when the configuration is out of range.
std::vector<Peak> find_peaks(const Map& saliency, const RegionConfig& config);

// Eq. 3-4 or eq. 5 over the box.
Descriptor describe(const Maps& maps, const Box& box, DescriptorKind kind);

// Throws Error, naming the parameter, when the hardware makes no signatures so configured: it has the box,
// eq. 3-4, at most 20 regions of 2 to 16 pixels, a stop ratio that is a multiple of 2^-16, and no place
// descriptor, which needs the maps.
void check_chip_regions(const RegionConfig& config);

// Eq. 6: peaks, boxes and descriptors together. Throws Error when the configuration is out of range, or is
// for the hardware and the maps are not its raw integers.
Signature make_signature(const Maps& maps, const RegionConfig& config);

}  // namespace sailmap
