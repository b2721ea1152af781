// Images as the page shows them, read by their names and looked at again with the map's own front end.
#pragma once

#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <opencv2/core/mat.hpp>
#include <string>

#include "sailmap/frontend.hpp"
#include "sailmap/signature.hpp"

namespace sailmap::report {

// An image, read and described.
struct Look {
  cv::Mat image;        // 8-bit BGR; smaller than the signature says when it is a thumbnail
  Maps maps;            // empty when there is no front end
  Signature signature;  // with the regions that the method numbers; no regions when there is no front end
};

// Seconds of each step, summed.
struct LookTimes {
  int images = 0;
  double read = 0;
  double maps = 0;
  double regions = 0;
  [[nodiscard]] double total() const { return read + maps + regions; }
};

// Not safe for two threads at once on one object.
class Looker {
 public:
  // An empty front end reads alone. Throws Error when there is no front end of that name.
  Looker(const std::string& frontend, const RegionConfig& regions, std::filesystem::path image_root);

  // Throws Error, naming the image, when it cannot be read or is too small for the front end.
  Look look(const std::string& name);
  [[nodiscard]] const LookTimes& times() const { return times_; }

 private:
  [[nodiscard]] std::filesystem::path find(const std::string& name) const;

  std::unique_ptr<Frontend> frontend_;
  RegionConfig regions_;
  std::filesystem::path image_root_;
  LookTimes times_;
};

// JPEG, no side longer than `longest` pixels.
std::string jpeg_uri(const cv::Mat& image, int longest, int quality);

// {"width", "height" (of the image), "photo", "saliency": [saliency, intensity, colour, orientation]}: data
// URIs; the maps in the viridis palette from 0 to their own maximum, [] when there are none.
nlohmann::ordered_json picture_of(const Look& look, int longest);

// [x, y, width, height, ...] of the regions, pixels of the image.
nlohmann::ordered_json boxes_of(const Signature& signature, int box_side);

}  // namespace sailmap::report
