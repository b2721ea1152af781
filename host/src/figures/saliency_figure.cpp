// As the paper's Fig. 2: image, feature maps, conspicuity maps, saliency and regions in one picture.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "drawing.hpp"
#include "sailmap/error.hpp"
#include "sailmap/figures.hpp"
#include "sailmap/ref/normalise.hpp"
#include "sailmap/ref/policy.hpp"
#include "saliency_layout.hpp"

namespace sailmap {
namespace {

using L = SaliencyLayout;
const cv::Scalar region_colour(0, 230, 255);
const cv::Scalar frame_colour(190, 190, 190);

class Figure {
 public:
  Figure(const drawing::Text& text, const SaliencyLayout& layout)
      : text_(text), canvas_(layout.canvas, CV_8UC3, drawing::white) {}

  void title(const std::vector<std::string>& lines) {
    int y = L::margin + L::title_size;
    for (const std::string& line : lines) {
      text_.draw(canvas_, line, {L::margin, y}, L::title_size, drawing::ink);
      y += L::title_line;
    }
  }

  void heading(const Heading& heading) {
    text_.draw(canvas_, heading.text, heading.baseline, L::heading_size, drawing::ink);
    const cv::Point rule = heading.baseline + cv::Point(0, 9);
    cv::line(canvas_, rule, rule + cv::Point(heading.width - 1, 0), frame_colour, 1);
  }

  // `image` at `place`, beneath it the caption centred in `room` pixels.
  void panel(const cv::Mat& image, const cv::Rect& place, const std::string& caption, int room) {
    drawing::paste(canvas_, image, place);
    const cv::Rect rim(place.x - 1, place.y - 1, place.width + 2, place.height + 2);
    cv::rectangle(canvas_, rim, frame_colour, 1);
    const int width = std::min(room, text_.width(caption, L::caption_size));
    text_.draw_within(canvas_, caption,
                      {place.x + (place.width - width) / 2, place.br().y + L::caption_room - 8},
                      L::caption_size, drawing::ink, room);
  }

  // Boxes numbered by rank; the most salient last, so that they lie on top.
  void regions(const cv::Rect& place, const Signature& signature, int box_side) {
    cv::Mat panel = canvas_(place);
    std::vector<cv::Rect> boxes;
    for (const Region& region : signature.regions) {
      boxes.push_back(drawing::placed_box(region, signature, box_side, {{0, 0}, place.size()}));
    }
    for (std::size_t k = boxes.size(); k-- > 0;) drawing::draw_box(panel, boxes[k], region_colour, 2);
    ranks(panel, boxes);
  }

  [[nodiscard]] cv::Mat picture() const { return canvas_; }

 private:
  // A tag in one corner of each box, where it covers no tag of a more salient region if there is such a
  // corner. Boxes too small for a tag have none.
  void ranks(cv::Mat& panel, const std::vector<cv::Rect>& boxes) {
    constexpr int size = 13;
    std::vector<cv::Rect> tags;
    for (std::size_t k = 0; k < boxes.size(); ++k) {
      const cv::Rect& box = boxes[k];
      const std::string number = std::to_string(k + 1);
      const cv::Size tag(text_.width(number, size) + 6, size + 3);
      if (4 * tag.width > 3 * box.width || 4 * tag.height > 3 * box.height) continue;
      const cv::Rect place = least_covering(corners(box, tag), tags);
      tags.push_back(place);
      cv::rectangle(panel, place, region_colour, cv::FILLED);
      text_.draw(panel, number, {place.x + 2, place.br().y - 3}, size, drawing::black);
    }
  }

  static std::array<cv::Rect, 4> corners(const cv::Rect& box, const cv::Size& tag) {
    const cv::Point far = box.br() - cv::Point(tag.width, tag.height);
    return {cv::Rect(box.tl(), tag), cv::Rect({far.x, box.y}, tag), cv::Rect({box.x, far.y}, tag),
            cv::Rect(far, tag)};
  }

  static cv::Rect least_covering(const std::array<cv::Rect, 4>& places, const std::vector<cv::Rect>& tags) {
    const auto covered = [&tags](const cv::Rect& place) {
      int area = 0;
      for (const cv::Rect& tag : tags) area += (place & tag).area();
      return area;
    };
    return *std::ranges::min_element(places, {}, covered);
  }

  const drawing::Text& text_;
  cv::Mat canvas_;
};

MapStatistics statistics(const Map& map) {
  if (map.width() == 0) throw Error("saliency figure: a map is empty");
  return ref::statistics(map.values(), ref::Exact::tie);
}

std::string caption(std::string_view name, const MapStatistics& s) {
  return fmt::format("{}: max {:.3g}, m = {}", name, s.maximum, s.maxima);
}

void check(const cv::Mat& image, const Maps& maps, const Signature& signature, int box_side) {
  const auto same = [&image](int width, int height) { return image.cols == width && image.rows == height; };
  if (!same(maps.image_width, maps.image_height) || !same(signature.width, signature.height)) {
    throw Error(fmt::format(
        "saliency figure: the image is {}x{} pixels, but its maps are of {}x{} and its signature "
        "is of {}x{}",
        image.cols, image.rows, maps.image_width, maps.image_height, signature.width, signature.height));
  }
  if (box_side < 1) throw Error(fmt::format("saliency figure: box side {} is below 1", box_side));
}

}  // namespace

cv::Mat saliency_figure(const cv::Mat& image, const Maps& maps, const Signature& signature, int box_side,
                        const std::string& title) {
  const cv::Mat bgr = drawing::to_bgr(image, "saliency figure");
  check(bgr, maps, signature, box_side);
  const drawing::Text text;
  const int room = lay_out_saliency(bgr.size(), 0).canvas.width - 2 * L::margin;
  const std::vector<std::string> title_lines = text.wrapped(title, L::title_size, room);
  const SaliencyLayout layout = lay_out_saliency(bgr.size(), static_cast<int>(title_lines.size()));

  Figure figure(text, layout);
  figure.title(title_lines);
  const std::size_t count = signature.regions.size();
  figure.panel(bgr, layout.image,
               fmt::format("image, {} x {}, and its {} salient region{} by rank", bgr.cols, bgr.rows, count,
                           count == 1 ? "" : "s"),
               layout.big_room);
  figure.panel(drawing::shade(maps.saliency), layout.saliency,
               fmt::format("saliency: max {:.3g}; the box of each region", statistics(maps.saliency).maximum),
               layout.big_room);
  for (const cv::Rect& place : {layout.image, layout.saliency}) figure.regions(place, signature, box_side);

  for (const Heading& heading : layout.feature_headings) figure.heading(heading);
  for (std::size_t i = 0; i < feature_count; ++i) {
    figure.panel(drawing::shade(maps.features[i]), layout.features[i],
                 caption(feature_names[i], maps.feature_statistics[i]), layout.feature_rooms[i]);
  }
  figure.heading(layout.conspicuity_heading);
  for (std::size_t k = 0; k < conspicuity_count; ++k) {
    constexpr std::array<std::string_view, conspicuity_count> kinds = {"intensity", "colour", "orientation"};
    figure.panel(drawing::shade(maps.conspicuities[k]), layout.conspicuities[k],
                 caption(kinds[k], maps.conspicuity_statistics[k]), layout.conspicuity_rooms[k]);
  }
  return figure.picture();
}

}  // namespace sailmap
