/* What the kernels sailmap_memory and sailmap_signature_memory (hls/top) share with whoever drives them: their
 * registers, their arguments, and the report that they write. For C99 and later and for C++: kernels, host
 * library and bare-metal programs read this file.
 *
 * Both read a frame from memory; one writes its maps to memory, the other its signature. Addresses are
 * physical ones, multiples of 64 bytes. Pixels are four bytes each, R, G, B and one that is ignored, in raster
 * order without padding. Maps are those of front_end.hpp, words in raster order, the low byte first; the
 * signature is the record of signature_record.hpp.
 */
#ifndef SAILMAP_HLS_MEMORY_REGISTERS_H
#define SAILMAP_HLS_MEMORY_REGISTERS_H

/* The first word of a report: two letters that name the kernel's interface, 'S', 'M' of sailmap_memory and
 * 'S', 'G' of sailmap_signature_memory, and its number, which grows with every change. */
#define SAILMAP_MEMORY_VERSION 0x534d0001
#define SAILMAP_SIGNATURE_VERSION 0x53470001

#define SAILMAP_MEMORY_KERNEL "sailmap_memory"
#define SAILMAP_SIGNATURE_KERNEL "sailmap_signature_memory"

enum {
  /* Offsets in bytes from the start of the AXI4-Lite slave. An address takes two registers, the low half
   * first; all are written as 32-bit words. Of both kernels: */
  SAILMAP_CONTROL = 0x00,

  /* Of sailmap_memory. */
  SAILMAP_PIXELS = 0x10,
  SAILMAP_INTENSITY_MAPS = 0x1c,
  SAILMAP_COLOUR_MAPS = 0x28,
  SAILMAP_ORIENTATION_MAPS = 0x34,
  SAILMAP_CONSPICUITY_MAPS = 0x40,
  SAILMAP_SALIENCY = 0x4c,
  SAILMAP_STATISTICS = 0x58,
  SAILMAP_REPORT = 0x64,
  SAILMAP_WIDTH = 0x70,
  SAILMAP_HEIGHT = 0x78,
  SAILMAP_FRAME = 0x80,
  SAILMAP_REGISTERS_END = 0x88,

  /* Of sailmap_signature_memory. The last three are the frame's parameters, as signature.hpp has them; what
   * lies outside their limits counts as the nearest inside. */
  SAILMAP_SIGNATURE_PIXELS = 0x10,
  SAILMAP_SIGNATURE_RECORD = 0x1c,
  SAILMAP_SIGNATURE_REPORT = 0x28,
  SAILMAP_SIGNATURE_WIDTH = 0x34,
  SAILMAP_SIGNATURE_HEIGHT = 0x3c,
  SAILMAP_SIGNATURE_FRAME = 0x44,
  SAILMAP_SIGNATURE_MAX_REGIONS = 0x4c,
  SAILMAP_SIGNATURE_STOP_RATIO = 0x54,
  SAILMAP_SIGNATURE_BOX_SIDE = 0x5c,
  SAILMAP_SIGNATURE_REGISTERS_END = 0x64,

  /* Bits of SAILMAP_CONTROL: written to start a frame; read, `done` once a frame (reading clears it). */
  SAILMAP_START = 1,
  SAILMAP_DONE = 2,
  SAILMAP_IDLE = 4,

  /* Bytes a pixel, and a base-level pixel of each kind of map. */
  SAILMAP_PIXEL_BYTES = 4,
  SAILMAP_INTENSITY_BYTES = 4,
  SAILMAP_COLOUR_BYTES = 8,
  SAILMAP_ORIENTATION_BYTES = 8,
  SAILMAP_CONSPICUITY_BYTES = 8,
  SAILMAP_SALIENCY_BYTES = 2,
  SAILMAP_STATISTICS_WORDS = 26,
  /* Words of 32 bits of a signature, whatever the number of its regions. */
  SAILMAP_RECORD_WORDS = 248,

  /* Words of 32 bits of the report. It is written at every start, whatever the size: a start with width and
   * height 0 asks for version and limits. */
  SAILMAP_REPORT_VERSION = 0,
  SAILMAP_REPORT_MAX_WIDTH = 1,
  SAILMAP_REPORT_MAX_HEIGHT = 2,
  SAILMAP_REPORT_BEAT = 3, /* widths are multiples of it */
  SAILMAP_REPORT_MIN_SIDE = 4,
  SAILMAP_REPORT_WIDTH = 5, /* as the start gave them */
  SAILMAP_REPORT_HEIGHT = 6,
  SAILMAP_REPORT_FRAME = 7,
  /* Of each map: ceil(width/4) * ceil(height/4), or of the signature: 248; 0 of a refused size. */
  SAILMAP_REPORT_OUTPUT_WORDS = 8,
  SAILMAP_REPORT_STATUS = 9, /* written last */
  SAILMAP_REPORT_WORDS = 16,

  /* Values of the status. */
  SAILMAP_STATUS_BUSY = 0,
  SAILMAP_STATUS_DONE = 1,
  SAILMAP_STATUS_REFUSED = 2 /* a size that the kernel does not take; nothing but the report was written */
};

#endif
