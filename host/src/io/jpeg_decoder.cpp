// jpeglib.h needs <cstdio> before it, and jerror.h needs jpeglib.h.
// clang-format off
#include <cstdio>
#include <jpeglib.h>
#include <jerror.h>
// clang-format on

#include <array>
#include <csetjmp>
#include <string>

#include "image_decoders.hpp"
#include "sailmap/error.hpp"

namespace sailmap::io {

namespace {

// What libjpeg's C callbacks, through `client_data`, and the C++ code share.
struct Decoder {
  jpeg_error_mgr errors{};
  jpeg_decompress_struct jpeg{};
  std::jmp_buf give_up{};
  std::string fault;
  int orientation = 1;
  cv::Mat image;

  Decoder() = default;
  Decoder(const Decoder&) = delete;
  Decoder& operator=(const Decoder&) = delete;
  Decoder(Decoder&&) = delete;
  Decoder& operator=(Decoder&&) = delete;
  ~Decoder() { jpeg_destroy_decompress(&jpeg); }
};

[[noreturn]] void stop(j_common_ptr jpeg) {
  auto* decoder = static_cast<Decoder*>(jpeg->client_data);
  std::array<char, JMSG_LENGTH_MAX> message{};
  jpeg->err->format_message(jpeg, message.data());
  const bool truncated = jpeg->err->msg_code == JWRN_JPEG_EOF;
  decoder->fault = truncated ? "truncated JPEG" : "damaged JPEG: " + std::string(message.data());
  std::longjmp(decoder->give_up, 1);
}

// libjpeg carries on after a warning, with grey or smeared blocks: stop, unless every pixel is still right.
// Stray bytes before a marker are what many cameras write; the others concern metadata.
void on_message(j_common_ptr jpeg, int level) {
  if (level != -1) return;
  switch (jpeg->err->msg_code) {
    case JWRN_EXTRANEOUS_DATA:
    case JWRN_JFIF_MAJOR:
    case JWRN_ADOBE_XFORM:
      return;
    default:
      stop(jpeg);
  }
}

void find_orientation(Decoder& decoder) {
  constexpr unsigned int header_size = 6;  // "Exif\0\0"
  for (jpeg_saved_marker_ptr m = decoder.jpeg.marker_list; m != nullptr; m = m->next) {
    if (m->data_length > header_size && std::string(m->data, m->data + 4) == "Exif") {
      decoder.orientation = exif_orientation(Bytes(m->data, m->data_length));
      return;
    }
  }
}

void check_header(const jpeg_decompress_struct& jpeg) {
  check_size(jpeg.image_width, jpeg.image_height);
  if (jpeg.jpeg_color_space == JCS_CMYK || jpeg.jpeg_color_space == JCS_YCCK) {
    throw Error("CMYK JPEG; convert it to RGB");
  }
}

// False, with `fault` set, when libjpeg gave up. No object with a destructor may live here: longjmp skips
// those.
bool run(Decoder& decoder, Bytes file) {
  if (setjmp(decoder.give_up) != 0) return false;
  jpeg_create_decompress(&decoder.jpeg);
  jpeg_mem_src(&decoder.jpeg, file.data(), file.size());
  jpeg_save_markers(&decoder.jpeg, JPEG_APP0 + 1, 0xFFFF);
  jpeg_read_header(&decoder.jpeg, TRUE);
  check_header(decoder.jpeg);
  find_orientation(decoder);
  decoder.jpeg.out_color_space = JCS_EXT_BGR;
  jpeg_start_decompress(&decoder.jpeg);
  decoder.image.create(static_cast<int>(decoder.jpeg.output_height),
                       static_cast<int>(decoder.jpeg.output_width), CV_8UC3);
  while (decoder.jpeg.output_scanline < decoder.jpeg.output_height) {
    JSAMPROW row = decoder.image.ptr(static_cast<int>(decoder.jpeg.output_scanline));
    jpeg_read_scanlines(&decoder.jpeg, &row, 1);
  }
  jpeg_finish_decompress(&decoder.jpeg);  // reads on to the end marker: a file cut just before it shows here
  return true;
}

}  // namespace

cv::Mat decode_jpeg(Bytes file) {
  Decoder decoder;
  decoder.jpeg.err = jpeg_std_error(&decoder.errors);
  decoder.jpeg.client_data = &decoder;
  decoder.errors.error_exit = stop;
  decoder.errors.emit_message = on_message;
  if (!run(decoder, file)) throw Error(decoder.fault);
  make_upright(decoder.image, decoder.orientation);
  return decoder.image;
}

}  // namespace sailmap::io
