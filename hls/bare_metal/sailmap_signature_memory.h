/* The kernel sailmap_signature_memory without an operating system: one frame at a time, polled. For C99 and
 * C++. */
#ifndef SAILMAP_SIGNATURE_MEMORY_H
#define SAILMAP_SIGNATURE_MEMORY_H

#include <stdint.h>

#include "sailmap_registers.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Where a frame and its signature lie: physical addresses, multiples of 64. The record has 248 words of 32
 * bits (signature_record.hpp), the report 16. Caches are the caller's: flush the pixels before, invalidate the
 * outputs after. */
struct sailmap_signature_buffers {
  uint64_t pixels;
  uint64_t record;
  uint64_t report;
};

/* What a frame's signature is asked for with; what lies outside counts as the nearest inside. */
struct sailmap_signature_parameters {
  uint32_t max_regions; /* 1 to 20 */
  uint32_t stop_ratio;  /* in units of 1/65536: 0 to 65536 */
  uint32_t box_side;    /* 2 to 16 base-level pixels */
};

/* Starts a frame, which sailmap_wait (sailmap_registers.h) waits for; 0 x 0 asks for the report alone. The
 * kernel must be idle. */
void sailmap_signature_start(volatile uint32_t* registers, const struct sailmap_signature_buffers* buffers,
                             uint32_t width, uint32_t height, uint32_t frame,
                             const struct sailmap_signature_parameters* parameters);

#ifdef __cplusplus
}
#endif

#endif
