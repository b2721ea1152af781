// The benchmarks of sailmap_bench, by subject; each registers its own under stable names.
#pragma once

#include <benchmark/benchmark.h>

namespace sailmap::bench {

// match/..., insert/..., query/..., query_exhaustive/...
void register_query();

// screen/..., estimate/...: the parts of a query
void register_screen();

// map/...
void register_map();

// context/...
void register_context();

}  // namespace sailmap::bench
