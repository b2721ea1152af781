#include "sailmap/file.hpp"

#include <unistd.h>

#include <fstream>
#include <system_error>

#include "sailmap/error.hpp"

namespace sailmap {

void write_file(const std::filesystem::path& path, const std::function<void(std::ostream&)>& write) {
  std::filesystem::path temporary = path;
  temporary += ".part" + std::to_string(::getpid());
  try {
    std::ofstream out(temporary, std::ios::binary);
    if (out) write(out);
    out.flush();
    if (!out) throw Error(path.string() + ": cannot be written");
    out.close();
    std::error_code failed;
    std::filesystem::rename(temporary, path, failed);
    if (failed) throw Error(path.string() + ": cannot be written: " + failed.message());
  } catch (...) {
    std::error_code ignored;
    std::filesystem::remove(temporary, ignored);
    throw;
  }
}

void make_folder(const std::filesystem::path& path) {
  std::error_code failed;
  std::filesystem::create_directories(path, failed);
  if (failed) throw Error(path.string() + ": cannot make this folder: " + failed.message());
}

}  // namespace sailmap
