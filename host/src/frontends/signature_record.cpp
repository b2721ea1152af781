#include "signature_record.hpp"

#include <cmath>
#include <cstddef>
#include <string>

#include "sailmap/error.hpp"
#include "sailmap/hls/formats.hpp"
#include "sailmap/hls/signature_record.hpp"

namespace sailmap {
namespace {

namespace layout = hls::signature_record;

class Record {
 public:
  explicit Record(std::span<const std::uint32_t> words) : words_(words) {
    demand(words.size() == layout::words, "it has " + std::to_string(words.size()) + " words");
  }
  [[nodiscard]] std::uint32_t at(int word) const { return words_[static_cast<std::size_t>(word)]; }
  static void demand(bool holds, const std::string& fault) {
    if (!holds) throw Error("a signature from the hardware is damaged: " + fault);
  }

 private:
  std::span<const std::uint32_t> words_;
};

template <class Format>
float value_of(std::uint32_t raw) {
  return std::ldexp(static_cast<float>(raw), -Format::fraction);
}

Region region_of(const Record& record, int r, int width, int height) {
  const std::uint32_t place = record.at(layout::position_word(r));
  const int x = layout::low_of(place);
  const int y = layout::high_of(place);
  Record::demand(x < width && y < height, "region " + std::to_string(r) + " lies outside the frame");
  Region region{static_cast<std::int16_t>(x),
                static_cast<std::int16_t>(y),
                value_of<hls::formats::saliency>(record.at(layout::saliency_word(r))),
                {}};
  for (std::size_t i = 0; i < feature_count; ++i) {
    region.descriptor[i] =
        value_of<hls::formats::descriptor_entry>(record.at(layout::entry_word(r, static_cast<int>(i))));
  }
  return region;
}

}  // namespace

ChipParameters chip_parameters(const RegionConfig& config) {
  check_chip_regions(config);
  return {static_cast<std::uint16_t>(config.max_regions),
          static_cast<std::uint32_t>(std::lround(config.stop_ratio * layout::max_stop_ratio)),
          static_cast<std::uint16_t>(config.box_side)};
}

Signature signature_of_record(std::span<const std::uint32_t> words, int width, int height,
                              const ChipParameters& asked) {
  const Record record(words);
  Record::demand(record.at(layout::mark_word) == layout::mark_and_version,
                 "its first word is " + std::to_string(record.at(layout::mark_word)));
  const std::uint32_t size = record.at(layout::size_word);
  Record::demand(layout::low_of(size) == width && layout::high_of(size) == height,
                 "it is of a frame of " + std::to_string(layout::low_of(size)) + "x" +
                     std::to_string(layout::high_of(size)) + " pixels");
  Record::demand(record.at(layout::max_regions_word) == asked.max_regions &&
                     record.at(layout::stop_ratio_word) == asked.stop_ratio &&
                     record.at(layout::box_side_word) == asked.box_side,
                 "it was made with other parameters than were asked for");
  const std::uint32_t count = record.at(layout::count_word);
  Record::demand(count <= asked.max_regions, "it has " + std::to_string(count) + " regions");
  Signature signature{width, height, {}};
  for (int r = 0; r < static_cast<int>(count); ++r) {
    signature.regions.push_back(region_of(record, r, width, height));
  }
  return signature;
}

}  // namespace sailmap
