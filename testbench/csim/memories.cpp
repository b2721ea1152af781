// Prints the memories of the presets: what block memory and what LUTs they fill, counted from the kernels'
// own arrays.
#include "memories.hpp"

#include <cstdio>

namespace {

using namespace sailmap;
using memories::Memory;

// Words up to which an array is taken for distributed memory: three LUTs deep, which a row of the base level
// at VGA fills.
constexpr int shallow = 192;

bool in_luts(const Memory& memory) { return memory.words <= shallow; }

double block_rams(const Memory& memory) {
  return memory.copies * memories::half_block_rams(memory.words, memory.bits) / 2.0;
}

double kilobits(const Memory& memory) { return 1e-3 * memory.copies * memory.words * memory.bits; }

struct Sum {
  double kilobits = 0;
  double block_rams = 0;
  int luts = 0;

  void add(const Memory& memory) {
    kilobits += ::kilobits(memory);
    if (in_luts(memory)) {
      luts += memory.copies * memories::memory_luts(memory.words, memory.bits);
    } else {
      block_rams += ::block_rams(memory);
    }
  }
};

template <class Config>
void print_each(const char* name) {
  std::printf("%s, %d pixels a beat\n%-46s %6s %6s %5s %8s %8s %6s\n", name, Config::beat, "memory", "copies",
              "words", "bits", "kbit", "BRAM36", "LUT");
  Sum sum;
  for (const Memory& memory : memories::of_front_end<Config>()) {
    std::printf("%-46s %6d %6d %5d %8.1f ", memory.what.c_str(), memory.copies, memory.words, memory.bits,
                kilobits(memory));
    if (in_luts(memory)) {
      std::printf("%8s %6d\n", "", memory.copies * memories::memory_luts(memory.words, memory.bits));
    } else {
      std::printf("%8.1f\n", block_rams(memory));
    }
    sum.add(memory);
  }
  std::printf("%-46s %6s %6s %5s %8.1f %8.1f %6d\n\n", "in all", "", "", "", sum.kilobits, sum.block_rams,
              sum.luts);
}

template <class Config>
void print_sum(const char* name) {
  Sum sum;
  Sum stores;
  for (const Memory& memory : memories::of_front_end<Config>()) {
    sum.add(memory);
    if (memory.what.rfind("store", 0) == 0) stores.add(memory);
  }
  std::printf("%-7s %4d %-6s %10.1f %8.1f %8.1f %6d\n", name, Config::beat,
              Config::double_buffer ? "double" : "single", sum.kilobits, stores.block_rams, sum.block_rams,
              sum.luts);
}

template <template <int, bool> class Preset>
void print_preset(const char* name) {
  print_sum<Preset<1, false>>(name);
  print_sum<Preset<4, false>>(name);
  print_sum<Preset<8, false>>(name);
  print_sum<Preset<8, true>>(name);
}

template <class Config>
void print_signature(const char* name) {
  Sum sum;
  for (const Memory& memory : memories::of_signature<Config>()) sum.add(memory);
  std::printf("%-6s %10.1f %8.1f %6d\n", name, sum.kilobits, sum.block_rams, sum.luts);
}

}  // namespace

int main() {
  print_each<hls::Vga<8>>("VGA");
  std::printf(
      "arrays of up to %d words in LUTs, the others in block memory\n%-7s %4s %-6s %10s %8s %8s %6s\n",
      shallow, "preset", "beat", "buffer", "kbit", "stores", "BRAM36", "LUT");
  print_preset<hls::Qvga>("QVGA");
  print_preset<hls::Vga>("VGA");
  print_preset<hls::Hd720>("720p");
  print_preset<hls::Hd1080>("1080p");
  std::printf("\nthe signature, beside those\n%-6s %10s %8s %6s\n", "preset", "kbit", "BRAM36", "LUT");
  print_signature<hls::Qvga<8>>("QVGA");
  print_signature<hls::Vga<8>>("VGA");
  print_signature<hls::Hd720<8>>("720p");
  print_signature<hls::Hd1080<8>>("1080p");
}
