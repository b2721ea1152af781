// Frames' maps through the signature kernel in C simulation, one after the other without a pause.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "expected_signature.hpp"
#include "sailmap/hls/signature.hpp"
#include "stage_run.hpp"

namespace sailmap::testing {

// One frame's maps, with what the signature is asked for.
struct SignatureCall {
  int width;
  int height;
  ref::Model model;
  ref::RegionParameters parameters;

  [[nodiscard]] std::vector<std::uint32_t> expected() const {
    return expected_record(model, width, height, parameters);
  }
};

inline SignatureCall call_of(const csim::Frame& frame, const ref::RegionParameters& parameters = {}) {
  return {frame.width, frame.height, ref::compute<ref::Quantised>(view(frame)), parameters};
}

template <class T>
void append(std::vector<T>& all, const std::vector<T>& more) {
  all.insert(all.end(), more.begin(), more.end());
}

// The records, 248 words a call.
template <class Config>
std::vector<std::uint32_t> simulated_records(const std::vector<SignatureCall>& calls) {
  csim::FrontEndWords in;
  for (const SignatureCall& call : calls) {
    const csim::FrontEndWords words = words_of(call.model);
    append(in.intensity_maps, words.intensity_maps);
    append(in.colour_maps, words.colour_maps);
    append(in.orientation_maps, words.orientation_maps);
    append(in.conspicuity_maps, words.conspicuity_maps);
    append(in.saliency, words.saliency);
    append(in.statistics, words.statistics);
  }
  StageRun run;
  std::vector<std::uint32_t> records;
  auto& intensity_maps = run.feed(in.intensity_maps);
  auto& colour_maps = run.feed(in.colour_maps);
  auto& orientation_maps = run.feed(in.orientation_maps);
  auto& conspicuity_maps = run.feed(in.conspicuity_maps);
  auto& saliency = run.feed(in.saliency);
  auto& statistics = run.feed(in.statistics);
  auto& record = run.take(248 * calls.size(), records);
  for (const SignatureCall& call : calls) {
    SAILMAP_STAGE((hls::signature<Config>), intensity_maps, colour_maps, orientation_maps, conspicuity_maps,
                  saliency, statistics, record, static_cast<std::uint16_t>(call.width),
                  static_cast<std::uint16_t>(call.height),
                  static_cast<std::uint16_t>(call.parameters.max_regions),
                  static_cast<std::uint32_t>(std::lround(65536 * call.parameters.stop_ratio)),
                  static_cast<std::uint16_t>(call.parameters.box_side));
  }
  run.run();
  return records;
}

inline std::vector<std::uint32_t> expected_records(const std::vector<SignatureCall>& calls) {
  std::vector<std::uint32_t> records;
  for (const SignatureCall& call : calls) append(records, call.expected());
  return records;
}

// Regions found in each of the records.
inline std::vector<int> regions_found(const std::vector<std::uint32_t>& records) {
  std::vector<int> found;
  for (std::size_t i = 2; i < records.size(); i += 248) found.push_back(static_cast<int>(records[i]));
  return found;
}

}  // namespace sailmap::testing
