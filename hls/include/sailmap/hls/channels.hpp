// Channels, spec section 2: intensity and the four broadly tuned colours of each pixel.
//
// Streams in: red, green and blue, Count = 1, 2 or 4 bytes a word, raster order. Out: words of Count pixels
// of intensity (format grey_sum), green, blue, red and yellow (format colour); for Count = 1 the colours are
// lanes of one word. Latency 0. II 1. Maximum error against the exact model: intensity none; colours
// `accuracy::colour_error`.
#pragma once

#include <utility>

#include "sailmap/hls/arithmetic.hpp"
#include "sailmap/hls/lanes.hpp"
#include "sailmap/hls/pragmas.hpp"
#include "sailmap/hls/stream.hpp"

namespace sailmap {
namespace hls {

// The 766 reciprocals, one table per Id: two stages cannot read one ROM at a time.
template <int Id, class Indices = std::make_integer_sequence<int, 766> >
struct ReciprocalTable;
template <int Id, int... Sums>
struct ReciprocalTable<Id, std::integer_sequence<int, Sums...> > {
  static const uint16_t words[sizeof...(Sums)];
};
template <int Id, int... Sums>
const uint16_t ReciprocalTable<Id, std::integer_sequence<int, Sums...> >::words[sizeof...(Sums)] = {
    colour_reciprocal(Sums)...};

struct ChannelPixel {
  uint16_t intensity, green, blue, red, yellow;
};

template <int Id>
inline ChannelPixel channel_pixel(uint8_t red, uint8_t green, uint8_t blue) {
  const int r = red;
  const int g = green;
  const int b = blue;
  const int s = r + g + b;
  const uint32_t k = ReciprocalTable<Id>::words[s];
  ChannelPixel out = {0, 0, 0, 0, 0};
  out.intensity = static_cast<uint16_t>(s);
  out.green = tuned_colour(k, 2 * g - r - b);
  out.blue = tuned_colour(k, 2 * b - r - g);
  out.red = tuned_colour(k, 2 * r - g - b);
  out.yellow = tuned_colour(k, 2 * (r < g ? r : g) - 2 * b);
  return out;
}

template <class Config>
void channels_1(stream<uint8_t>& red, stream<uint8_t>& green, stream<uint8_t>& blue,
                stream<uint16_t>& intensity, stream<uint64_t>& colours, uint16_t width, uint16_t height) {
  const int words = width * height;
#pragma nounroll
  for (int i = 0; i < words; ++i) {
    SAILMAP_PIPELINE
    const uint8_t r = red.read();
    const uint8_t g = green.read();
    const uint8_t b = blue.read();
    const ChannelPixel p = channel_pixel<0>(r, g, b);
    intensity.write(p.intensity);
    colours.write(pack(p.green, p.blue, p.red, p.yellow));
  }
}

template <class Config>
void channels_2(stream<uint16_t>& red, stream<uint16_t>& green, stream<uint16_t>& blue,
                stream<uint32_t>& intensity_out, stream<uint32_t>& green_out, stream<uint32_t>& blue_out,
                stream<uint32_t>& red_out, stream<uint32_t>& yellow_out, uint16_t width, uint16_t height) {
  const int words = width / 2 * height;
#pragma nounroll
  for (int i = 0; i < words; ++i) {
    SAILMAP_PIPELINE
    const uint16_t r = red.read();
    const uint16_t g = green.read();
    const uint16_t b = blue.read();
    const ChannelPixel p = channel_pixel<0>(byte_lane<0>(r), byte_lane<0>(g), byte_lane<0>(b));
    const ChannelPixel q = channel_pixel<0>(byte_lane<1>(r), byte_lane<1>(g), byte_lane<1>(b));
    intensity_out.write(pack(p.intensity, q.intensity));
    green_out.write(pack(p.green, q.green));
    blue_out.write(pack(p.blue, q.blue));
    red_out.write(pack(p.red, q.red));
    yellow_out.write(pack(p.yellow, q.yellow));
  }
}

// `Beat` pixels arrive a beat, of which this stage sees four: with Beat = 8 there are two of it, Id 0 and 1.
template <class Config, int Id>
void channels_4(stream<uint32_t>& red, stream<uint32_t>& green, stream<uint32_t>& blue,
                stream<uint64_t>& intensity_out, stream<uint64_t>& green_out, stream<uint64_t>& blue_out,
                stream<uint64_t>& red_out, stream<uint64_t>& yellow_out, uint16_t width, uint16_t height) {
  const int words = width / Config::beat * height;
#pragma nounroll
  for (int i = 0; i < words; ++i) {
    SAILMAP_PIPELINE
    const uint32_t r = red.read();
    const uint32_t g = green.read();
    const uint32_t b = blue.read();
    const ChannelPixel p0 = channel_pixel<Id>(byte_lane<0>(r), byte_lane<0>(g), byte_lane<0>(b));
    const ChannelPixel p1 = channel_pixel<Id>(byte_lane<1>(r), byte_lane<1>(g), byte_lane<1>(b));
    const ChannelPixel p2 = channel_pixel<Id>(byte_lane<2>(r), byte_lane<2>(g), byte_lane<2>(b));
    const ChannelPixel p3 = channel_pixel<Id>(byte_lane<3>(r), byte_lane<3>(g), byte_lane<3>(b));
    intensity_out.write(pack(p0.intensity, p1.intensity, p2.intensity, p3.intensity));
    green_out.write(pack(p0.green, p1.green, p2.green, p3.green));
    blue_out.write(pack(p0.blue, p1.blue, p2.blue, p3.blue));
    red_out.write(pack(p0.red, p1.red, p2.red, p3.red));
    yellow_out.write(pack(p0.yellow, p1.yellow, p2.yellow, p3.yellow));
  }
}

// Eight pixels a beat to the left and the right four.
template <class Config>
void split_beats(stream<uint64_t>& red, stream<uint64_t>& green, stream<uint64_t>& blue,
                 stream<uint32_t>& red_left, stream<uint32_t>& green_left, stream<uint32_t>& blue_left,
                 stream<uint32_t>& red_right, stream<uint32_t>& green_right, stream<uint32_t>& blue_right,
                 uint16_t width, uint16_t height) {
  const int words = width / 8 * height;
#pragma nounroll
  for (int i = 0; i < words; ++i) {
    SAILMAP_PIPELINE
    const uint64_t r = red.read();
    const uint64_t g = green.read();
    const uint64_t b = blue.read();
    red_left.write(static_cast<uint32_t>(r));
    green_left.write(static_cast<uint32_t>(g));
    blue_left.write(static_cast<uint32_t>(b));
    red_right.write(static_cast<uint32_t>(r >> 32));
    green_right.write(static_cast<uint32_t>(g >> 32));
    blue_right.write(static_cast<uint32_t>(b >> 32));
  }
}

}  // namespace hls
}  // namespace sailmap
