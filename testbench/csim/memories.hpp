// The memories of the front end, one by one: the stages of region/*.inc and the arrays that each of them has.
#pragma once

#include <string>
#include <type_traits>
#include <vector>

#include "sailmap/hls/front_end.hpp"
#include "sailmap/hls/signature.hpp"

namespace sailmap::memories {

// `copies` arrays of `words` words of `bits` bits, each with one load and one store a cycle.
struct Memory {
  std::string what;
  int copies;
  int words;
  int bits;
};

constexpr int blocks(int number, int of) { return (number + of - 1) / of; }

// Block RAMs of 18 Kbit, two to a BRAM36, of AMD's devices from the 7 series on, for one array in the best of
// the shapes that they have.
constexpr int half_block_rams(int words, int bits) {
  int best = blocks(words, 16384) * bits;
  struct Shape {
    int words, bits;
  };
  for (const Shape shape : {Shape{8192, 2}, {4096, 4}, {2048, 9}, {1024, 18}, {512, 36}})
    best = std::min(best, blocks(words, shape.words) * blocks(bits, shape.bits));
  return best;
}

// LUTs for one array as distributed memory: four hold 64 words of three bits (RAM64M) or 32 of six (RAM32M).
constexpr int memory_luts(int words, int bits) {
  return words <= 32 ? 4 * blocks(bits, 6) : 4 * blocks(words, 64) * blocks(bits, 3);
}

// `bits`: of words that do not use all of theirs.
template <class Array>
Memory memory(std::string what, int copies = 1, int bits = 8 * sizeof(std::remove_extent_t<Array>)) {
  return {std::move(what), copies, static_cast<int>(std::extent_v<Array>), bits};
}

// Of the stages before the base level.
template <class Config>
void add_to_base(std::vector<Memory>& all) {
  using namespace hls;
  constexpr int channels = 5;
  constexpr int beat = Config::beat;
  all.push_back(memory<decltype(ReciprocalTable<0>::words)>("channels: reciprocals (ROM, two pixels each)",
                                                            beat == 1 ? 1 : beat / 2));
  if constexpr (beat == 1) {
    all.push_back(
        memory<decltype(ColumnSums<ReducePixels<Config, 0>, 0, 0>::sums)>("pyramid 0 to 1: sums", channels));
  } else {
    all.push_back(memory<decltype(ColumnSums<ReduceLanes<Config, 0, beat>, 0, 1>::sums)>(
        "pyramid 0 to 1: sums", channels * beat / 2));
  }
  if constexpr (beat <= 2) {
    all.push_back(
        memory<decltype(ColumnSums<ReducePixels<Config, 1>, 0, 0>::sums)>("pyramid 1 to 2: sums", channels));
  } else {
    all.push_back(memory<decltype(ColumnSums<ReduceLanes<Config, 1, beat / 2>, 0, 1>::sums)>(
        "pyramid 1 to 2: sums", channels * beat / 4));
  }
}

// Of one level with maps, but for what only some levels have.
template <class Config, int Level>
void add_level(std::vector<Memory>& all) {
  using namespace hls;
  using Stage = CentreSurround<Config, Level>;
  const std::string level = "level " + std::to_string(Level) + ": ";
  constexpr int channels = 5;
  all.push_back(memory<decltype(DelayMemory<Level, GaborDelay, uint16_t,
                                            (GaborDelay::rows + 1) * Config::level_width(Level)>::words)>(
      level + "delay of the intensity before Gabor"));
  all.push_back(memory<decltype(GaborRows<Config, Level>::newer)>(level + "rows of Gabor", 2));
  // Three of four segments of rows are equally long.
  all.push_back(
      memory<decltype(RowMemory<Stage, 1, uint16_t, to_small>::words)>(level + "rows of the intensity", 3));
  all.push_back(
      memory<decltype(RowMemory<Stage, 2, uint16_t, to_centre>::words)>(level + "rows of the intensity"));
  all.push_back(
      memory<decltype(RowMemory<Stage, 1, uint64_t, to_small>::words)>(level + "rows of the colours", 3));
  all.push_back(
      memory<decltype(RowMemory<Stage, 2, uint64_t, to_centre>::words)>(level + "rows of the colours"));
  all.push_back(memory<decltype(BoxColumns<Stage, 0>::sums)>(level + "sums of the columns", channels));
}

template <class Config, int Level>
void add_finer_level(std::vector<Memory>& all) {
  using namespace hls;
  const std::string level = "level " + std::to_string(Level) + ": ";
  using Delay = BranchDelay<Level>;
  constexpr int words = (Delay::rows + 1) * Config::level_width(Level);
  constexpr int channels = 5;
  constexpr int pairs = ori_90_135_pair + 1;
  all.push_back(
      memory<decltype(DelayMemory<Level, Delay, uint16_t, words>::words)>(level + "delay of the intensity"));
  all.push_back(
      memory<decltype(DelayMemory<Level, Delay, uint64_t, words>::words)>(level + "delay of the colours"));
  all.push_back(memory<decltype(ColumnSums<ReducePixels<Config, Level>, 0, 0>::sums)>(
      level + "sums of the reduction to the next", channels));
  all.push_back(memory<decltype(CoarseRow<Config, Level, 0>::words)>(level + "the coarser row", pairs));
}

template <class Config>
void add_stores(std::vector<Memory>& all) {
  using namespace hls;
  constexpr int buffers = Config::double_buffer ? 2 : 1;
  all.push_back(memory<decltype(MaximaRow<Config, 0>::words)>("local maxima: rows", orientation_pair + 1));
  all.push_back(memory<decltype(GainMemory<Config>::words)>("gains of the features"));
  using Pair = decltype(StoredPair<Config, 0, 0, 0>::words);
  all.push_back(memory<Pair>("store: two intensity maps", buffers, stored_pair_bits));
  all.push_back(memory<Pair>("store: two of four colour maps", 2 * buffers, stored_pair_bits));
  all.push_back(memory<Pair>("store: two of four orientation maps", 2 * buffers, stored_pair_bits));
  all.push_back(memory<decltype(PeakList<Config, 0>::values)>("local maxima of conspicuity",
                                                              geometry::conspicuity_maps));
}

template <class Config>
std::vector<Memory> of_front_end() {
  std::vector<Memory> all;
  add_to_base<Config>(all);
  add_finer_level<Config, 2>(all);
  add_finer_level<Config, 3>(all);
  add_level<Config, 2>(all);
  add_level<Config, 3>(all);
  add_level<Config, 4>(all);
  add_stores<Config>(all);
  return all;
}

// Of the signature, beside those of the front end.
template <class Config>
std::vector<Memory> of_signature() {
  using namespace hls;
  using Kept = KeptMaps<Config>;
  return {memory<decltype(Kept::intensity)>("signature: two intensity maps"),
          memory<decltype(Kept::colours)>("signature: four colour maps"),
          memory<decltype(Kept::orientations)>("signature: four orientation maps"),
          memory<decltype(Kept::conspicuity_low)>("signature: C_I and C_C"),
          memory<decltype(Kept::conspicuity_high)>("signature: C_O"),
          memory<decltype(KeptSaliency<Config>::words)>("signature: saliency"),
          memory<decltype(KeptSaliency<Config>::highest)>("signature: peaks of the rows"),
          memory<decltype(Kept::mantissas)>("signature: gains", 2),
          memory<decltype(FoundRegions<Config>::places)>("signature: places of the regions"),
          memory<decltype(FoundRegions<Config>::values)>("signature: saliency of the regions")};
}

}  // namespace sailmap::memories
