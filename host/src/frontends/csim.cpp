// The C simulation of the kernels as a front end: what the hardware says, bit for bit.
#include <array>
#include <cstdint>
#include <vector>

#include "frontends.hpp"
#include "packed_maps.hpp"
#include "sailmap/csim/simulate.hpp"

namespace sailmap {
namespace {

csim::Frame frame_of(const ImageView& image) {
  csim::Frame frame{image.width, image.height, {}};
  frame.rgb.reserve(3 * static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height));
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const auto [r, g, b] = image.at(x, y);
      for (const int component : {r, g, b}) frame.rgb.push_back(static_cast<std::uint8_t>(component));
    }
  }
  return frame;
}

class Csim : public Frontend {
 public:
  [[nodiscard]] std::string_view name() const override { return "csim"; }

  void compute(const ImageView& image, Maps& maps) override {
    check_image_size(image);
    const std::array<csim::Frame, 1> frames = {frame_of(image)};
    csim::Scheduler scheduler;
    const csim::FrontEndWords words =
        csim::simulate(frames, csim::widest_beat(image.width), scheduler).front();
    unpack({words.intensity_maps, words.colour_maps, words.orientation_maps, words.conspicuity_maps,
            words.saliency, words.statistics},
           image.width, image.height, maps);
  }
};

}  // namespace

std::unique_ptr<Frontend> make_csim() { return std::make_unique<Csim>(); }

}  // namespace sailmap
