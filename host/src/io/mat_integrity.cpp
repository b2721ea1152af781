#include "mat_integrity.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <boost/iostreams/copy.hpp>
#include <boost/iostreams/device/array.hpp>
#include <boost/iostreams/device/null.hpp>
#include <boost/iostreams/filter/zlib.hpp>
#include <boost/iostreams/filtering_stream.hpp>
#include <cstdint>
#include <istream>
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

constexpr std::uint32_t matrix_element = 14;
constexpr const char* damaged_variable = "damaged MATLAB file: impossible sizes in a variable";

using Bytes = std::span<const std::uint8_t>;

// The numbers of a file, of one order of bytes.
class Numbers {
 public:
  explicit Numbers(bool little_endian) : little_endian_(little_endian) {}

  [[nodiscard]] std::uint32_t at(Bytes bytes, std::size_t at, std::size_t size) const {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < size; ++i) {
      value = value << 8U | bytes[little_endian_ ? at + size - 1 - i : at + i];
    }
    return value;
  }

 private:
  bool little_endian_;
};

// 'MI' as the writer's number: a file that begins with the least significant byte has "IM".
Numbers numbers_of(Bytes file) {
  if (file.size() >= header_size) {
    const std::uint8_t first = file[header_size - 2];
    const std::uint8_t second = file[header_size - 1];
    if (first == 'I' && second == 'M') return Numbers(true);
    if (first == 'M' && second == 'I') return Numbers(false);
  }
  throw Error("not a MATLAB file of version 5 to 7.2 (save it with -v7)");
}

// Goes through the parts of one variable, because matio believes their sizes: a few bytes may ask it for
// gigabytes. Cells, structures and objects hold variables again, to any depth; they are no ground truth.
class Variable {
 public:
  Variable(std::istream& in, const Numbers& numbers) : in_(in), numbers_(numbers) {}

  void check() {
    const Tag variable = tag();
    if (variable.type != matrix_element) throw Error(damaged_variable);
    left_ = variable.size;
    check_class();
    check_part(int32_part, most_dimensions * sizeof(std::int32_t));
    check_part(int8_part, most_letters);
    while (left_ > 0) skip(part());
  }

 private:
  static constexpr std::uint32_t int8_part = 1;
  static constexpr std::uint32_t int32_part = 5;
  static constexpr std::uint32_t uint32_part = 6;
  static constexpr std::uint32_t most_dimensions = 32;
  static constexpr std::uint32_t most_letters = 4096;  // of a name; MATLAB's own limit is 63

  struct Tag {
    std::uint32_t type = 0;
    std::uint32_t size = 0;
    bool small = false;  // up to four bytes stand in the tag itself
  };

  std::array<std::uint8_t, tag_size> eight_bytes() {
    std::array<char, tag_size> bytes{};
    if (!in_.read(bytes.data(), bytes.size())) throw Error(damaged_variable);
    return std::bit_cast<std::array<std::uint8_t, tag_size>>(bytes);
  }

  Tag tag() {
    const auto bytes = eight_bytes();
    const std::uint32_t type = numbers_.at(bytes, 0, 4);
    if (type >> 16U != 0) return {type & 0xFFFFU, type >> 16U, true};
    return {type, numbers_.at(bytes, 4, 4), false};
  }

  // The tag of the next part, which ends within the variable.
  Tag part() {
    if (left_ < tag_size) throw Error(damaged_variable);
    left_ -= tag_size;
    const Tag found = tag();
    if (found.size > (found.small ? tag_size / 2 : left_)) throw Error(damaged_variable);
    return found;
  }

  // Parts are filled up to eight bytes, but for the last one of some writers.
  void skip(const Tag& tag) {
    if (tag.small) return;
    const std::size_t size = std::min(left_, (tag.size + tag_size - 1) / tag_size * tag_size);
    in_.ignore(static_cast<std::streamsize>(size));
    if (in_.gcount() != static_cast<std::streamsize>(size)) throw Error(damaged_variable);
    left_ -= size;
  }

  void check_class() {
    constexpr std::uint32_t first_of_values = 4;  // text; then sparse matrices, and numbers of all kinds
    constexpr std::uint32_t last_of_values = 15;
    const Tag flags = part();
    if (flags.type != uint32_part || flags.size != tag_size) throw Error(damaged_variable);
    const auto bytes = eight_bytes();
    left_ -= tag_size;
    const std::uint32_t kind = numbers_.at(bytes, 0, 4) & 0xFFU;
    if (kind < first_of_values || kind > last_of_values) {
      throw Error("holds cells, structures or objects; save the matrix alone");
    }
  }

  void check_part(std::uint32_t type, std::uint32_t most) {
    const Tag found = part();
    if (found.type != type || found.size > most) throw Error(damaged_variable);
    skip(found);
  }

  std::istream& in_;
  const Numbers& numbers_;
  std::size_t left_ = 0;  // bytes of the variable
};

void check_variable(Bytes element, bool compressed, const Numbers& numbers) {
  namespace streams = boost::iostreams;
  try {
    streams::filtering_istream in;
    if (compressed) in.push(streams::zlib_decompressor());
    const std::string_view text = as_text(element);
    in.push(streams::array_source(text.data(), text.size()));
    in.exceptions(std::ios::badbit);
    Variable(in, numbers).check();
    in.clear();
    streams::copy(in, streams::null_sink());  // the check sum is at the end
  } catch (const std::ios_base::failure&) {
    throw Error("damaged MATLAB file: a compressed variable cannot be unpacked");
  }
}

void check_bytes(Bytes file) {
  const Numbers numbers = numbers_of(file);
  if (numbers.at(file, version_at, 2) != 0x0100) {
    throw Error("not a MATLAB file of version 5 to 7.2 (save it with -v7)");
  }
  for (std::size_t at = header_size; at < file.size();) {
    const std::size_t left = file.size() - at;
    if (left < tag_size) throw Error("truncated MATLAB file");
    const bool compressed = numbers.at(file, at, 4) == compressed_element;
    const std::size_t size = numbers.at(file, at + 4, 4);
    if (size > left - tag_size) throw Error("truncated MATLAB file");
    // What is compressed has a tag of its own inside.
    const std::size_t begin = compressed ? at + tag_size : at;
    check_variable(file.subspan(begin, at + tag_size + size - begin), compressed, numbers);
    at += tag_size + size;
  }
}

}  // namespace

void check_mat_file(const std::filesystem::path& path) {
  std::ifstream in = open_for_reading(path);
  const auto bytes = read_bytes(in, path, std::numeric_limits<std::int32_t>::max());
  try {
    check_bytes(bytes);
  } catch (const Error& fault) {
    throw Error(path.string() + ": " + fault.what());
  }
}

}  // namespace sailmap::io
