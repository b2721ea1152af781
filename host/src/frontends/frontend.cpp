#include "sailmap/frontend.hpp"

#include "frontends.hpp"
#include "sailmap/error.hpp"

namespace sailmap {
namespace {

struct Entry {
  const char* name;
  std::unique_ptr<Frontend> (*make)();
  bool has_raw_maps;  // the hardware's integers
};
constexpr Entry entries[] = {{"fixed", make_fixed, true},
                             {"reference", make_reference, false},
                             {"quantised", make_quantised, true},
                             {"csim", make_csim, true},
                             {"xrt", make_xrt, true}};

}  // namespace

void Frontend::describe(const ImageView& image, const RegionConfig& regions, Maps& maps,
                        Signature& signature) {
  compute(image, maps);
  signature = make_signature(maps, regions);
}

void check_signature(std::string_view frontend, const RegionConfig& regions) {
  if (regions.signature != SignatureMaker::chip) return;
  check_chip_regions(regions);
  for (const Entry& entry : entries) {
    if (frontend == entry.name && !entry.has_raw_maps) {
      throw Error("signature on the chip: the front end '" + std::string(frontend) +
                  "' computes in floating point");
    }
  }
}

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

std::unique_ptr<Frontend> make_frontend_without_hardware(std::string_view name) {
  return make_frontend(name == "xrt" ? "fixed" : name);
}

void check_image_size(const ImageView& image) {
  using namespace hls::geometry;
  if (valid_side(image.width) && valid_side(image.height)) return;
  throw Error("image is " + std::to_string(image.width) + "x" + std::to_string(image.height) +
              " pixels; each side must be " + std::to_string(min_image_side) + " to " +
              std::to_string(max_image_side));
}

}  // namespace sailmap
