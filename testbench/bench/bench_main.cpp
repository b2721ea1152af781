// sailmap_bench [Google Benchmark's options].
#include "bench.hpp"

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  sailmap::bench::register_context();
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
}
