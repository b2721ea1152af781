// List files, and the natural order of names.
#include <algorithm>
#include <vector>

#include "foreign_file.hpp"
#include "io/text_lines.hpp"
#include "sailmap/image_source.hpp"

namespace {

// A strict total order, or std::sort may run out of its array.
void check_order(const std::vector<std::string>& names) {
  using sailmap::natural_less;
  for (const std::string& a : names) {
    for (const std::string& b : names) {
      sailmap::fuzz::demand((a == b) == (!natural_less(a, b) && !natural_less(b, a)),
                            "equal names alone tie");
      for (const std::string& c : names) {
        sailmap::fuzz::demand(!natural_less(a, b) || !natural_less(b, c) || natural_less(a, c), "a < b < c");
      }
    }
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace sailmap;
  constexpr std::size_t most_names = 12;
  static fuzz::ForeignFile file(".txt");
  const std::filesystem::path& path = file.hold(data, size);
  const auto images = fuzz::read_foreign(path, [&] { return list_images(path); });
  if (images) {
    fuzz::demand(!images->empty(), "there is an image");
    for (const auto& image : *images) {
      fuzz::demand(std::filesystem::exists(image) && !std::filesystem::is_directory(image),
                   "a listed image is a file");
    }
  }
  const auto lines = fuzz::read_foreign(path, [&] { return io::read_lines(path); });
  if (!lines) return 0;
  std::vector<std::string> names;
  for (const io::Line& line : *lines) {
    if (names.size() < most_names) names.push_back(line.text);
  }
  check_order(names);
  return 0;
}
