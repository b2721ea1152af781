#include "sailmap_signature_memory.h"

#include "sailmap/hls/memory_registers.h"

void sailmap_signature_start(volatile uint32_t* registers, const struct sailmap_signature_buffers* buffers,
                             uint32_t width, uint32_t height, uint32_t frame,
                             const struct sailmap_signature_parameters* parameters) {
  sailmap_write_address(registers, SAILMAP_SIGNATURE_PIXELS, buffers->pixels);
  sailmap_write_address(registers, SAILMAP_SIGNATURE_RECORD, buffers->record);
  sailmap_write_address(registers, SAILMAP_SIGNATURE_REPORT, buffers->report);
  registers[SAILMAP_SIGNATURE_WIDTH / 4] = width;
  registers[SAILMAP_SIGNATURE_HEIGHT / 4] = height;
  registers[SAILMAP_SIGNATURE_FRAME / 4] = frame;
  registers[SAILMAP_SIGNATURE_MAX_REGIONS / 4] = parameters->max_regions;
  registers[SAILMAP_SIGNATURE_STOP_RATIO / 4] = parameters->stop_ratio;
  registers[SAILMAP_SIGNATURE_BOX_SIDE / 4] = parameters->box_side;
  registers[SAILMAP_CONTROL / 4] = SAILMAP_START;
}
