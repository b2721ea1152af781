#include <iomanip>
#include <sstream>

#include "documents.hpp"
#include "measure.hpp"
#include "recognition.hpp"
#include "sailmap/hls/accuracy.hpp"
#include "sailmap/maps.hpp"

namespace sailmap::numbers {
namespace {

namespace accuracy = hls::accuracy;

constexpr const char* introduction = R"(# Accuracy of the fixed-point design

Made by `scripts/numbers`. Do not edit.

The `quantised` front end, which the kernels equal bit for bit, against the exact `reference`, over every image of the two real sequences.
The word lengths are those of `docs/formats.md`. Per map, over all images:

- **max error**: the largest absolute error of any pixel, in the spec's units and in LSB of the map's format;
- **max %**, **RMS %**: the largest and the root-mean-square error in percent of the exact map's own maximum in that image;
- **max %, same m**: the same over the images in which no map's m differs;
- **least maximum**: of the exact map, over the images: what the percentages are worst for;
- **other m**: images in which the map's m (eq. 1, the number of local maxima above half the maximum) differs.

)";

constexpr const char* reading = R"(
## What is stated, and where it ends

- **Feature maps.** For *every* image the error is below the bounds of `hls/accuracy.hpp`, which carry half a unit of
  each rounding through the filters at their worst: @ib@ (intensity), @cb@ (colour), @ob@ (orientation). On photographs it
  stays within @ip@, @cp@ and @op@. The aim of 0.2 % of the map's own maximum is met where that maximum is at least @if@, @cf@
  and @of@, of full scales of 6, 18 and 3. Below that a map is nearly flat (dark or blurred images of
  the corridor) and the roundings of 16-bit words weigh more.
- **Saliency.** Where every m agrees, conspicuity and saliency are within 0.5 % of their maximum. Where an m differs they are
  not, and no finite word would do: eq. 1 divides by sqrt(m), and a peak within rounding of half the maximum, or of its
  neighbour, counts or does not. The second paragraph of each sequence puts that in proportion: the exact model against itself
  when every channel of every pixel changes by at most one grey level.
- **Signature on the chip.** Regions and saliency are exact. For *every* image an entry of a descriptor is off eq. 3-4 in real numbers, on
  the same maps, by at most @ds@ of its value and @db@ more.
- **Regions.** What place recognition sees is the regions: their agreement is above.
- **Overflow.** None is possible (`hls/ranges.hpp`), and the quantised reference throws if one happened.
)";

std::string replaced(std::string text, const std::string& key, double value) {
  std::ostringstream number;
  number << std::setprecision(2) << value;
  for (std::size_t at = text.find(key); at != std::string::npos; at = text.find(key)) {
    text.replace(at, key.size(), number.str());
  }
  return text;
}

void write_table(std::ostream& out, const Summary& summary) {
  out << "| map | max error | LSB | max % | max %, same m | RMS % | least maximum | other m |\n"
         "|---|---|---|---|---|---|---|---|\n";
  for (std::size_t i = 0; i < map_count; ++i) {
    const Summary::Map& map = summary.maps[i];
    out << "| " << map_name(i) << std::scientific << std::setprecision(1) << " | " << map.largest_error
        << std::fixed << " | " << map.largest_error / map_lsb(i) << std::setprecision(3) << " | "
        << 100 * map.largest_share << " | " << 100 * map.largest_share_same_m << " | "
        << 100 * map.root_mean_square << std::setprecision(2) << " | " << map.smallest_maximum << " | ";
    if (i + 1 < map_count) out << map.other_m;
    out << " |\n";
  }
}

void write_agreement(std::ostream& out, const Summary& summary) {
  const auto percent = [&summary](int part) { return 100.0 * part / summary.regions; };
  out << std::fixed << std::setprecision(1) << summary.same_region << " of the " << summary.regions
      << " most salient regions (five an image) at the very same base-level pixel, "
      << percent(summary.same_region) << " %; " << percent(summary.near_region)
      << " % within one pixel. Some m differs in " << summary.images_other_m
      << " images; saliency is off by more than 0.5 % of its maximum somewhere in "
      << summary.images_saliency_beyond << ", its RMS error is " << std::setprecision(2)
      << 100 * summary.maps.back().root_mean_square << " %.\n\n";
}

void write_recognition(std::ostream& out, const std::filesystem::path& folder, int exclude_recent) {
  const Recognition exact = recognise(folder, exclude_recent, "reference");
  const Recognition quantised = recognise(folder, exclude_recent, "quantised");
  out << std::fixed << std::setprecision(3) << "Loop closure, average precision without the "
      << exclude_recent << " newest images: `paper_weighted` " << quantised.paper_weighted << " quantised, "
      << exact.paper_weighted << " exact; `paper` " << quantised.paper << " quantised, " << exact.paper
      << " exact.\n\n";
  // The fast front end, which equals the quantised one bit for bit.
  const Recognition chip = recognise(folder, exclude_recent, "fixed", SignatureMaker::chip);
  const SignatureDifference difference = compare_signatures(folder / "images");
  out << "Signature on the chip against the host's, of the same quantised maps: " << difference.regions
      << " regions, " << difference.other_regions
      << " at another place or of another saliency; entries of descriptors differ by at most "
      << std::scientific << std::setprecision(1) << difference.largest_entry << std::fixed
      << std::setprecision(5) << ". Average precision: `paper_weighted` " << chip.paper_weighted << " chip, "
      << quantised.paper_weighted << " host; `paper` " << chip.paper << " chip, " << quantised.paper
      << " host.\n\n";
}

void write_sequence(std::ostream& out, const Sequence& sequence, const std::filesystem::path& data) {
  const std::filesystem::path folder = data / sequence.name / "images";
  const Summary quantised = summarise(measure_folder(folder, 1, Against::quantised));
  out << "## " << sequence.name << ", " << quantised.images << " images\n\n";
  write_table(out, quantised);
  out << "\nQuantised against exact: ";
  write_agreement(out, quantised);
  out << "For comparison, exact against exact with one grey level of noise: ";
  write_agreement(out, summarise(measure_folder(folder, 1, Against::noisy)));
  write_recognition(out, data / sequence.name, sequence.exclude_recent);
  out << "Samples at the end of their word: " << quantised.saturated << ".\n\n";
}

}  // namespace

std::string accuracy_document(const std::filesystem::path& data) {
  std::ostringstream out;
  out << introduction;
  for (const Sequence& sequence : sequences) write_sequence(out, sequence, data);
  std::string text = reading;
  text = replaced(text, "@ib@", accuracy::intensity_feature_bound);
  text = replaced(text, "@cb@", accuracy::colour_feature_bound);
  text = replaced(text, "@ob@", accuracy::orientation_feature_bound);
  text = replaced(text, "@ip@", accuracy::intensity_feature_photographs);
  text = replaced(text, "@cp@", accuracy::colour_feature_photographs);
  text = replaced(text, "@op@", accuracy::orientation_feature_photographs);
  text = replaced(text, "@if@", accuracy::intensity_feature_floor);
  text = replaced(text, "@cf@", accuracy::colour_feature_floor);
  text = replaced(text, "@of@", accuracy::orientation_feature_floor);
  text = replaced(text, "@ds@", accuracy::descriptor_share);
  text = replaced(text, "@db@", accuracy::descriptor_bound);
  text = replaced(text, "@half@", accuracy::lsb<hls::formats::colour_feature>() / 2);
  return out.str() + text.substr(1);
}

}  // namespace sailmap::numbers
