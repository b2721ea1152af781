#include "signature_bytes.hpp"

#include <bit>
#include <cmath>
#include <cstring>
#include <string>
#include <utility>

#include "sailmap/error.hpp"

namespace sailmap::store {
namespace {

static_assert(std::endian::native == std::endian::little, "numbers are written as they are in memory");

constexpr std::size_t region_bytes = 2 * sizeof(std::int16_t) + (1 + feature_count) * sizeof(float);
constexpr std::size_t layout_bytes = sizeof(Layout::words);
constexpr std::size_t context_bytes = 3 * sizeof(std::uint16_t) + feature_count * sizeof(std::uint64_t);
constexpr std::size_t match_bytes = 2 * sizeof(std::int32_t) + sizeof(double);

class Writer {
 public:
  explicit Writer(std::size_t size) { bytes_.reserve(size); }
  template <class T>
  void put(const T& value) {
    const auto* begin = static_cast<const unsigned char*>(static_cast<const void*>(&value));
    bytes_.insert(bytes_.end(), begin, begin + sizeof value);
  }
  Blob take() { return std::move(bytes_); }

 private:
  Blob bytes_;
};

class Reader {
 public:
  explicit Reader(const Blob& bytes) : next_(bytes.data()) {}
  template <class T>
  void get(T& value) {
    std::memcpy(&value, next_, sizeof value);
    next_ += sizeof value;
  }

 private:
  const unsigned char* next_;
};

std::size_t count_of(std::size_t bytes, std::size_t each, const char* what) {
  if (bytes % each != 0) throw Error(std::string(what) + " of " + std::to_string(bytes) + " bytes");
  return bytes / each;
}

void demand_inside(int value, int pixels) {
  if (value < 0 || value >= pixels) throw Error("a region's position is not a pixel of the image");
}

std::vector<Region> regions_from_bytes(const Blob& bytes, int width, int height) {
  std::vector<Region> regions(count_of(bytes.size(), region_bytes, "regions"));
  Reader reader(bytes);
  for (Region& region : regions) {
    reader.get(region.x);
    reader.get(region.y);
    reader.get(region.saliency);
    reader.get(region.descriptor);
    demand_inside(region.x, width);
    demand_inside(region.y, height);
    bool finite = std::isfinite(region.saliency);
    for (const float number : region.descriptor) finite = finite && std::isfinite(number);
    if (!finite) throw Error("a region's numbers are not finite");
  }
  return regions;
}

PlaceDescriptor place_from_bytes(const Blob& bytes) {
  PlaceDescriptor place;
  if (bytes.empty()) return place;
  if (bytes.size() < layout_bytes) throw Error("a place of " + std::to_string(bytes.size()) + " bytes");
  const std::size_t count = count_of(bytes.size() - layout_bytes, context_bytes, "a place");
  if (count > PlaceDescriptor::max_regions) throw Error("a place with too many regions");
  place.regions.resize(count);
  Reader reader(bytes);
  reader.get(place.layout.words);
  for (ContextRegion& region : place.regions) {
    reader.get(region.x);
    reader.get(region.y);
    reader.get(region.varied);
    reader.get(region.bits);
    if ((region.varied >> feature_count) != 0) throw Error("a region of unknown maps");
  }
  return place;
}

}  // namespace

Blob regions_to_bytes(const std::vector<Region>& regions) {
  Writer writer(regions.size() * region_bytes);
  for (const Region& region : regions) {
    writer.put(region.x);
    writer.put(region.y);
    writer.put(region.saliency);
    writer.put(region.descriptor);
  }
  return writer.take();
}

Blob place_to_bytes(const PlaceDescriptor& place) {
  if (place == PlaceDescriptor{}) return {};
  Writer writer(layout_bytes + place.regions.size() * context_bytes);
  writer.put(place.layout.words);
  for (const ContextRegion& region : place.regions) {
    writer.put(region.x);
    writer.put(region.y);
    writer.put(region.varied);
    writer.put(region.bits);
  }
  return writer.take();
}

Blob matches_to_bytes(const std::vector<RegionMatch>& matches) {
  Writer writer(matches.size() * match_bytes);
  for (const RegionMatch& match : matches) {
    writer.put(static_cast<std::int32_t>(match.query));
    writer.put(static_cast<std::int32_t>(match.candidate));
    writer.put(match.distance);
  }
  return writer.take();
}

Signature signature_from_row(const SignatureRow& row) {
  if (row.width < 1 || row.height < 1) throw Error("an image without pixels");
  Signature signature{row.width, row.height, regions_from_bytes(row.regions, row.width, row.height)};
  if (!row.place.empty()) signature.place = place_from_bytes(row.place);
  return signature;
}

std::vector<RegionMatch> matches_from_bytes(const Blob& bytes) {
  std::vector<RegionMatch> matches(count_of(bytes.size(), match_bytes, "matches"));
  Reader reader(bytes);
  for (RegionMatch& match : matches) {
    std::int32_t query = 0;
    std::int32_t candidate = 0;
    reader.get(query);
    reader.get(candidate);
    reader.get(match.distance);
    match.query = query;
    match.candidate = candidate;
    if (!std::isfinite(match.distance)) throw Error("a distance is not finite");
  }
  return matches;
}

}  // namespace sailmap::store
