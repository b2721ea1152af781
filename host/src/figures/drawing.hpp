// Small drawing helpers that the figures share. Canvases are 8-bit BGR; lengths and places are pixels of the
// canvas.
#pragma once

#include <opencv2/core.hpp>
#include <opencv2/freetype.hpp>
#include <string>
#include <vector>

#include "sailmap/maps.hpp"
#include "sailmap/signature.hpp"

namespace sailmap::drawing {

inline const cv::Scalar white(255, 255, 255);
inline const cv::Scalar black(0, 0, 0);
inline const cv::Scalar ink(40, 40, 40);
inline const cv::Scalar faint_ink(110, 110, 110);

// File of the system's sans serif font, by fontconfig; empty when there is none.
std::string font_file();

// Valid UTF-8 on one line: what is not is left out, control characters become spaces.
std::string printable(const std::string& text);

// Draws lines of text in one font. Sizes are the em height in pixels.
class Text {
 public:
  // With an empty `font`: OpenCV's own stroke font, which knows ASCII alone.
  explicit Text(const std::string& font = font_file());

  // Baseline at `at.y`, from `at.x` rightwards; what lies outside the canvas is not drawn.
  void draw(cv::Mat& canvas, const std::string& text, cv::Point at, int size, const cv::Scalar& colour) const;
  // Cut in the middle, with an ellipsis, when wider than `most`.
  void draw_within(cv::Mat& canvas, const std::string& text, cv::Point at, int size, const cv::Scalar& colour,
                   int most) const;
  [[nodiscard]] int width(const std::string& text, int size) const;
  // Lines no wider than `most`, broken at spaces, and within words that are wider than a line.
  [[nodiscard]] std::vector<std::string> wrapped(const std::string& text, int size, int most) const;

 private:
  [[nodiscard]] std::string broken(const std::string& word, int size, int most) const;

  cv::Ptr<cv::freetype::FreeType2> font_;  // none: the stroke font
};

// The largest size of the shape of `image` within `bounds`, at least 1x1.
cv::Size fit(const cv::Size& image, const cv::Size& bounds);

// 8-bit images of 1, 3 or 4 channels as BGR. Throws Error, beginning with `what`, for any other or an empty
// one.
cv::Mat to_bgr(const cv::Mat& image, const std::string& what);

// `image` scaled to fill `place` exactly: linear when enlarged, averaged when reduced.
void paste(cv::Mat& canvas, const cv::Mat& image, const cv::Rect& place);

// Black for 0, white for the map's own maximum, rounded to 8-bit BGR. All black when the maximum is 0.
cv::Mat shade(const Map& map);

// The region's box in level-0 pixels, cut at the image.
cv::Rect image_box(const Region& region, const Signature& signature, int box_side);

// The region's box where the image was pasted at `place`; at least one pixel wide and high.
cv::Rect placed_box(const Region& region, const Signature& signature, int box_side, const cv::Rect& place);

// A frame of `thickness` just inside `box`, with a dark rim of one pixel, so that it shows on bright and dark
// ground.
void draw_box(cv::Mat& canvas, const cv::Rect& box, const cv::Scalar& colour, int thickness);

// Bright colours far apart: neighbours in `k` differ strongly.
cv::Scalar distinct_colour(int k);

}  // namespace sailmap::drawing
