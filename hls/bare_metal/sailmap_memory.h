/* The kernel sailmap_memory without an operating system: one frame at a time, polled. For C99 and C++. */
#ifndef SAILMAP_MEMORY_H
#define SAILMAP_MEMORY_H

#include <stdint.h>

#include "sailmap_registers.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Where a frame and what becomes of it lie: physical addresses, multiples of 64. memory_registers.h says how
 * large each is. Caches are the caller's: flush the pixels before, invalidate the outputs after. */
struct sailmap_buffers {
  uint64_t pixels;
  uint64_t intensity_maps;
  uint64_t colour_maps;
  uint64_t orientation_maps;
  uint64_t conspicuity_maps;
  uint64_t saliency;
  uint64_t statistics;
  uint64_t report;
};

/* Starts a frame, which sailmap_wait (sailmap_registers.h) waits for; 0 x 0 asks for the report alone. The
 * kernel must be idle. */
void sailmap_start(volatile uint32_t* registers, const struct sailmap_buffers* buffers, uint32_t width,
                   uint32_t height, uint32_t frame);

#ifdef __cplusplus
}
#endif

#endif
