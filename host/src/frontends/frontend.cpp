#include "sailmap/frontend.hpp"

#include "frontends.hpp"
#include "sailmap/error.hpp"

namespace sailmap {
namespace {

struct Entry {
  const char* name;
  std::unique_ptr<Frontend> (*make)();
};
constexpr Entry entries[] = {{"fixed", make_fixed},
                             {"reference", make_reference},
                             {"quantised", make_quantised},
                             {"csim", make_csim},
                             {"xrt", make_xrt}};

}  // namespace

std::vector<std::string> frontend_names() {
  std::vector<std::string> names;
  for (const Entry& entry : entries) names.emplace_back(entry.name);
  return names;
}

std::unique_ptr<Frontend> make_frontend(std::string_view name) {
  for (const Entry& entry : entries) {
    if (name == entry.name) return entry.make();
  }
  std::string known;
  for (const std::string& other : frontend_names()) known += (known.empty() ? "" : ", ") + other;
  throw Error("no front end '" + std::string(name) + "'; there are: " + known);
}

void check_image_size(const ImageView& image) {
  using namespace hls::geometry;
  if (valid_side(image.width) && valid_side(image.height)) return;
  throw Error("image is " + std::to_string(image.width) + "x" + std::to_string(image.height) +
              " pixels; each side must be " + std::to_string(min_image_side) + " to " +
              std::to_string(max_image_side));
}

}  // namespace sailmap
