#include "pictures.hpp"

#include <algorithm>
#include <chrono>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <system_error>
#include <utility>
#include <vector>

#include "base64.hpp"
#include "figures/drawing.hpp"
#include "sailmap/context.hpp"
#include "sailmap/error.hpp"
#include "sailmap/image_source.hpp"

namespace sailmap::report {
namespace {

namespace fs = std::filesystem;

constexpr int photo_quality = 82;
constexpr int map_side = 160;
constexpr int map_quality = 84;

class Clock {
 public:
  // Seconds since it was last asked.
  double lap() {
    const auto now = std::chrono::steady_clock::now();
    return std::chrono::duration<double>(now - std::exchange(last_, now)).count();
  }

 private:
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

bool is_file(const fs::path& path) {
  std::error_code unknown;
  return fs::is_regular_file(path, unknown);
}

cv::Mat coloured(const Map& map) {
  cv::Mat grey;
  cv::Mat out;
  cv::cvtColor(drawing::shade(map), grey, cv::COLOR_BGR2GRAY);
  cv::applyColorMap(grey, out, cv::COLORMAP_VIRIDIS);
  return out;
}

}  // namespace

Looker::Looker(const std::string& frontend, const RegionConfig& regions, fs::path image_root)
    : frontend_(frontend.empty() ? nullptr : make_frontend_without_hardware(frontend)),
      regions_(regions),
      image_root_(std::move(image_root)) {}

// As it is named, or below the root, or of that file name in the root itself.
fs::path Looker::find(const std::string& name) const {
  const fs::path path(name);
  if (is_file(path) || image_root_.empty()) return path;
  const fs::path below = image_root_ / path.relative_path();
  if (is_file(below)) return below;
  const fs::path in_root = image_root_ / path.filename();
  return is_file(in_root) ? in_root : path;
}

Look Looker::look(const std::string& name) {
  const fs::path path = find(name);
  if (!is_file(path)) throw Error(name + ": no such image file");
  Look out;
  Clock clock;
  out.image = read_image(path);
  times_.read += clock.lap();
  ++times_.images;
  out.signature.width = out.image.cols;
  out.signature.height = out.image.rows;
  if (!frontend_) return out;
  try {
    frontend_->compute(view_of(out.image), out.maps);
  } catch (const Error& fault) {
    throw Error(name + ": " + fault.what());
  }
  times_.maps += clock.lap();
  out.signature = make_signature(out.maps, regions_);
  times_.regions += clock.lap();
  return out;
}

std::string jpeg_uri(const cv::Mat& image, int longest, int quality) {
  cv::Mat shown = image;
  if (std::max(image.cols, image.rows) > longest) {
    cv::resize(image, shown, drawing::fit(image.size(), {longest, longest}), 0, 0, cv::INTER_AREA);
  }
  std::vector<std::uint8_t> bytes;
  cv::imencode(".jpg", shown, bytes, {cv::IMWRITE_JPEG_QUALITY, quality, cv::IMWRITE_JPEG_OPTIMIZE, 1});
  return "data:image/jpeg;base64," + base64(bytes);
}

nlohmann::ordered_json picture_of(const Look& look, int longest) {
  nlohmann::ordered_json maps = nlohmann::ordered_json::array();
  if (!look.maps.empty()) {
    maps.push_back(jpeg_uri(coloured(look.maps.saliency), map_side, map_quality));
    for (const Map& map : look.maps.conspicuities) {
      maps.push_back(jpeg_uri(coloured(map), map_side, map_quality));
    }
  }
  return {{"width", look.signature.width},
          {"height", look.signature.height},
          {"photo", jpeg_uri(look.image, longest, photo_quality)},
          {"saliency", std::move(maps)}};
}

nlohmann::ordered_json boxes_of(const Signature& signature, int box_side) {
  nlohmann::ordered_json boxes = nlohmann::ordered_json::array();
  for (const Region& region : signature.regions) {
    const cv::Rect box = drawing::image_box(region, signature, box_side);
    for (const int number : {box.x, box.y, box.width, box.height}) boxes.push_back(number);
  }
  return boxes;
}

}  // namespace sailmap::report
