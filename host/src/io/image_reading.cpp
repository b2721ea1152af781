#include <algorithm>
#include <array>
#include <cctype>
#include <fstream>
#include <limits>
#include <new>
#include <opencv2/core.hpp>
#include <string>
#include <string_view>

#include "file_reading.hpp"
#include "image_decoders.hpp"
#include "sailmap/error.hpp"
#include "sailmap/image_source.hpp"

namespace sailmap {

namespace {

using Decode = cv::Mat (*)(io::Bytes);

// The longest of the beginnings by which a format is known: "RIFF", four bytes of size, "WEBP".
constexpr std::size_t signature_size = 12;

bool is_pnm(std::string_view file) {
  return file.size() >= 3 && file[0] == 'P' && file[1] >= '1' && file[1] <= '6' &&
         (std::isspace(static_cast<unsigned char>(file[2])) != 0 || file[2] == '#');
}

// The decoder for a file that begins so; null when it is no image. The content decides: extensions lie.
Decode decoder_for(std::string_view file) {
  using namespace std::string_view_literals;
  if (file.starts_with("\xFF\xD8\xFF"sv)) return io::decode_jpeg;
  if (file.starts_with("\x89PNG\r\n\x1A\n"sv)) return io::decode_png;
  if (file.starts_with("II*\0"sv) || file.starts_with("MM\0*"sv) || file.starts_with("II+\0"sv) ||
      file.starts_with("MM\0+"sv))
    return io::decode_tiff;
  if (file.starts_with("RIFF"sv) && file.substr(std::min<std::size_t>(8, file.size())) == "WEBP"sv) {
    return io::decode_webp;
  }
  if (file.starts_with("BM"sv)) return io::decode_bmp;
  return is_pnm(file) ? io::decode_pnm : nullptr;
}

// Lower case, with the dot.
std::string extension_of(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  std::ranges::transform(extension, extension.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

cv::Mat decode(const std::filesystem::path& path, Decode decoder, io::Bytes file) {
  try {
    return decoder(file);
  } catch (const Error& fault) {
    throw Error(path.string() + ": " + fault.what());
  } catch (const cv::Exception& fault) {
    throw Error(path.string() + ": cannot be decoded: " + fault.err);
  } catch (const std::bad_alloc&) {
    throw Error(path.string() + ": not enough memory for this image");
  }
}

}  // namespace

bool is_image_path(const std::filesystem::path& path) {
  static constexpr std::array<std::string_view, 14> extensions = {".bmp", ".dib", ".jfif", ".jpe", ".jpeg",
                                                                  ".jpg", ".pbm", ".pgm",  ".png", ".pnm",
                                                                  ".ppm", ".tif", ".tiff", ".webp"};
  const std::string extension = extension_of(path);
  return std::ranges::find(extensions, extension) != extensions.end();
}

cv::Mat read_image(const std::filesystem::path& path) {
  std::ifstream in = io::open_for_reading(path);
  std::vector<std::uint8_t> file = io::read_bytes(in, path, signature_size);
  if (file.empty()) throw Error(path.string() + ": empty file");
  const Decode decoder = decoder_for(io::as_text(file));
  if (decoder == nullptr) {
    throw Error(path.string() +
                ": not an image (JPEG, PNG, TIFF, WebP, BMP or PNM), or cut in its first bytes");
  }
  const auto rest = io::read_bytes(in, path, std::numeric_limits<std::int32_t>::max() - signature_size);
  file.insert(file.end(), rest.begin(), rest.end());
  return decode(path, decoder, file);
}

ImageView view_of(const cv::Mat& bgr) {
  if (bgr.type() != CV_8UC3 || bgr.dims != 2) throw Error("image: not 8-bit BGR");
  return {bgr.cols, bgr.rows, bgr.data, static_cast<std::ptrdiff_t>(bgr.step[0]), ChannelOrder::bgr};
}

}  // namespace sailmap
