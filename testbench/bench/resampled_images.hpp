// Signatures of real images, and as many more like them as one wants.
#pragma once

#include <cstdint>
#include <random>
#include <vector>

#include "sailmap/signature.hpp"

namespace sailmap::bench {

// Of every fifth image of the sequence gardens_point; the last quarter of its way is kept for queries. Each
// new signature is one of the others seen from elsewhere: moved, half of them mirrored, a quarter of the
// regions from another image, descriptors changed by 15 %. What makes images of different places alike by
// chance (layout, colours, positions of regions) stays as it is in the real ones.
class ResampledImages {
 public:
  // Whether the images are there, see SAILMAP_DATA.
  static bool available();

  // Throws Error when an image cannot be read.
  ResampledImages();

  Signature next();
  [[nodiscard]] const std::vector<Signature>& queries() const { return queries_; }

 private:
  const Signature& any() { return images_[random_() % images_.size()]; }
  Region moved(Region region, const Signature& image, double dx, double dy);

  std::mt19937_64 random_{1};
  std::vector<Signature> images_;
  std::vector<Signature> queries_;
};

}  // namespace sailmap::bench
