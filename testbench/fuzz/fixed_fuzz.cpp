// Differential fuzzing, libFuzzer's entry point: whatever the bytes, `fixed` says what `quantised` says.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "fixed/maps_equal.hpp"
#include "sailmap/frontend.hpp"

namespace {

using sailmap::ImageView;

// The next byte; past the end 0.
struct Bytes {
  const std::uint8_t* data;
  std::size_t size;

  std::uint8_t next() {
    if (size == 0) return 0;
    --size;
    return *data++;
  }
};

// Sides of 64 to 191, order and stride from the first four bytes; the other bytes are pixels, run after run,
// each run's length from a byte too, so that few bytes make flat areas, edges and textures alike.
struct Image {
  int width, height;
  bool rgb;
  int stride;
  std::vector<std::uint8_t> pixels;

  explicit Image(Bytes bytes)
      : width(64 + bytes.next() % 128),
        height(64 + bytes.next() % 128),
        rgb(bytes.next() % 2 == 0),
        stride(3 * width + bytes.next() % 64),
        pixels(static_cast<std::size_t>(stride) * static_cast<std::size_t>(height)) {
    if (bytes.size < 4) return;
    const Bytes all = bytes;
    std::size_t at = 0;
    std::uint32_t turn = 0;
    while (at < pixels.size()) {
      if (bytes.size < 4) {
        bytes = all;
        ++turn;
      }
      const std::size_t run = std::size_t{3} * (1 + bytes.next());
      const std::uint8_t colour[3] = {bytes.next(), bytes.next(),
                                      static_cast<std::uint8_t>(bytes.next() + turn)};
      for (std::size_t i = 0; i < run && at < pixels.size(); ++i) pixels[at++] = colour[i % 3];
    }
  }
  [[nodiscard]] ImageView view() const {
    return {width, height, pixels.data(), stride,
            rgb ? sailmap::ChannelOrder::rgb : sailmap::ChannelOrder::bgr};
  }
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  // One object for all inputs: nothing of one image may be left in the next.
  static const auto fixed = sailmap::make_frontend("fixed");
  static const auto quantised = sailmap::make_frontend("quantised");
  static sailmap::Maps got;
  static sailmap::Maps want;
  const Image image({data, size});
  fixed->compute(image.view(), got);
  quantised->compute(image.view(), want);
  const std::string found = sailmap::testing::difference(got, want);
  if (!found.empty()) {
    std::fprintf(stderr, "%dx%d: %s\n", image.width, image.height, found.c_str());
    std::abort();
  }
  return 0;
}
