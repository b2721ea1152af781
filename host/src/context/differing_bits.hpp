// In how many bits some words differ from others, for many of them side by side: the inner loop of the method
// `context`, in the best instruction set of the processor at hand (Highway's dispatch at run time).
#pragma once

#include <cstddef>
#include <cstdint>

#include "simd/aligned_vector.hpp"

namespace sailmap::context {

// So many words for each of `lanes`; of a word the bits of its mask count.
struct BitRows {
  static constexpr std::size_t granule = 8;  // lanes come in so many, those not used have empty masks
  std::size_t lanes;
  AlignedVector<std::uint64_t> words;  // the first of all lanes, then the second ...
  AlignedVector<std::uint64_t> masks;

  BitRows(std::size_t words_of_a_lane, std::size_t used_lanes)
      : lanes((used_lanes + granule - 1) / granule * granule),
        words(words_of_a_lane * lanes),
        masks(words_of_a_lane * lanes) {}

  void set(std::size_t word, std::size_t lane, std::uint64_t bits, std::uint64_t mask) {
    words[word * lanes + lane] = bits;
    masks[word * lanes + lane] = mask;
  }
};

// For each lane of `rows` into `counts`: the bits in which its words differ from `words`, summed over those
// words whose bit is set in `which` (at most 32).
void differing_bits(const std::uint64_t* words, std::uint32_t which, const BitRows& rows,
                    std::uint64_t* counts);

}  // namespace sailmap::context
