#include "sailmap_memory.h"

#include "sailmap/hls/memory_registers.h"

void sailmap_start(volatile uint32_t* registers, const struct sailmap_buffers* buffers, uint32_t width,
                   uint32_t height, uint32_t frame) {
  sailmap_write_address(registers, SAILMAP_PIXELS, buffers->pixels);
  sailmap_write_address(registers, SAILMAP_INTENSITY_MAPS, buffers->intensity_maps);
  sailmap_write_address(registers, SAILMAP_COLOUR_MAPS, buffers->colour_maps);
  sailmap_write_address(registers, SAILMAP_ORIENTATION_MAPS, buffers->orientation_maps);
  sailmap_write_address(registers, SAILMAP_CONSPICUITY_MAPS, buffers->conspicuity_maps);
  sailmap_write_address(registers, SAILMAP_SALIENCY, buffers->saliency);
  sailmap_write_address(registers, SAILMAP_STATISTICS, buffers->statistics);
  sailmap_write_address(registers, SAILMAP_REPORT, buffers->report);
  registers[SAILMAP_WIDTH / 4] = width;
  registers[SAILMAP_HEIGHT / 4] = height;
  registers[SAILMAP_FRAME / 4] = frame;
  registers[SAILMAP_CONTROL / 4] = SAILMAP_START;
}
