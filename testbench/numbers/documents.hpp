// The text of the documents that are made from the numbers themselves.
#pragma once

#include <filesystem>
#include <string>

namespace sailmap::numbers {

// docs/formats.md: the table of hls/formats.hpp.
std::string formats_document();

// docs/accuracy.md: quantised against exact over every image of the sequences in `data`. Takes a minute or
// two. Throws std::filesystem::filesystem_error when a sequence is not there.
std::string accuracy_document(const std::filesystem::path& data);

}  // namespace sailmap::numbers
