/* The registers that the kernels between memory and memory have in common. For C99 and C++. */
#ifndef SAILMAP_REGISTERS_H
#define SAILMAP_REGISTERS_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Writes the two registers of an address; `offset` is that of the first. */
void sailmap_write_address(volatile uint32_t* registers, int offset, uint64_t address);

/* Looks at most `polls` times whether the frame is done; 0 when it is, -1 when it is not. */
int sailmap_wait(volatile uint32_t* registers, unsigned long polls);

#ifdef __cplusplus
}
#endif

#endif
