// A place descriptor as text, as map files hold it.
#include "foreign_file.hpp"
#include "sailmap/place_descriptor.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace sailmap;
  const std::string text(data, data + size);
  const auto place = fuzz::read_foreign("place descriptor", [&] { return place_from_text(text); });
  if (!place) return 0;
  fuzz::demand(place->regions.size() <= PlaceDescriptor::max_regions, "not too many regions");
  for (const ContextRegion& region : place->regions) {
    fuzz::demand(region.varied >> feature_count == 0, "no map beyond the last");
  }
  fuzz::demand(to_text(*place) == text, "what is read is what was written");
  return 0;
}
