#include "sailmap_memory.h"

#include "sailmap/hls/memory_registers.h"

static void write_address(volatile uint32_t* registers, int offset, uint64_t address) {
  registers[offset / 4] = (uint32_t)address;
  registers[offset / 4 + 1] = (uint32_t)(address >> 32);
}

void sailmap_start(volatile uint32_t* registers, const struct sailmap_buffers* buffers, uint32_t width,
                   uint32_t height, uint32_t frame) {
  write_address(registers, SAILMAP_PIXELS, buffers->pixels);
  write_address(registers, SAILMAP_INTENSITY_MAPS, buffers->intensity_maps);
  write_address(registers, SAILMAP_COLOUR_MAPS, buffers->colour_maps);
  write_address(registers, SAILMAP_ORIENTATION_MAPS, buffers->orientation_maps);
  write_address(registers, SAILMAP_CONSPICUITY_MAPS, buffers->conspicuity_maps);
  write_address(registers, SAILMAP_SALIENCY, buffers->saliency);
  write_address(registers, SAILMAP_STATISTICS, buffers->statistics);
  write_address(registers, SAILMAP_REPORT, buffers->report);
  registers[SAILMAP_WIDTH / 4] = width;
  registers[SAILMAP_HEIGHT / 4] = height;
  registers[SAILMAP_FRAME / 4] = frame;
  registers[SAILMAP_CONTROL / 4] = SAILMAP_START;
}

int sailmap_wait(volatile uint32_t* registers, unsigned long polls) {
  while (polls-- > 0) {
    if ((registers[SAILMAP_CONTROL / 4] & SAILMAP_DONE) != 0) return 0;
  }
  return -1;
}
