// The record that the hardware must put out for a frame's maps, computed by the quantised reference.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "expected.hpp"
#include "sailmap/ref/signature.hpp"

namespace sailmap::testing {

// The words as signature_record.hpp describes them, written out once more: none of its code is used.
inline std::vector<std::uint32_t> expected_record(const ref::Model& model, int width, int height,
                                                  const ref::RegionParameters& parameters) {
  const std::vector<ref::SalientRegion> regions = ref::salient_regions<ref::Quantised>(model, parameters);
  std::vector<std::uint32_t> words = {0x534d0001,
                                      static_cast<std::uint32_t>(width + 65536 * height),
                                      static_cast<std::uint32_t>(regions.size()),
                                      static_cast<std::uint32_t>(parameters.max_regions),
                                      static_cast<std::uint32_t>(std::lround(65536 * parameters.stop_ratio)),
                                      static_cast<std::uint32_t>(parameters.box_side),
                                      0,
                                      0};
  for (const ref::SalientRegion& region : regions) {
    words.push_back(static_cast<std::uint32_t>(4 * region.x + 65536 * 4 * region.y));
    words.push_back(static_cast<std::uint32_t>(raw<ref::point::saliency>(region.saliency)));
    for (const double v : region.descriptor) {
      words.push_back(static_cast<std::uint32_t>(raw<ref::point::descriptor_entry>(v)));
    }
  }
  words.resize(248);
  return words;
}

}  // namespace sailmap::testing
