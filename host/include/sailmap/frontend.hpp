// The one interface between the image and everything after it (design: four realisations, one algorithm).
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "sailmap/maps.hpp"
#include "sailmap/ref/plane.hpp"
#include "sailmap/signature.hpp"

namespace sailmap {

class Frontend {
 public:
  virtual ~Frontend() = default;
  // "reference", ...: as given to make_frontend.
  [[nodiscard]] virtual std::string_view name() const = 0;
  // Fills `maps`, reusing its memory. Throws Error when a side is outside 64..4096 pixels. Not safe to call
  // from two threads at once on one object: give each thread its own.
  virtual void compute(const ImageView& image, Maps& maps) = 0;
  // The image's signature, and its maps where the front end hands them out; else `maps` is empty afterwards,
  // and who needs them calls compute. Throws Error as compute and make_signature do. A front end that runs on
  // hardware, or simulates it, makes the signature there when `regions` says so; others with make_signature.
  virtual void describe(const ImageView& image, const RegionConfig& regions, Maps& maps,
                        Signature& signature);
};

// The names make_frontend takes, the default first.
std::vector<std::string> frontend_names();

// Throws Error, saying why, when that front end cannot make signatures so configured: SignatureMaker::chip.
void check_signature(std::string_view frontend, const RegionConfig& regions);

// Throws Error when there is no front end of that name.
std::unique_ptr<Frontend> make_frontend(std::string_view name);

// One with the same maps, bit for bit, that needs no hardware: `fixed` for `xrt`. To look again at the images
// of a map that was made on a card, which need not be there any more.
std::unique_ptr<Frontend> make_frontend_without_hardware(std::string_view name);

}  // namespace sailmap
