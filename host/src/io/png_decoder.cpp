#include <png.h>

#include <algorithm>
#include <csetjmp>
#include <cstring>
#include <string>
#include <vector>

#include "image_decoders.hpp"
#include "sailmap/error.hpp"

namespace sailmap::io {

namespace {

struct Decoder {
  Bytes unread;
  png_structp png = nullptr;
  png_infop info = nullptr;
  std::string fault;
  int orientation = 1;
  cv::Mat image;
  std::vector<png_bytep> rows;

  explicit Decoder(Bytes file) : unread(file) {}
  Decoder(const Decoder&) = delete;
  Decoder& operator=(const Decoder&) = delete;
  Decoder(Decoder&&) = delete;
  Decoder& operator=(Decoder&&) = delete;
  ~Decoder() { png_destroy_read_struct(&png, &info, nullptr); }
};

[[noreturn]] void on_error(png_structp png, png_const_charp message) {
  auto* decoder = static_cast<Decoder*>(png_get_error_ptr(png));
  if (decoder->fault.empty()) decoder->fault = std::string("damaged PNG: ") + message;
  png_longjmp(png, 1);
}

// Warnings are about metadata (colour profiles and the like), which is not used.
void on_warning(png_structp /*png*/, png_const_charp /*message*/) {}

void on_read(png_structp png, png_bytep to, std::size_t size) {
  auto* decoder = static_cast<Decoder*>(png_get_io_ptr(png));
  if (size > decoder->unread.size()) {
    decoder->fault = "truncated PNG";
    png_error(png, "end of file");
  }
  std::memcpy(to, decoder->unread.data(), size);
  decoder->unread = decoder->unread.subspan(size);
}

// Whatever is stored, 8-bit BGR comes out; alpha is dropped, as cv::imread does, and 16 bits are rounded
// to 8.
void ask_for_bgr(png_structp png, png_infop info) {
  png_set_expand(png);
  png_set_scale_16(png);
  png_set_gray_to_rgb(png);
  png_set_strip_alpha(png);
  png_set_bgr(png);
  png_set_interlace_handling(png);
  png_read_update_info(png, info);
}

void make_image(Decoder& decoder) {
  const png_uint_32 width = png_get_image_width(decoder.png, decoder.info);
  const png_uint_32 height = png_get_image_height(decoder.png, decoder.info);
  check_size(width, height);
  decoder.image.create(static_cast<int>(height), static_cast<int>(width), CV_8UC3);
  decoder.rows.resize(height);
  for (png_uint_32 y = 0; y < height; ++y) decoder.rows[y] = decoder.image.ptr(static_cast<int>(y));
}

void find_orientation(Decoder& decoder) {
  png_bytep exif = nullptr;
  png_uint_32 size = 0;
  if (png_get_eXIf_1(decoder.png, decoder.info, &size, &exif) == 0) return;
  std::vector<std::uint8_t> block = {'E', 'x', 'i', 'f', 0, 0};
  block.insert(block.end(), exif, exif + size);
  decoder.orientation = exif_orientation(block);
}

// False, with `fault` set, when libpng gave up. No object with a destructor may live here: longjmp skips
// those.
bool run(Decoder& decoder) {
  if (setjmp(png_jmpbuf(decoder.png)) != 0) return false;
  png_set_read_fn(decoder.png, &decoder, on_read);
  png_read_info(decoder.png, decoder.info);
  ask_for_bgr(decoder.png, decoder.info);
  make_image(decoder);
  png_read_image(decoder.png, decoder.rows.data());
  png_read_end(decoder.png, decoder.info);
  find_orientation(decoder);
  return true;
}

}  // namespace

cv::Mat decode_png(Bytes file) {
  Decoder decoder(file);
  decoder.png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &decoder, on_error, on_warning);
  if (decoder.png != nullptr) decoder.info = png_create_info_struct(decoder.png);
  if (decoder.info == nullptr) throw Error("not enough memory for a PNG decoder");
  if (!run(decoder)) throw Error(decoder.fault);
  make_upright(decoder.image, decoder.orientation);
  return decoder.image;
}

}  // namespace sailmap::io
