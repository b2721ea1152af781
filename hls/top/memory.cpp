#include "memory.hpp"

// Vitis links C names. Offsets of the registers are those of memory_registers.h, written out because a
// directive takes no constants of the language; testbench/vitis/link_test.py holds them together. In the flow
// for kernels that v++ links (SAILMAP_VITIS_KERNEL) the tool wants to choose them itself; XRT reads them from
// the xclbin.
extern "C" {
void sailmap_memory(const sailmap_memory_beat pixels[sailmap::top::frame_beats],
                    uint32_t intensity_maps[sailmap::top::map_words],
                    uint64_t colour_maps[sailmap::top::map_words],
                    uint64_t orientation_maps[sailmap::top::map_words],
                    uint64_t conspicuity_maps[sailmap::top::map_words],
                    uint16_t saliency[sailmap::top::map_words], uint32_t statistics[SAILMAP_STATISTICS_WORDS],
                    uint32_t report[SAILMAP_REPORT_WORDS], uint32_t width, uint32_t height, uint32_t frame) {
#pragma HLS interface mode = m_axi port = pixels bundle = gmem0 offset = slave
#pragma HLS interface mode = m_axi port = intensity_maps bundle = gmem1 offset = slave
#pragma HLS interface mode = m_axi port = colour_maps bundle = gmem2 offset = slave
#pragma HLS interface mode = m_axi port = orientation_maps bundle = gmem3 offset = slave
#pragma HLS interface mode = m_axi port = conspicuity_maps bundle = gmem4 offset = slave
#pragma HLS interface mode = m_axi port = saliency bundle = gmem5 offset = slave
#pragma HLS interface mode = m_axi port = statistics bundle = gmem6 offset = slave
#pragma HLS interface mode = m_axi port = report bundle = gmem7 offset = slave
#ifndef SAILMAP_VITIS_KERNEL
#pragma HLS interface mode = s_axilite port = pixels offset = 0x10
#pragma HLS interface mode = s_axilite port = intensity_maps offset = 0x1c
#pragma HLS interface mode = s_axilite port = colour_maps offset = 0x28
#pragma HLS interface mode = s_axilite port = orientation_maps offset = 0x34
#pragma HLS interface mode = s_axilite port = conspicuity_maps offset = 0x40
#pragma HLS interface mode = s_axilite port = saliency offset = 0x4c
#pragma HLS interface mode = s_axilite port = statistics offset = 0x58
#pragma HLS interface mode = s_axilite port = report offset = 0x64
#pragma HLS interface mode = s_axilite port = width offset = 0x70
#pragma HLS interface mode = s_axilite port = height offset = 0x78
#pragma HLS interface mode = s_axilite port = frame offset = 0x80
#pragma HLS interface mode = s_axilite port = return
#endif
  sailmap::hls::memory_front_end<sailmap::top::Config>(pixels, intensity_maps, colour_maps, orientation_maps,
                                                       conspicuity_maps, saliency, statistics, report, width,
                                                       height, frame);
}
}
