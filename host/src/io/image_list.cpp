#include <glob.h>

#include <algorithm>
#include <string>
#include <system_error>

#include "sailmap/error.hpp"
#include "sailmap/image_source.hpp"
#include "text_lines.hpp"

namespace sailmap {

namespace {

namespace fs = std::filesystem;

bool is_a_folder(const fs::path& path) {
  std::error_code unknown;
  return fs::is_directory(path, unknown);
}

bool is_there(const fs::path& path) {
  std::error_code unknown;
  return fs::exists(path, unknown);
}

bool is_list_path(const fs::path& path) { return path.extension() == ".txt"; }

bool is_glob(const std::string& source) {
  return source.find_first_of("*?[") != std::string::npos && !is_there(source);
}

void sort_naturally(std::vector<fs::path>& paths) {
  std::ranges::sort(
      paths, [](const fs::path& a, const fs::path& b) { return natural_less(a.string(), b.string()); });
}

// Hidden files are left out: macOS strews "._0001.jpg" beside its images, which hold no pixels.
bool is_visible_image(const fs::path& path) {
  return is_image_path(path) && !path.filename().string().starts_with('.') && !is_a_folder(path);
}

std::vector<fs::path> images_of_folder(const std::string& folder) {
  std::error_code failed;
  std::vector<fs::path> images;
  for (fs::directory_iterator entry(folder, failed), end; !failed && entry != end; entry.increment(failed)) {
    if (is_visible_image(entry->path())) images.push_back(entry->path());
  }
  if (failed) throw Error(folder + ": this folder cannot be read: " + failed.message());
  if (images.empty()) throw Error(folder + ": no image in this folder");
  sort_naturally(images);
  return images;
}

// The result of glob(3), freed.
class Glob {
 public:
  explicit Glob(const std::string& pattern)
      : status_(::glob(pattern.c_str(), GLOB_ERR | GLOB_NOSORT, nullptr, &found_)) {}
  Glob(const Glob&) = delete;
  Glob& operator=(const Glob&) = delete;
  Glob(Glob&&) = delete;
  Glob& operator=(Glob&&) = delete;
  ~Glob() { ::globfree(&found_); }

  [[nodiscard]] bool failed() const { return status_ != 0 && status_ != GLOB_NOMATCH; }
  [[nodiscard]] std::vector<fs::path> paths() const {
    return status_ == 0 ? std::vector<fs::path>(found_.gl_pathv, found_.gl_pathv + found_.gl_pathc)
                        : std::vector<fs::path>{};
  }

 private:
  glob_t found_{};
  int status_;
};

std::vector<fs::path> images_of_glob(const std::string& pattern) {
  const Glob glob(pattern);
  if (glob.failed()) throw Error(pattern + ": a folder of this pattern cannot be read");
  std::vector<fs::path> images = glob.paths();
  std::erase_if(images, [](const fs::path& path) { return !is_visible_image(path); });
  if (images.empty()) throw Error(pattern + ": no image matches this pattern");
  sort_naturally(images);
  return images;
}

std::vector<fs::path> images_of_list(const fs::path& list) {
  std::vector<fs::path> images;
  for (const io::Line& line : io::read_lines(list)) {
    fs::path image = list.parent_path() / line.text;  // an absolute path stays as it is
    if (!is_there(image)) throw io::line_error(list, line, "no such file: " + image.string());
    if (is_a_folder(image)) throw io::line_error(list, line, "a folder, not an image: " + image.string());
    images.push_back(std::move(image));
  }
  if (images.empty()) throw Error(list.string() + ": no image in this list");
  return images;
}

}  // namespace

bool is_image_list(const std::string& source) {
  return is_a_folder(source) || is_list_path(source) || is_image_path(source) || is_glob(source);
}

std::vector<fs::path> list_images(const std::string& source) {
  if (is_a_folder(source)) return images_of_folder(source);
  if (is_glob(source)) return images_of_glob(source);
  if (is_list_path(source)) return images_of_list(source);
  if (!is_there(source)) throw Error(source + ": no such file or folder");
  if (!is_image_path(source)) throw Error(source + ": not a folder, glob, list file (.txt) or image");
  return {source};
}

}  // namespace sailmap
