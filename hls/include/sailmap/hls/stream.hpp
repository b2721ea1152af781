// The FIFO between stages, and the two macros a dataflow region is written with.
//
// Under Vitis HLS and Bambu the FIFO is the tool's hls::stream and a stage is a plain call. In C simulation
// (SAILMAP_CSIM, set by the build target sailmap_csim) the FIFO is ours, bounded and named, and a stage is a
// task of the scheduler. Kernels use read() and write(), of which the words that come out are sure whatever
// the timing, and try_read() where reading earlier or later makes no difference to them (store.hpp). They
// read a stream once in a straight piece of code: Bambu may swap two reads that no loop or condition keeps
// apart.
#pragma once

#ifdef SAILMAP_CSIM

#include "sailmap/csim/stream.hpp"

namespace sailmap {
namespace hls {
template <class T>
using stream = csim::Stream<T>;

// False, and `word` as it was, while there is nothing to read.
template <class T>
bool try_read(stream<T>& in, T& word) {
  return in.try_read(word);
}
}  // namespace hls
}  // namespace sailmap

// A FIFO of a dataflow region; `name` is also what C simulation calls it.
#define SAILMAP_STREAM(type, name) static ::sailmap::csim::Stream<type> name(#name)
// A stage of a dataflow region: SAILMAP_STAGE((function<arguments>), streams..., scalars...). The function is
// in brackets because its template arguments have commas.
#define SAILMAP_STAGE(function, ...) ::sailmap::csim::launch(#function, function, __VA_ARGS__)

#else

#include <hls_stream.h>

namespace sailmap {
namespace hls {
template <class T>
using stream = ::hls::stream<T>;

template <class T>
inline bool try_read(stream<T>& in, T& word) {
#ifdef __BAMBU__
  return in.nb_read(word);
#else
  return in.read_nb(word);
#endif
}
}  // namespace hls
}  // namespace sailmap

#define SAILMAP_WITHOUT_BRACKETS(...) __VA_ARGS__
#define SAILMAP_STREAM(type, name) static ::sailmap::hls::stream<type> name
#define SAILMAP_STAGE(function, ...) SAILMAP_WITHOUT_BRACKETS function(__VA_ARGS__)

#endif
