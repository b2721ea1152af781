// The words of the whole front ends and of the signature, from the reference; no kernel code takes part.
#include <cstdint>
#include <vector>

#include "csim/expected.hpp"
#include "csim/expected_signature.hpp"
#include "sailmap/hls/memory_registers.h"
#include "writers.hpp"

namespace sailmap::testing {
namespace {

using ref::Quantised;

void map_words(Call& call, const csim::FrontEndWords& words) {
  call.words("intensity_maps", words.intensity_maps);
  call.words("colour_maps", words.colour_maps);
  call.words("orientation_maps", words.orientation_maps);
  call.words("conspicuity_maps", words.conspicuity_maps);
  call.words("saliency", words.saliency);
  call.words("statistics", words.statistics);
}

void front_end(Call& call, const csim::Frame& frame, std::size_t beat, std::uint32_t /*number*/) {
  components(call, frame, beat);
  map_words(call, expected(frame));
}

// Every region that there is room for, whatever its saliency, so that the most is simulated.
constexpr ref::RegionParameters all_regions = {20, 0, 10};

void record(Call& call, const csim::Frame& frame, const ref::Model& model) {
  call.parameters(all_regions);
  call.words("record", expected_record(model, frame.width, frame.height, all_regions));
}

void signature(Call& call, const csim::Frame& frame, std::size_t /*beat*/, std::uint32_t /*number*/) {
  const ref::Model model = ref::compute<Quantised>(view(frame));
  map_words(call, words_of(model));
  record(call, frame, model);
}

void signature_front_end(Call& call, const csim::Frame& frame, std::size_t beat, std::uint32_t /*number*/) {
  components(call, frame, beat);
  record(call, frame, ref::compute<Quantised>(view(frame)));
}

void memory(Call& call, const csim::Frame& frame, std::size_t beat, std::uint32_t tag) {
  call.scalar("frame", tag);
  call.text_words("pixels", memory_beats(frame, beat));
  map_words(call, expected(frame));
  // Version alone of the report: its other words depend on the configuration.
  call.words("report", std::vector<std::uint32_t>{SAILMAP_MEMORY_VERSION});
}

void signature_memory(Call& call, const csim::Frame& frame, std::size_t beat, std::uint32_t tag) {
  call.scalar("frame", tag);
  call.text_words("pixels", memory_beats(frame, beat));
  record(call, frame, ref::compute<Quantised>(view(frame)));
  // As of the maps: version alone.
  call.words("report", std::vector<std::uint32_t>{SAILMAP_SIGNATURE_VERSION});
}

void axi(Call& call, const csim::Frame& frame, std::size_t beat, std::uint32_t frames) {
  const csim::FrontEndWords words = expected(frame);
  const auto row = static_cast<std::size_t>(hls::geometry::base_side(frame.width));
  call.packets("video", video(frame, beat), static_cast<std::size_t>(frame.width) / beat);
  call.packets("intensity_maps", words.intensity_maps, row);
  call.packets("colour_maps", words.colour_maps, row);
  call.packets("orientation_maps", words.orientation_maps, row);
  call.packets("conspicuity_maps", words.conspicuity_maps, row);
  call.packets("saliency", words.saliency, row);
  call.packets("statistics", words.statistics, words.statistics.size());
  // What a good frame writes: frames so far, then faults. `refused`, the last word, is not among it.
  call.words("status", std::vector<std::uint32_t>{frames, 0, 0, 0, 0, 0, 0});
}

}  // namespace

Writers front_end_writers() {
  return {{"sailmap_front_end", front_end},
          {"sailmap_signature", signature},
          {"sailmap_signature_front_end", signature_front_end},
          {"sailmap_axi", axi},
          {"sailmap_memory", memory},
          {"sailmap_signature_memory", signature_memory}};
}

}  // namespace sailmap::testing
