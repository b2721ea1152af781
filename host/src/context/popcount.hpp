// Counting bits with the processor's own instruction where it has one, though the library is built for any.
// Clang before version 18 gives such functions a name that other files do not find.
#pragma once

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__) && \
    !defined(__SANITIZE_THREAD__)
#define SAILMAP_POPCOUNT_CLONES __attribute__((target_clones("popcnt", "default")))
#else
#define SAILMAP_POPCOUNT_CLONES
#endif
