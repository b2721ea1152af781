// Directives that only Vitis HLS understands. Bambu rejects them inside loops and pipelines by itself; g++
// has no use for them. Interface and dataflow directives are written out where they apply, as all tools want.
#pragma once

#if defined(__SYNTHESIS__) && !defined(__BAMBU__)
#define SAILMAP_PRAGMA(text) _Pragma(#text)
#define SAILMAP_PIPELINE SAILMAP_PRAGMA(HLS pipeline II = 1)
#define SAILMAP_PIPELINE_II(cycles) SAILMAP_PRAGMA(HLS pipeline II = cycles)
#define SAILMAP_INLINE SAILMAP_PRAGMA(HLS inline)
#else
#define SAILMAP_PIPELINE
#define SAILMAP_PIPELINE_II(cycles)
#define SAILMAP_INLINE
#endif

// On the definition of a static memory: its first contents do not matter. Bambu's front end otherwise writes
// every word of it out, which takes it minutes for a frame store.
#ifdef __BAMBU__
#define SAILMAP_MEMORY __attribute__((loader_uninitialized))
#else
#define SAILMAP_MEMORY
#endif

// On a function: one piece of hardware that all its calls use in turn. Vitis HLS shares by itself where the
// initiation interval leaves time for it.
#ifdef __BAMBU__
#define SAILMAP_SHARED __attribute__((noinline))
#else
#define SAILMAP_SHARED inline
#endif

// On a function that is used once and too long for Bambu's front end to inline it by itself: what it returns
// would be in a memory.
#ifdef __BAMBU__
#define SAILMAP_INLINED inline __attribute__((always_inline))
#else
#define SAILMAP_INLINED inline
#endif
