// What this machine can do at most, on one core: the limits that the other figures are held against.
#include <benchmark/benchmark.h>
#if defined(__x86_64__)
// g++ 12 takes the intrinsics' own "undefined" for a mistake (GCC bug 105593).
#pragma GCC diagnostic ignored "-Wuninitialized"
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#include <immintrin.h>
#endif

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace {

// As fast as reading goes: eight sums side by side.
__attribute__((target_clones("arch=skylake-avx512", "avx2", "default"))) std::uint64_t sum_of(
    const std::uint64_t* words, std::size_t count) {
  std::uint64_t sum = 0;
  for (std::size_t i = 0; i < count; ++i) sum += words[i];
  return sum;
}

// Bytes per second that arrive from memory (256 MiB) or from a cache of that size.
void read(benchmark::State& state) {
  std::vector<std::uint64_t> words(static_cast<std::size_t>(state.range(0)) / sizeof(std::uint64_t));
  std::iota(words.begin(), words.end(), 0);
  for (auto _ : state) benchmark::DoNotOptimize(sum_of(words.data(), words.size()));
  state.SetBytesProcessed(state.iterations() * state.range(0));
}
BENCHMARK(read)->Name("machine/read/memory")->Arg(256 << 20)->Unit(benchmark::kMillisecond);
BENCHMARK(read)->Name("machine/read/level_2")->Arg(512 << 10)->Unit(benchmark::kMicrosecond);

constexpr int rounds = 1000;
constexpr int chains = 12;  // that do not wait for each other: enough to hide the latency

#if defined(__x86_64__)
// Twelve chains of `vpmaddwd` and `vpaddd` on all lanes: 16-bit products added up in 32 bits, what filters of
// small integers consist of.
__attribute__((target("avx512bw"))) std::int32_t multiply_add_512(std::int16_t factor) {
  __m512i sums[chains];
  for (__m512i& sum : sums) sum = _mm512_setzero_si512();
  __m512i factors = _mm512_set1_epi16(factor);
  for (int round = 0; round < rounds; ++round) {
    for (__m512i& sum : sums) sum = _mm512_add_epi32(sum, _mm512_madd_epi16(factors, sum));
  }
  for (const __m512i& sum : sums) factors = _mm512_add_epi32(factors, sum);
  return _mm_cvtsi128_si32(_mm512_castsi512_si128(factors));
}

__attribute__((target("avx2"))) std::int32_t multiply_add_256(std::int16_t factor) {
  __m256i sums[chains];
  for (__m256i& sum : sums) sum = _mm256_set1_epi16(factor);
  __m256i factors = _mm256_set1_epi16(factor);
  for (int round = 0; round < rounds; ++round) {
    for (__m256i& sum : sums) sum = _mm256_add_epi32(sum, _mm256_madd_epi16(factors, sum));
  }
  for (const __m256i& sum : sums) factors = _mm256_add_epi32(factors, sum);
  return _mm256_extract_epi32(factors, 0);
}

// A 16-bit multiplication and the addition of its product are two operations.
void arithmetic(benchmark::State& state) {
  const bool wide = __builtin_cpu_supports("avx512bw") != 0;
  if (!wide && __builtin_cpu_supports("avx2") == 0) {
    state.SkipWithError("neither AVX-512BW nor AVX2");
    return;
  }
  std::int16_t factor = 3;
  for (auto _ : state) {
    benchmark::DoNotOptimize(factor);
    benchmark::DoNotOptimize(wide ? multiply_add_512(factor) : multiply_add_256(factor));
  }
  const int lanes = wide ? 32 : 16;
  state.counters["operations"] =
      benchmark::Counter(2.0 * lanes * chains * rounds, benchmark::Counter::kIsIterationInvariantRate);
}
BENCHMARK(arithmetic)->Name("machine/multiply_add/int16")->Unit(benchmark::kMicrosecond);
#endif

}  // namespace
