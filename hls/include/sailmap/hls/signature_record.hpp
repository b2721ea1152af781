// The signature of a frame as the hardware hands it out (spec 8, eq. 6): one packed record, the same for the
// kernel (signature.hpp), a host that reads it from a buffer, and bare metal.
//
// 248 words of 32 bits, 992 bytes, whatever the number of regions; little-endian in a host's memory. Words
// and fields that are not named are 0, and so are the regions behind the last one.
//
//   word        bits   what
//   0           31:16  0x534d, "SM": it is a signature
//               15:0   version of this layout, 1
//   1           31:16  height of the frame, level-0 pixels
//               15:0   width
//   2           7:0    regions found, 0 to 20
//   3           7:0    most regions asked for (the parameters of the frame: signature.hpp)
//   4           16:0   stop ratio asked for, raw
//   5           7:0    box side asked for, base-level pixels
//   6, 7               0
//   8 + 12 r           region r, by falling saliency:
//     + 0       31:16  y, level-0 pixels: base position times 4
//               15:0   x
//     + 1       15:0   S at the peak, raw in formats::saliency
//     + 2 + i   24:0   v_i, raw in formats::descriptor_entry; i in the order of spec section 6, 0 to 9
#pragma once

#include <cstdint>

#include "sailmap/hls/geometry.hpp"

namespace sailmap {
namespace hls {
namespace signature_record {

constexpr uint32_t mark_and_version = 0x534d0001;

constexpr int max_regions = 20;
constexpr int header_words = 8;
constexpr int region_words = 2 + geometry::feature_maps;
constexpr int words = header_words + max_regions * region_words;
constexpr int bytes = 4 * words;
static_assert(bytes <= 1228, "a signature is under 1.2 KiB a frame");

// Words of the header.
constexpr int mark_word = 0;
constexpr int size_word = 1;
constexpr int count_word = 2;
constexpr int max_regions_word = 3;
constexpr int stop_ratio_word = 4;
constexpr int box_side_word = 5;

// Of region r.
constexpr int position_word(int r) { return header_words + r * region_words; }
constexpr int saliency_word(int r) { return position_word(r) + 1; }
constexpr int entry_word(int r, int feature) { return position_word(r) + 2 + feature; }

// Two halves of a word, and the word of them: (width, height), (x, y).
constexpr uint32_t pair_of(uint32_t low, uint32_t high) { return low | high << 16; }
constexpr int low_of(uint32_t word) { return static_cast<int>(word & 0xffffU); }
constexpr int high_of(uint32_t word) { return static_cast<int>(word >> 16); }

// The parameters that a frame's signature is asked for with, and their limits; signature.hpp takes what lies
// outside for the nearest inside. Inhibition of return is the box, the descriptor eq. 3-4.
constexpr int max_box_side = 16;
constexpr int min_box_side = 2;
// stop_ratio is a multiple of 2^-16, 0 to 1.
constexpr int stop_ratio_fraction = 16;
constexpr uint32_t max_stop_ratio = uint32_t{1} << stop_ratio_fraction;

}  // namespace signature_record
}  // namespace hls
}  // namespace sailmap
