#include "file_reading.hpp"

#include <algorithm>
#include <cerrno>
#include <system_error>

#include "sailmap/error.hpp"

namespace sailmap::io {

std::ifstream open_for_reading(const std::filesystem::path& path) {
  std::error_code unknown;
  const auto status = std::filesystem::status(path, unknown);
  if (status.type() == std::filesystem::file_type::not_found) throw Error(path.string() + ": no such file");
  if (status.type() == std::filesystem::file_type::directory) {
    throw Error(path.string() + ": a folder, not a file");
  }
  errno = 0;
  std::ifstream in(path, std::ios::binary);
  if (!in) throw Error(path.string() + ": cannot be read: " + std::generic_category().message(errno));
  return in;
}

std::vector<std::uint8_t> read_bytes(std::ifstream& in, const std::filesystem::path& path,
                                     std::size_t limit) {
  constexpr std::size_t block = std::size_t{1} << 16U;
  std::vector<std::uint8_t> bytes;
  while (in && bytes.size() < limit) {
    const std::size_t old_size = bytes.size();
    const std::size_t wanted = std::min(block, limit - old_size);
    bytes.resize(old_size + wanted);
    in.read(static_cast<char*>(static_cast<void*>(bytes.data() + old_size)),
            static_cast<std::streamsize>(wanted));
    bytes.resize(old_size + static_cast<std::size_t>(in.gcount()));
  }
  if (in.bad()) throw Error(path.string() + ": reading failed");
  return bytes;
}

std::string_view as_text(std::span<const std::uint8_t> bytes) {
  return {static_cast<const char*>(static_cast<const void*>(bytes.data())), bytes.size()};
}

}  // namespace sailmap::io
