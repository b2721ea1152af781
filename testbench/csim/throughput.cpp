// Prints the predicted throughput of the presets, from the constants of the kernels.
#include "sailmap/hls/throughput.hpp"

#include <cstdio>
#include <initializer_list>

namespace {

struct Preset {
  const char* name;
  int width, height;
};

void print(const Preset& preset, int beat, bool double_buffer, double megahertz) {
  using namespace sailmap::hls;
  const long frame = throughput::frame(preset.width, preset.height, beat, double_buffer);
  const long latency = throughput::latency(preset.width, preset.height, beat);
  const double pixels = static_cast<double>(preset.width) * preset.height;
  std::printf("%-6s %4d %-6s %9ld %7.3f %9ld %7.1f %8.1f %8.2f\n", preset.name, beat,
              double_buffer ? "double" : "single", frame, static_cast<double>(frame) / pixels, latency,
              1e6 * megahertz / static_cast<double>(frame), pixels * megahertz / static_cast<double>(frame),
              1e-3 * static_cast<double>(latency) / megahertz);
}

constexpr Preset presets[] = {
    {"QVGA", 320, 240}, {"VGA", 640, 480}, {"720p", 1280, 720}, {"1080p", 1920, 1080}};

void print_signature(const Preset& preset) {
  using namespace sailmap::hls::throughput;
  const int regions = sailmap::hls::signature_record::max_regions;
  const long cycles = signature_after_frame(preset.width, preset.height, regions, 10);
  std::printf("%-6s %9ld", preset.name, cycles);
  for (const int beat : {1, 2, 4, 8}) {
    std::printf(" %8.2f",
                static_cast<double>(cycles) / static_cast<double>(input(preset.width, preset.height, beat)));
  }
  for (const bool twice : {false, true}) {
    std::printf(" %9ld", frame_with_signature(preset.width, preset.height, 8, twice, 10));
  }
  std::printf("\n");
}

}  // namespace

int main() {
  for (const double megahertz : {150.0, 200.0}) {
    std::printf("%.0f MHz, every loop at its II\n", megahertz);
    std::printf("%-6s %4s %-6s %9s %7s %9s %7s %8s %8s\n", "preset", "beat", "buffer", "cycles", "/pixel",
                "latency", "frame/s", "Mpixel/s", "ms");
    for (const Preset& preset : presets) {
      for (const int beat : {1, 2, 4, 8}) {
        for (const bool double_buffer : {false, true}) print(preset, beat, double_buffer, megahertz);
      }
    }
  }
  std::printf(
      "signature of 20 regions of 10x10: cycles behind the frame, as a part of the frame's own words in, and "
      "cycles from\nframe to frame with the front end at 8 pixels a beat\n%-6s %9s %8s %8s %8s %8s %9s %9s\n",
      "preset", "cycles", "beat 1", "2", "4", "8", "single", "double");
  for (const Preset& preset : presets) print_signature(preset);
}
