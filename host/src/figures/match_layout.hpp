// Where everything stands in the match figure. All in pixels of the figure.
#pragma once

#include <opencv2/core/types.hpp>
#include <vector>

namespace sailmap {

struct MatchLayout {
  static constexpr int margin = 24;
  static constexpr int caption_size = 16;
  static constexpr int caption_room = 28;  // above each image
  static constexpr int legend_size = 14;
  static constexpr int verdict_size = 20;
  static constexpr int verdict_line = 28;
  static constexpr int text_width = 1552;  // of the verdict

  cv::Size canvas;
  cv::Rect query;
  cv::Rect candidate;
  cv::Point legend;   // where the text begins
  cv::Point verdict;  // where its first line begins
};

// Side by side; images more than three times as wide as high one above the other.
MatchLayout lay_out_match(const cv::Size& query, const cv::Size& candidate, int verdict_lines);

// A straight line that carries a label of a size.
struct LabelledLine {
  cv::Point from;
  cv::Point to;
  cv::Size label;
};

// A place for each label, its centre on its line, so that labels cover neither one another nor the
// `obstacles`; where there is no such place, the one that covers least.
std::vector<cv::Rect> place_labels(const std::vector<LabelledLine>& lines,
                                   const std::vector<cv::Rect>& obstacles);

}  // namespace sailmap
