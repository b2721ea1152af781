// Opening files for reading, with an Error that says what is wrong with them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <span>
#include <string_view>
#include <vector>

namespace sailmap::io {

// A binary stream at the start of the file. Throws Error naming the file when it is missing, a folder, or not
// readable.
std::ifstream open_for_reading(const std::filesystem::path& path);

// At most `limit` bytes from where the stream stands. Throws Error naming the file when reading fails.
std::vector<std::uint8_t> read_bytes(std::ifstream& in, const std::filesystem::path& path, std::size_t limit);

// The same bytes as characters.
std::string_view as_text(std::span<const std::uint8_t> bytes);

}  // namespace sailmap::io
