// Writing files so that nobody ever sees half of one.
#pragma once

#include <filesystem>
#include <functional>
#include <ostream>

namespace sailmap {

// Calls `write` with a stream to a temporary file beside `path` and renames it to `path` when all went well;
// otherwise the temporary file is removed and `path` is as it was. Throws Error naming the file when it
// cannot be written.
void write_file(const std::filesystem::path& path, const std::function<void(std::ostream&)>& write);

// Makes a folder and its parents. Throws Error naming it when that fails.
void make_folder(const std::filesystem::path& path);

}  // namespace sailmap
