#include <tiffio.h>

#include <algorithm>
#include <array>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <new>
#include <span>
#include <string>

#include "image_decoders.hpp"
#include "sailmap/error.hpp"

namespace sailmap::io {

namespace {

// A file in memory, as libtiff's callbacks see it.
struct Source {
  Bytes file;
  std::uint64_t position = 0;
  bool ran_out = false;
  std::string first_error;
};

tmsize_t on_read(thandle_t handle, void* to, tmsize_t size) {
  auto* source = static_cast<Source*>(handle);
  const std::uint64_t left =
      source->file.size() - std::min<std::uint64_t>(source->position, source->file.size());
  const std::uint64_t count = std::min(left, static_cast<std::uint64_t>(size));
  source->ran_out = source->ran_out || count < static_cast<std::uint64_t>(size);
  if (count > 0) std::memcpy(to, source->file.data() + source->position, count);
  source->position += count;
  return static_cast<tmsize_t>(count);
}

tmsize_t on_write(thandle_t /*handle*/, void* /*from*/, tmsize_t /*size*/) { return 0; }

toff_t on_seek(thandle_t handle, toff_t offset, int whence) {
  auto* source = static_cast<Source*>(handle);
  if (whence == SEEK_CUR) offset += source->position;
  if (whence == SEEK_END) offset += source->file.size();
  source->position = offset;
  return offset;
}

int on_close(thandle_t /*handle*/) { return 0; }

toff_t on_size(thandle_t handle) { return static_cast<Source*>(handle)->file.size(); }

int on_error(TIFF* /*tiff*/, void* user, const char* /*module*/, const char* format, va_list arguments) {
  auto* source = static_cast<Source*>(user);
  if (!source->first_error.empty()) return 1;
  std::array<char, 256> message{};
  static_cast<void>(std::vsnprintf(message.data(), message.size(), format, arguments));
  source->first_error = message.data();
  return 1;
}

// Warnings are about unknown tags, which cameras and GIS programs write freely.
int on_warning(TIFF* /*tiff*/, void* /*user*/, const char* /*module*/, const char* /*format*/,
               va_list /*arguments*/) {
  return 1;
}

using Tiff = std::unique_ptr<TIFF, decltype(&TIFFClose)>;

Tiff open_tiff(Source& source) {
  const std::unique_ptr<TIFFOpenOptions, decltype(&TIFFOpenOptionsFree)> options(TIFFOpenOptionsAlloc(),
                                                                                 &TIFFOpenOptionsFree);
  TIFFOpenOptionsSetErrorHandlerExtR(options.get(), on_error, &source);
  TIFFOpenOptionsSetWarningHandlerExtR(options.get(), on_warning, &source);
  // "m": no memory mapping, so that every byte comes through on_read.
  return {TIFFClientOpenExt("image", "rm", &source, on_read, on_write, on_seek, on_close, on_size, nullptr,
                            nullptr, options.get()),
          &TIFFClose};
}

[[noreturn]] void fail(const Source& source) {
  if (source.ran_out) throw Error("truncated TIFF");
  throw Error("TIFF that cannot be read: " + source.first_error);
}

struct Header {
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  std::uint16_t orientation = ORIENTATION_TOPLEFT;
};

Header read_header(TIFF* tiff, const Source& source) {
  Header header;
  if (TIFFGetField(tiff, TIFFTAG_IMAGEWIDTH, &header.width) == 0 ||
      TIFFGetField(tiff, TIFFTAG_IMAGELENGTH, &header.height) == 0) {
    fail(source);
  }
  check_size(header.width, header.height);
  TIFFGetFieldDefaulted(tiff, TIFFTAG_ORIENTATION, &header.orientation);
  return header;
}

}  // namespace

cv::Mat decode_tiff(Bytes file) {
  Source source{.file = file, .position = 0, .ran_out = false, .first_error = {}};
  const Tiff tiff = open_tiff(source);
  if (!tiff) fail(source);
  const Header header = read_header(tiff.get(), source);
  source.ran_out = false;
  const std::size_t pixels = std::size_t{header.width} * header.height;
  // Zeros that the system gives when they are first used: a header alone, however large its image, costs
  // none.
  const std::unique_ptr<void, decltype(&std::free)> memory(std::calloc(pixels, sizeof(std::uint32_t)),
                                                           &std::free);
  if (!memory) throw std::bad_alloc();
  const std::span<std::uint32_t> raster(static_cast<std::uint32_t*>(memory.get()), pixels);
  // Asking for the orientation that is stored leaves the pixels as they lie.
  if (TIFFReadRGBAImageOriented(tiff.get(), header.width, header.height, raster.data(), header.orientation,
                                1) == 0) {
    fail(source);
  }
  cv::Mat image(static_cast<int>(header.height), static_cast<int>(header.width), CV_8UC3);
  std::transform(raster.begin(), raster.end(), image.begin<cv::Vec3b>(), [](std::uint32_t pixel) {
    return cv::Vec3b(static_cast<std::uint8_t>(TIFFGetB(pixel)), static_cast<std::uint8_t>(TIFFGetG(pixel)),
                     static_cast<std::uint8_t>(TIFFGetR(pixel)));
  });
  make_upright(image, header.orientation);
  return image;
}

}  // namespace sailmap::io
