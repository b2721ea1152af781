// The C simulation of the kernels as a front end: what the hardware says, bit for bit.
#include <array>
#include <cstdint>
#include <vector>

#include "frontends.hpp"
#include "packed_maps.hpp"
#include "sailmap/csim/signature.hpp"
#include "sailmap/csim/simulate.hpp"
#include "signature_record.hpp"

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

  void compute(const ImageView& image, Maps& maps) override { simulate(image, maps); }

  void describe(const ImageView& image, const RegionConfig& regions, Maps& maps,
                Signature& signature) override {
    const csim::FrontEndWords words = simulate(image, maps);
    if (regions.signature == SignatureMaker::host) {
      signature = make_signature(maps, regions);
      return;
    }
    const ChipParameters asked = chip_parameters(regions);
    csim::Scheduler scheduler;
    const std::vector<std::uint32_t> record = csim::simulate_signature(
        words, image.width, image.height, {asked.max_regions, asked.stop_ratio, asked.box_side}, scheduler);
    signature = signature_of_record(record, image.width, image.height, asked);
  }

 private:
  // Fills the maps; returns what they were made of.
  static csim::FrontEndWords simulate(const ImageView& image, Maps& maps) {
    check_image_size(image);
    const std::array<csim::Frame, 1> frames = {frame_of(image)};
    csim::Scheduler scheduler;
    csim::FrontEndWords words = csim::simulate(frames, csim::widest_beat(image.width), scheduler).front();
    unpack({words.intensity_maps, words.colour_maps, words.orientation_maps, words.conspicuity_maps,
            words.saliency, words.statistics},
           image.width, image.height, maps);
    return words;
  }
};

}  // namespace

std::unique_ptr<Frontend> make_csim() { return std::make_unique<Csim>(); }

}  // namespace sailmap
