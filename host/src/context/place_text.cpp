// A place descriptor as text: hexadecimal digits, words in the order of the structures.
#include <string>

#include "sailmap/error.hpp"
#include "sailmap/place_descriptor.hpp"

namespace sailmap {
namespace {

constexpr std::size_t word_digits = 16;
constexpr std::size_t layout_words = 2 * Layout::columns;
constexpr std::size_t region_words = 1 + feature_count;

void append(std::string& text, std::uint64_t word) {
  constexpr const char* digits = "0123456789abcdef";
  for (int shift = 60; shift >= 0; shift -= 4) text += digits[(word >> shift) & 0xF];
}

std::uint64_t word_at(const std::string& text, std::size_t index) {
  std::uint64_t word = 0;
  for (std::size_t i = index * word_digits; i < (index + 1) * word_digits; ++i) {
    const char digit = text[i];
    const bool decimal = digit >= '0' && digit <= '9';
    if (!decimal && (digit < 'a' || digit > 'f')) {
      throw Error("place descriptor: no hexadecimal digits at word " + std::to_string(index));
    }
    word = word << 4U | static_cast<std::uint64_t>(decimal ? digit - '0' : digit - 'a' + 10);
  }
  return word;
}

}  // namespace

std::string to_text(const PlaceDescriptor& place) {
  std::string text;
  for (const auto& column : place.layout.words) {
    for (const std::uint64_t word : column) append(text, word);
  }
  for (const ContextRegion& region : place.regions) {
    append(text, region.x | (std::uint64_t{region.y} << 16) | (std::uint64_t{region.varied} << 32));
    for (const std::uint64_t word : region.bits) append(text, word);
  }
  return text;
}

PlaceDescriptor place_from_text(const std::string& text) {
  const std::size_t words = text.size() / word_digits;
  const std::size_t regions = words < layout_words ? 0 : (words - layout_words) / region_words;
  if (text.size() != (layout_words + regions * region_words) * word_digits ||
      regions > PlaceDescriptor::max_regions) {
    throw Error("place descriptor: " + std::to_string(text.size()) + " characters are of no descriptor");
  }
  PlaceDescriptor place;
  std::size_t next = 0;
  for (auto& column : place.layout.words) {
    for (std::uint64_t& word : column) word = word_at(text, next++);
  }
  for (std::size_t r = 0; r < regions; ++r) {
    ContextRegion region;
    const std::uint64_t head = word_at(text, next++);
    if ((head >> (32 + feature_count)) != 0) throw Error("place descriptor: a region of unknown maps");
    region.x = static_cast<std::uint16_t>(head);
    region.y = static_cast<std::uint16_t>(head >> 16);
    region.varied = static_cast<std::uint16_t>(head >> 32);
    for (std::uint64_t& word : region.bits) word = word_at(text, next++);
    place.regions.push_back(region);
  }
  return place;
}

}  // namespace sailmap
