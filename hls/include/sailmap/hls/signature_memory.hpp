// The front end and the signature between memory and memory, as one dataflow region and the report around it:
// a frame in, the 992 bytes of its signature out, no map leaves the chip.
//
// Ports: memory_registers.h says what lies where. Each port is read or written by one stage, in one burst a
// frame, and has an AXI master of its own. The record and the parameters are those of signature.hpp, with its
// formats and its maximum error; parameters come as 32 bits and count as the nearest within their limits. A
// size that Config does not take is refused: nothing is read, and nothing written but the report. Latency, as
// long as memory gives a beat of pixels a cycle: throughput::latency() and
// throughput::signature_after_frame(). II: that and the report, since the next start waits for this one's
// status.
#pragma once

#include "sailmap/hls/memory_kernel.hpp"
#include "sailmap/hls/memory_registers.h"
#include "sailmap/hls/signature_front_end.hpp"
#include "sailmap/hls/signature_record.hpp"

namespace sailmap {
namespace hls {

static_assert(signature_record::words == SAILMAP_RECORD_WORDS, "the shared header says how many there are");

// A register's number as the signature takes it; too large a one stays too large.
inline uint16_t saturated(uint32_t value) { return static_cast<uint16_t>(value < 0xffff ? value : 0xffff); }

// A region in a region: UG1399 ("Canonical Forms") lets a process of a dataflow region be one itself. In C
// simulation it is no stage but launches its stages, so it is called and not launched.
template <class Config>
void signature_memory_region(const memory_beat<Config::beat>* pixels, uint32_t* record_out, uint16_t width,
                             uint16_t height, uint16_t max_regions, uint32_t stop_ratio, uint16_t box_side) {
#pragma HLS dataflow
#include "sailmap/hls/region/0_pixels_in.inc"
  SAILMAP_STREAM(uint32_t, record);
  SignatureFrontEnd<Config>::run(red, green, blue, record, width, height, max_regions, stop_ratio, box_side);
  SAILMAP_STAGE((words_to_memory<Config, signature_record::words>), record, record_out);
}

template <class Config>
inline void signature_memory(const memory_beat<Config::beat>* pixels, uint32_t* record_out, uint32_t* report,
                             uint32_t width, uint32_t height, uint32_t frame, uint32_t max_regions,
                             uint32_t stop_ratio, uint32_t box_side) {
  if (!takes_frame<Config>(width, height)) {
    report_out<Config>(report, SAILMAP_SIGNATURE_VERSION, width, height, frame, 0);
    report[SAILMAP_REPORT_STATUS] = SAILMAP_STATUS_REFUSED;
    return;
  }
  report_out<Config>(report, SAILMAP_SIGNATURE_VERSION, width, height, frame, signature_record::words);
  signature_memory_region<Config>(pixels, record_out, static_cast<uint16_t>(width),
                                  static_cast<uint16_t>(height), saturated(max_regions), stop_ratio,
                                  saturated(box_side));
  report[SAILMAP_REPORT_STATUS] = SAILMAP_STATUS_DONE;
}

}  // namespace hls
}  // namespace sailmap
