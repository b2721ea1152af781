// Tops: each kernel alone, on the level where it works hardest, for its own area and cycles. The streams are
// those of the stage's header.
#pragma once

#include <cstdint>

#include "configuration.hpp"
#include "sailmap/hls/stream.hpp"

void sailmap_channels(sailmap::hls::stream<uint32_t>& red, sailmap::hls::stream<uint32_t>& green,
                      sailmap::hls::stream<uint32_t>& blue, sailmap::hls::stream<uint64_t>& intensity_out,
                      sailmap::hls::stream<uint64_t>& green_out, sailmap::hls::stream<uint64_t>& blue_out,
                      sailmap::hls::stream<uint64_t>& red_out, sailmap::hls::stream<uint64_t>& yellow_out,
                      uint16_t width, uint16_t height);
void sailmap_reduce_lanes(sailmap::hls::stream<uint64_t>& in, sailmap::hls::stream<uint32_t>& out,
                          uint16_t width, uint16_t height);
void sailmap_reduce_pixels(sailmap::hls::stream<uint16_t>& intensity, sailmap::hls::stream<uint64_t>& colours,
                           sailmap::hls::stream<uint16_t>& intensity_out,
                           sailmap::hls::stream<uint64_t>& colours_out, uint16_t width, uint16_t height);
void sailmap_delay_line(sailmap::hls::stream<uint64_t>& in, sailmap::hls::stream<uint64_t>& out,
                        uint16_t width, uint16_t height);
void sailmap_centre_surround(sailmap::hls::stream<uint16_t>& intensity,
                             sailmap::hls::stream<uint64_t>& colours, sailmap::hls::stream<uint64_t>& on_off,
                             sailmap::hls::stream<uint64_t>& green_blue,
                             sailmap::hls::stream<uint64_t>& red_yellow, uint16_t width, uint16_t height);
void sailmap_orientation(sailmap::hls::stream<uint16_t>& intensity, sailmap::hls::stream<uint64_t>& ori_0_45,
                         sailmap::hls::stream<uint64_t>& ori_90_135, uint16_t width, uint16_t height);
void sailmap_across_scales(sailmap::hls::stream<uint64_t>& coarse, sailmap::hls::stream<uint64_t>& fine,
                           sailmap::hls::stream<uint64_t>& out, uint16_t width, uint16_t height);
void sailmap_local_maxima(sailmap::hls::stream<uint64_t>& in, sailmap::hls::stream<uint32_t>& out,
                          sailmap::hls::stream<uint8_t>& flags, uint16_t width, uint16_t height);
void sailmap_join_pairs(sailmap::hls::stream<uint32_t>& low, sailmap::hls::stream<uint8_t>& low_flags,
                        sailmap::hls::stream<uint32_t>& high, sailmap::hls::stream<uint8_t>& high_flags,
                        sailmap::hls::stream<uint64_t>& out, sailmap::hls::stream<uint8_t>& flags,
                        uint16_t width, uint16_t height);
void sailmap_store(sailmap::hls::stream<uint64_t>& in, sailmap::hls::stream<uint8_t>& in_flags,
                   sailmap::hls::stream<uint32_t>& statistics, sailmap::hls::stream<uint64_t>& maps_out,
                   sailmap::hls::stream<uint64_t>& out, uint16_t width, uint16_t height);
void sailmap_gains(sailmap::hls::stream<uint32_t>& intensity, sailmap::hls::stream<uint32_t>& colour,
                   sailmap::hls::stream<uint32_t>& orientation,
                   sailmap::hls::stream<uint32_t>& statistics_out,
                   sailmap::hls::stream<uint32_t>& intensity_gains,
                   sailmap::hls::stream<uint32_t>& colour_gains,
                   sailmap::hls::stream<uint32_t>& orientation_gains);
void sailmap_normalise(sailmap::hls::stream<uint32_t>& gains, sailmap::hls::stream<uint64_t>& maps,
                       sailmap::hls::stream<uint32_t>& sum_out, uint16_t width, uint16_t height);
void sailmap_peaks(sailmap::hls::stream<uint64_t>& in, sailmap::hls::stream<uint8_t>& in_flags,
                   sailmap::hls::stream<uint32_t>& statistics, sailmap::hls::stream<uint64_t>& maps_out,
                   sailmap::hls::stream<uint64_t>& out, uint16_t width, uint16_t height);
void sailmap_signature(sailmap::hls::stream<uint32_t>& intensity_maps,
                       sailmap::hls::stream<uint64_t>& colour_maps,
                       sailmap::hls::stream<uint64_t>& orientation_maps,
                       sailmap::hls::stream<uint64_t>& conspicuity_maps,
                       sailmap::hls::stream<uint16_t>& saliency, sailmap::hls::stream<uint32_t>& statistics,
                       sailmap::hls::stream<uint32_t>& record, uint16_t width, uint16_t height,
                       uint16_t max_regions, uint32_t stop_ratio, uint16_t box_side);
