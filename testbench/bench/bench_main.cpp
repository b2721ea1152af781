// sailmap_bench [Google Benchmark's options]. Real images, where a benchmark uses them, come from
// SAILMAP_DATA (default ../shared/data).
#include "bench.hpp"

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  sailmap::bench::register_query();
  sailmap::bench::register_screen();
  sailmap::bench::register_context();
  sailmap::bench::register_map();
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
}
