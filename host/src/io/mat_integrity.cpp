#include "mat_integrity.hpp"

#include <boost/iostreams/copy.hpp>
#include <boost/iostreams/device/array.hpp>
#include <boost/iostreams/device/null.hpp>
#include <boost/iostreams/filter/zlib.hpp>
#include <boost/iostreams/filtering_stream.hpp>
#include <cstdint>
#include <limits>
#include <span>
#include <string_view>

#include "file_reading.hpp"
#include "sailmap/error.hpp"

namespace sailmap::io {

namespace {

// The format is described in MathWorks, "MAT-File Format", chapter "Level 5 MAT-File Format".
constexpr std::size_t header_size = 128;
constexpr std::size_t version_at = 124;
constexpr std::size_t tag_size = 8;
constexpr std::uint32_t compressed_element = 15;

using Bytes = std::span<const std::uint8_t>;

// True when the numbers of the file begin with their least significant byte: the writer's 'MI' reads "IM".
bool is_little_endian(const std::filesystem::path& path, Bytes file) {
  if (file.size() >= header_size) {
    const std::uint8_t first = file[header_size - 2];
    const std::uint8_t second = file[header_size - 1];
    if (first == 'I' && second == 'M') return true;
    if (first == 'M' && second == 'I') return false;
  }
  throw Error(path.string() + ": not a MATLAB file of version 5 to 7.2 (save it with -v7)");
}

std::uint32_t number(Bytes file, std::size_t at, std::size_t size, bool little_endian) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < size; ++i) {
    value = value << 8U | file[little_endian ? at + size - 1 - i : at + i];
  }
  return value;
}

void check_compressed(const std::filesystem::path& path, Bytes element) {
  namespace streams = boost::iostreams;
  try {
    streams::filtering_istream in;
    in.push(streams::zlib_decompressor());
    const std::string_view packed = as_text(element);
    in.push(streams::array_source(packed.data(), packed.size()));
    in.exceptions(std::ios::badbit);
    streams::copy(in, streams::null_sink());
  } catch (const std::ios_base::failure&) {
    throw Error(path.string() + ": damaged MATLAB file: a compressed variable cannot be unpacked");
  }
}

}  // namespace

void check_mat_file(const std::filesystem::path& path) {
  std::ifstream in = open_for_reading(path);
  const auto bytes = read_bytes(in, path, std::numeric_limits<std::int32_t>::max());
  const Bytes file = bytes;
  const bool little_endian = is_little_endian(path, file);
  if (number(file, version_at, 2, little_endian) != 0x0100) {
    throw Error(path.string() + ": not a MATLAB file of version 5 to 7.2 (save it with -v7)");
  }
  for (std::size_t at = header_size; at < file.size();) {
    const std::size_t left = file.size() - at;
    if (left < tag_size) throw Error(path.string() + ": truncated MATLAB file");
    const std::uint32_t type = number(file, at, 4, little_endian);
    const std::size_t size = number(file, at + 4, 4, little_endian);
    if (size > left - tag_size) throw Error(path.string() + ": truncated MATLAB file");
    if (type == compressed_element) check_compressed(path, file.subspan(at + tag_size, size));
    at += tag_size + size;
  }
}

}  // namespace sailmap::io
