// Writes the words of one synthesis top's test bench (scripts/vitis/testbench.hpp has the format), in and
// out, from the quantised reference: write_vectors TOP BEAT FILE [IMAGE.ppm...]. Three frames of different
// size, or those images; no kernel code takes part.
#include <cstdint>
#include <exception>
#include <fstream>
#include <iostream>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "csim/frames.hpp"
#include "ppm.hpp"
#include "writers.hpp"

namespace sailmap::testing {
namespace {

std::vector<csim::Frame> three_frames() {
  std::mt19937 random(20);
  return {patches_frame(72, 64, random), noise_frame(64, 70, random), constant_frame(64, 64, 200, 30, 90)};
}

void write(const std::string& top, std::size_t beat, const std::string& path,
           const std::vector<csim::Frame>& frames) {
  Writers writers = kernel_writers();
  writers.merge(front_end_writers());
  const auto writer = writers.find(top);
  if (writer == writers.end()) throw std::runtime_error("unknown top " + top);
  if (beat != 1 && beat != 2 && beat != 4 && beat != 8) throw std::runtime_error("a beat is 1, 2, 4 or 8");
  std::ofstream file(path);
  std::uint32_t count = 0;
  for (const csim::Frame& frame : frames) {
    Call call;
    if (top != "sailmap_gains") call.size(frame);
    writer->second(call, frame, beat, ++count);
    file << call.text();
  }
  if (!file.flush()) throw std::runtime_error(path + ": cannot be written");
}

}  // namespace
}  // namespace sailmap::testing

int main(int argc, char** argv) {
  try {
    if (argc < 4) throw std::runtime_error("usage: write_vectors TOP BEAT FILE [IMAGE.ppm...]");
    std::vector<sailmap::csim::Frame> frames;
    for (int i = 4; i < argc; ++i) frames.push_back(sailmap::testing::read_ppm(argv[i]));
    if (frames.empty()) frames = sailmap::testing::three_frames();
    sailmap::testing::write(argv[1], std::stoul(argv[2]), argv[3], frames);
    return 0;
  } catch (const std::exception& error) {
    std::cerr << "write_vectors: " << error.what() << '\n';
    return 1;
  }
}
