#include "sailmap_registers.h"

#include "sailmap/hls/memory_registers.h"

void sailmap_write_address(volatile uint32_t* registers, int offset, uint64_t address) {
  registers[offset / 4] = (uint32_t)address;
  registers[offset / 4 + 1] = (uint32_t)(address >> 32);
}

int sailmap_wait(volatile uint32_t* registers, unsigned long polls) {
  while (polls-- > 0) {
    if ((registers[SAILMAP_CONTROL / 4] & SAILMAP_DONE) != 0) return 0;
  }
  return -1;
}
