#include <mutex>
#include <stdexcept>

#include "largest.hpp"
#include "sailmap/csim/signature.hpp"
#include "sailmap/csim/stream.hpp"
#include "sailmap/hls/signature.hpp"

namespace sailmap::csim {
namespace {

using Config = Largest<1>;

void check(const FrontEndWords& words, int width, int height) {
  const auto pixels =
      static_cast<std::size_t>(hls::geometry::base_side(width) * hls::geometry::base_side(height));
  const bool whole = Config::takes(width, height) && words.intensity_maps.size() == pixels &&
                     words.colour_maps.size() == pixels && words.orientation_maps.size() == pixels &&
                     words.conspicuity_maps.size() == pixels && words.saliency.size() == pixels &&
                     words.statistics.size() == hls::statistics_words;
  if (!whole) throw std::invalid_argument("not the maps of a frame of that size");
}

template <class T>
void feed(Scheduler& scheduler, Stream<T>& stream, const std::vector<T>& words) {
  scheduler.launch("source of " + stream.name(), {&stream}, [&stream, &words] {
    for (const T word : words) stream.write(word);
  });
}

}  // namespace

std::vector<std::uint32_t> simulate_signature(const FrontEndWords& words, int width, int height,
                                              const SignatureParameters& parameters, Scheduler& scheduler) {
  const std::lock_guard lock(one_at_a_time());
  check(words, width, height);
  Stream<std::uint32_t> intensity_maps("intensity_maps");
  Stream<std::uint64_t> colour_maps("colour_maps");
  Stream<std::uint64_t> orientation_maps("orientation_maps");
  Stream<std::uint64_t> conspicuity_maps("conspicuity_maps");
  Stream<std::uint16_t> saliency("saliency");
  Stream<std::uint32_t> statistics("statistics");
  Stream<std::uint32_t> record("record");
  feed(scheduler, intensity_maps, words.intensity_maps);
  feed(scheduler, colour_maps, words.colour_maps);
  feed(scheduler, orientation_maps, words.orientation_maps);
  feed(scheduler, conspicuity_maps, words.conspicuity_maps);
  feed(scheduler, saliency, words.saliency);
  feed(scheduler, statistics, words.statistics);
  SAILMAP_STAGE((hls::signature<Config>), intensity_maps, colour_maps, orientation_maps, conspicuity_maps,
                saliency, statistics, record, static_cast<std::uint16_t>(width),
                static_cast<std::uint16_t>(height), parameters.max_regions, parameters.stop_ratio,
                parameters.box_side);
  std::vector<std::uint32_t> out(hls::signature_record::words);
  scheduler.launch("sink of record", {&record}, [&record, &out] {
    for (std::uint32_t& word : out) word = record.read();
  });
  scheduler.run();
  return out;
}

Records simulate_records(std::span<const Frame> frames, int beat, const SignatureParameters& parameters,
                         Scheduler& scheduler) {
  return with_largest(beat, [&]<class Config>(Config) {
    return run_signature_front_end<Config>(frames, parameters, scheduler);
  });
}

}  // namespace sailmap::csim
