// Where everything stands in the saliency figure. All in pixels of the figure.
#pragma once

#include <array>
#include <opencv2/core/types.hpp>
#include <string>

#include "sailmap/maps.hpp"

namespace sailmap {

// A heading with a rule beneath it, as wide as the panels it is over.
struct Heading {
  std::string text;
  cv::Point baseline;  // where the text begins
  int width = 0;
};

struct SaliencyLayout {
  static constexpr int margin = 30;
  static constexpr int title_size = 24;
  static constexpr int title_line = 34;
  static constexpr int heading_size = 19;
  static constexpr int caption_size = 14;
  static constexpr int caption_room = 26;  // beneath each panel

  cv::Size canvas;
  cv::Rect image;
  cv::Rect saliency;
  std::array<cv::Rect, feature_count> features;
  std::array<cv::Rect, conspicuity_count> conspicuities;
  std::array<int, feature_count> feature_rooms{};  // width that a caption may take
  std::array<int, conspicuity_count> conspicuity_rooms{};
  int big_room = 0;
  std::array<Heading, conspicuity_count> feature_headings;
  Heading conspicuity_heading;
};

// Width of the figure, and of a line of its title, before the layout is known.
inline constexpr int saliency_figure_width = 1600;

// Image and saliency large on top (one above the other when wide), the feature maps in five columns by kind,
// the conspicuity map of each kind beneath its features. Images more than eight times as wide as high have
// all panels one above the other, at full width. `title_lines` lines of title on top.
SaliencyLayout lay_out_saliency(const cv::Size& image, int title_lines);

}  // namespace sailmap
