// As the paper's Fig. 2: image, feature maps, conspicuity maps, saliency and regions in one picture.
#include <fmt/format.h>

#include <algorithm>
#include <opencv2/core.hpp>

#include "drawing.hpp"
#include "sailmap/figures.hpp"

namespace sailmap {
namespace {

constexpr int margin = 24;
constexpr int gap = 14;
constexpr int caption = 20;  // room under a panel
constexpr int heading = 34;  // room above a row
constexpr double caption_height = 9;
constexpr double heading_height = 13;
const cv::Scalar region_colour(0, 220, 255);

// Widths of a panel in each row, and their heights by the image's shape. Four maps stand in a row, two big
// panels above them.
struct Layout {
  int small_width = 380;
  int small_height = 0;
  int big_width = 0;
  int big_height = 0;

  explicit Layout(const cv::Size& image) {
    // Very wide and very tall images are held to a shape that a page can show.
    const double shape = std::clamp(static_cast<double>(image.height) / image.width, 0.2, 2.0);
    big_width = 2 * small_width + gap;
    small_height = cvRound(small_width * shape);
    big_height = cvRound(big_width * shape);
  }
  [[nodiscard]] int width() const { return 2 * margin + 4 * small_width + 3 * gap; }
  [[nodiscard]] int small_row() const { return small_height + caption; }
  [[nodiscard]] int height() const {
    return 2 * margin + heading + big_height + caption + 4 * (heading + small_row());
  }
};

class Figure {
 public:
  explicit Figure(const Layout& layout)
      : layout_(layout), canvas_(layout.height(), layout.width(), CV_8UC3, white) {}

  void head(const std::string& text) {
    draw_text(canvas_, text, {margin, y_ + heading - 11}, heading_height, ink, Anchor::left,
              layout_.width() - 2 * margin);
    y_ += heading;
  }

  cv::Rect big(int column, const cv::Mat& image, const std::string& text) {
    return panel({margin + column * (layout_.big_width + gap), y_, layout_.big_width, layout_.big_height},
                 image, text);
  }
  cv::Rect small(int column, const cv::Mat& image, const std::string& text) {
    return panel(
        {margin + column * (layout_.small_width + gap), y_, layout_.small_width, layout_.small_height}, image,
        text);
  }
  void big_row_done() { y_ += layout_.big_height + caption; }
  void small_row_done() { y_ += layout_.small_row(); }

  cv::Mat& canvas() { return canvas_; }

 private:
  cv::Rect panel(const cv::Rect& place, const cv::Mat& image, const std::string& text) {
    paste(canvas_, image, place);
    draw_text(canvas_, text, {place.x, place.y + place.height + caption - 6}, caption_height, faint_ink,
              Anchor::left, place.width);
    return place;
  }

  Layout layout_;
  cv::Mat canvas_;
  int y_ = margin;
};

// Boxes with their rank, the most salient last so that it lies on top.
void draw_regions(cv::Mat& canvas, const cv::Rect& place, const Signature& signature, int box_side) {
  for (std::size_t k = signature.regions.size(); k-- > 0;) {
    const Region& region = signature.regions[k];
    const cv::Size size(signature.width, signature.height);
    const cv::Rect box = placed(image_box(region, signature, box_side), size, place);
    draw_box(canvas, box, region_colour, k == 0 ? 3 : 1);
    const std::string rank = std::to_string(k + 1);
    const cv::Point at(box.x + 5, box.y + 15);
    draw_text(canvas, rank, at + cv::Point(1, 1), caption_height, {0, 0, 0});
    draw_text(canvas, rank, at, caption_height, region_colour);
  }
}

std::string feature_caption(const Maps& maps, std::size_t i) {
  const MapStatistics& s = maps.feature_statistics[i];
  return fmt::format("{}   max {:.3g}, m = {}", feature_names[i], s.maximum, s.maxima);
}

void feature_row(Figure& figure, const Maps& maps, std::size_t first, std::size_t count) {
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t i = first + k;
    figure.small(static_cast<int>(k), shade(maps.features[i]), feature_caption(maps, i));
  }
}

}  // namespace

cv::Mat saliency_figure(const cv::Mat& image, const Maps& maps, const Signature& signature, int box_side,
                        const std::string& title) {
  using namespace hls::geometry;
  Figure figure{Layout(image.size())};
  figure.head(title);
  const cv::Rect left = figure.big(0, image, fmt::format("image, {}x{}", image.cols, image.rows));
  const cv::Rect right =
      figure.big(1, shade(maps.saliency),
                 fmt::format("saliency S, {} regions by falling saliency", signature.regions.size()));
  for (const cv::Rect& place : {left, right}) draw_regions(figure.canvas(), place, signature, box_side);
  figure.big_row_done();
  figure.head("Conspicuity: sums of the normalised maps of one kind");
  for (std::size_t k = 0; k < conspicuity_count; ++k) {
    figure.small(static_cast<int>(k), shade(maps.conspicuities[k]), std::string(conspicuity_names[k]));
  }
  figure.small_row_done();
  figure.head("Intensity");
  feature_row(figure, maps, 0, intensity_maps);
  figure.small_row_done();
  figure.head("Colour");
  feature_row(figure, maps, intensity_maps, colour_maps);
  figure.small_row_done();
  figure.head("Orientation");
  feature_row(figure, maps, intensity_maps + colour_maps, orientation_maps);
  return figure.canvas();
}

}  // namespace sailmap
