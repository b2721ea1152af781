#include <cctype>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <string>

#include "image_decoders.hpp"
#include "sailmap/error.hpp"

namespace sailmap::io {

namespace {

// The Netpbm formats P1..P6: bitmaps, grey maps and pixmaps, as text or raw. OpenCV reads them too, but takes
// a grey map of 10 or 12 bits for one of 16.
class PnmReader {
 public:
  // The order of the members is the order of the numbers in the header.
  explicit PnmReader(Bytes file)
      : rest_(file.subspan(2)), kind_(file[1] - '0'), width_(number()), height_(number()) {
    check_size(width_, height_);
    if (!bitmap()) max_value_ = number();
    if (max_value_ < 1 || max_value_ > 65535) throw Error("damaged PNM: maximum value out of range");
    if (raw()) take();  // the one white space before the samples
  }

  // Samples 0..255, one or three (RGB) a pixel.
  cv::Mat samples() {
    // Even as text a sample takes a byte, so a cut file shows before its size is allocated.
    if (sample_bytes() * width_ * height_ * channels() >
        static_cast<std::int64_t>(rest_.size()) * (packed() ? 8 : 1)) {
      throw Error("truncated PNM");
    }
    cv::Mat image(static_cast<int>(height_), static_cast<int>(width_), CV_8UC(channels()));
    for (int y = 0; y < image.rows; ++y) read_row(image.ptr(y), image.cols * image.channels());
    return image;
  }

 private:
  [[nodiscard]] bool raw() const { return kind_ >= 4; }
  [[nodiscard]] bool bitmap() const { return kind_ == 1 || kind_ == 4; }
  [[nodiscard]] bool packed() const { return kind_ == 4; }
  [[nodiscard]] int channels() const { return kind_ == 3 || kind_ == 6 ? 3 : 1; }
  [[nodiscard]] std::int64_t sample_bytes() const { return raw() && max_value_ > 255 ? 2 : 1; }

  std::uint8_t take() {
    if (rest_.empty()) throw Error("truncated PNM");
    const std::uint8_t byte = rest_.front();
    rest_ = rest_.subspan(1);
    return byte;
  }

  void skip_blanks_and_comments() {
    while (!rest_.empty() && (std::isspace(rest_.front()) != 0 || rest_.front() == '#')) {
      if (rest_.front() == '#') {
        while (!rest_.empty() && rest_.front() != '\n') take();
      } else {
        take();
      }
    }
  }

  std::uint8_t digit() {
    const std::uint8_t byte = take();
    if (std::isdigit(byte) == 0) throw Error("damaged PNM: a number expected");
    return static_cast<std::uint8_t>(byte - '0');
  }

  int number() {
    constexpr int limit = 1 << 24;
    skip_blanks_and_comments();
    int value = digit();
    while (!rest_.empty() && std::isdigit(rest_.front()) != 0) {
      value = value * 10 + digit();
      if (value > limit) throw Error("damaged PNM: a number is too large");
    }
    return value;
  }

  [[nodiscard]] std::uint8_t scaled(int value) const {
    if (value > max_value_) throw Error("damaged PNM: a sample is above the maximum value");
    return static_cast<std::uint8_t>((value * 255 + max_value_ / 2) / max_value_);
  }

  // In a bitmap 1 is black.
  static std::uint8_t bit_colour(bool black) { return black ? 0 : 255; }

  std::uint8_t sample() {
    if (kind_ == 1) {
      skip_blanks_and_comments();  // text bitmaps need no white space between their digits
      return bit_colour(digit() != 0);
    }
    if (!raw()) return scaled(number());
    const int high = take();
    return scaled(sample_bytes() == 1 ? high : high * 256 + take());
  }

  void read_row(std::uint8_t* row, int count) {
    std::uint8_t bits = 0;
    for (int i = 0; i < count; ++i) {
      if (!packed()) {
        row[i] = sample();
        continue;
      }
      if (i % 8 == 0) bits = take();
      row[i] = bit_colour((bits >> (7 - i % 8) & 1) != 0);
    }
  }

  Bytes rest_;
  int kind_;
  int width_;
  int height_;
  int max_value_ = 1;
};

}  // namespace

cv::Mat decode_pnm(Bytes file) {
  const cv::Mat samples = PnmReader(file).samples();
  cv::Mat image;
  cv::cvtColor(samples, image, samples.channels() == 1 ? cv::COLOR_GRAY2BGR : cv::COLOR_RGB2BGR);
  return image;
}

}  // namespace sailmap::io
