// After streams_only.hpp: the parts of a dataflow region (*.inc) are their stages alone, for the region
// itself.
#undef SAILMAP_STREAM
#define SAILMAP_STREAM(type, name)
#undef SAILMAP_STAGE
#define SAILMAP_STAGE(function, ...) SAILMAP_WITHOUT_BRACKETS function(__VA_ARGS__)
