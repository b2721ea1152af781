#include "kernels.hpp"
#include "sailmap/hls/gabor.hpp"

void sailmap_orientation(sailmap::hls::stream<uint16_t>& intensity, sailmap::hls::stream<uint64_t>& energies,
                         uint16_t width, uint16_t height) {
#pragma HLS interface mode = axis port = intensity
#pragma HLS interface mode = axis port = energies
  sailmap::hls::orientation_energy<sailmap::top::Config, 2>(intensity, energies, width, height);
}
