// The kernels between memory and memory over the C simulation of their regions.
#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <vector>

#include "sailmap/csim/signature.hpp"
#include "sailmap/csim/simulate.hpp"
#include "simulated_device.hpp"

namespace sailmap::fpga {
namespace {

bool takes(const KernelLimits& limits, const Call& call) {
  using hls::geometry::min_image_side;
  return call.width >= min_image_side && call.height >= min_image_side && call.width <= limits.max_width &&
         call.height <= limits.max_height && call.width % limits.beat == 0;
}

csim::Frame frame_of(std::span<const std::byte> pixels, const Call& call) {
  csim::Frame frame{static_cast<int>(call.width), static_cast<int>(call.height), {}};
  const std::size_t count = std::size_t{call.width} * call.height;
  frame.rgb.reserve(3 * count);
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t component = 0; component < 3; ++component) {
      frame.rgb.push_back(std::to_integer<std::uint8_t>(pixels[SAILMAP_PIXEL_BYTES * i + component]));
    }
  }
  return frame;
}

template <class Word>
void put(Slot& slot, Buffer buffer, const std::vector<Word>& words) {
  std::memcpy(slot.memory(buffer).data(), words.data(), words.size() * sizeof(Word));
}

void put_maps(Slot& slot, const csim::FrontEndWords& words) {
  put(slot, Buffer::intensity_maps, words.intensity_maps);
  put(slot, Buffer::colour_maps, words.colour_maps);
  put(slot, Buffer::orientation_maps, words.orientation_maps);
  put(slot, Buffer::conspicuity_maps, words.conspicuity_maps);
  put(slot, Buffer::saliency, words.saliency);
  put(slot, Buffer::statistics, words.statistics);
}

// As a kernel takes 32 bits for a parameter of 16.
std::uint16_t saturated(std::uint32_t value) {
  return static_cast<std::uint16_t>(std::min<std::uint32_t>(value, UINT16_MAX));
}

// The output of a frame that the kernel takes; how many words it has.
std::size_t put_output(const KernelInterface& kernel, Slot& slot, const Call& call, int beat) {
  const std::array<csim::Frame, 1> frames = {frame_of(slot.memory(Buffer::pixels), call)};
  csim::Scheduler scheduler;
  if (kernel == maps_kernel) {
    const auto words = csim::simulate(frames, beat, scheduler).front();
    put_maps(slot, words);
    return words.saliency.size();
  }
  const auto record =
      csim::simulate_records(
          frames, beat, {saturated(call.max_regions), call.stop_ratio, saturated(call.box_side)}, scheduler)
          .front();
  put(slot, Buffer::record, record);
  return record.size();
}

}  // namespace

void run_kernel(const KernelInterface& kernel, Slot& slot, const Call& call, const KernelLimits& limits) {
  std::vector<std::uint32_t> report(SAILMAP_REPORT_WORDS);
  report[SAILMAP_REPORT_VERSION] = kernel.version;
  report[SAILMAP_REPORT_MAX_WIDTH] = limits.max_width;
  report[SAILMAP_REPORT_MAX_HEIGHT] = limits.max_height;
  report[SAILMAP_REPORT_BEAT] = limits.beat;
  report[SAILMAP_REPORT_MIN_SIDE] = hls::geometry::min_image_side;
  report[SAILMAP_REPORT_WIDTH] = call.width;
  report[SAILMAP_REPORT_HEIGHT] = call.height;
  report[SAILMAP_REPORT_FRAME] = call.frame;
  report[SAILMAP_REPORT_STATUS] = SAILMAP_STATUS_REFUSED;
  if (takes(limits, call)) {
    const std::size_t words = put_output(kernel, slot, call, static_cast<int>(limits.beat));
    report[SAILMAP_REPORT_OUTPUT_WORDS] = static_cast<std::uint32_t>(words);
    report[SAILMAP_REPORT_STATUS] = SAILMAP_STATUS_DONE;
  }
  put(slot, Buffer::report, report);
}

}  // namespace sailmap::fpga
