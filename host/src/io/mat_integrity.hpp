// Is a MATLAB file whole? matio fills up what is missing from a cut or damaged one and says nothing.
#pragma once

#include <filesystem>

namespace sailmap::io {

// Throws Error naming the file when it is missing, not of MATLAB's version 5 to 7.2 (one format), cut short,
// or when a variable is damaged or no
// array of numbers or text.
void check_mat_file(const std::filesystem::path& path);

}  // namespace sailmap::io
