#include "signature_memory.hpp"

#include "sailmap/hls/signature_memory.hpp"

// As in memory.cpp: a C name, and the offsets of memory_registers.h where v++ does not choose them.
extern "C" {
void sailmap_signature_memory(const sailmap_memory_beat pixels[sailmap::top::frame_beats],
                              uint32_t record[SAILMAP_RECORD_WORDS], uint32_t report[SAILMAP_REPORT_WORDS],
                              uint32_t width, uint32_t height, uint32_t frame, uint32_t max_regions,
                              uint32_t stop_ratio, uint32_t box_side) {
#pragma HLS interface mode = m_axi port = pixels bundle = gmem0 offset = slave
#pragma HLS interface mode = m_axi port = record bundle = gmem1 offset = slave
#pragma HLS interface mode = m_axi port = report bundle = gmem2 offset = slave
#ifndef SAILMAP_VITIS_KERNEL
#pragma HLS interface mode = s_axilite port = pixels offset = 0x10
#pragma HLS interface mode = s_axilite port = record offset = 0x1c
#pragma HLS interface mode = s_axilite port = report offset = 0x28
#pragma HLS interface mode = s_axilite port = width offset = 0x34
#pragma HLS interface mode = s_axilite port = height offset = 0x3c
#pragma HLS interface mode = s_axilite port = frame offset = 0x44
#pragma HLS interface mode = s_axilite port = max_regions offset = 0x4c
#pragma HLS interface mode = s_axilite port = stop_ratio offset = 0x54
#pragma HLS interface mode = s_axilite port = box_side offset = 0x5c
#pragma HLS interface mode = s_axilite port = return
#endif
  sailmap::hls::signature_memory<sailmap::top::Config>(pixels, record, report, width, height, frame,
                                                       max_regions, stop_ratio, box_side);
}
}
