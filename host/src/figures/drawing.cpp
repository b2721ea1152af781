#include "drawing.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "sailmap/error.hpp"

namespace sailmap::drawing {

cv::Size fit(const cv::Size& image, const cv::Size& bounds) {
  const double scale = std::min(static_cast<double>(bounds.width) / image.width,
                                static_cast<double>(bounds.height) / image.height);
  return {std::max(1, cvRound(image.width * scale)), std::max(1, cvRound(image.height * scale))};
}

cv::Mat to_bgr(const cv::Mat& image, const std::string& what) {
  if (image.empty()) throw Error(what + ": there is no image");
  cv::Mat out;
  switch (image.type()) {
    case CV_8UC3:
      return image;
    case CV_8UC1:
      cv::cvtColor(image, out, cv::COLOR_GRAY2BGR);
      return out;
    case CV_8UC4:
      cv::cvtColor(image, out, cv::COLOR_BGRA2BGR);
      return out;
    default:
      throw Error(what + ": the image does not have 8-bit pixels of 1, 3 or 4 channels");
  }
}

void paste(cv::Mat& canvas, const cv::Mat& image, const cv::Rect& place) {
  cv::Mat scaled;
  const bool enlarged = place.width > image.cols;
  cv::resize(image, scaled, place.size(), 0, 0, enlarged ? cv::INTER_LINEAR : cv::INTER_AREA);
  scaled.copyTo(canvas(place));
}

cv::Mat shade(const Map& map) {
  const Plane<double> values = map.values();
  if (values.empty()) throw Error("figure: a map is empty");
  const auto samples = values.samples();
  const double maximum = *std::max_element(samples.begin(), samples.end());
  cv::Mat out(values.height(), values.width(), CV_8UC3, black);
  if (!(maximum > 0)) return out;
  for (int y = 0; y < out.rows; ++y) {
    for (int x = 0; x < out.cols; ++x) {
      const auto grey = cv::saturate_cast<std::uint8_t>(255 * values(x, y) / maximum);
      out.at<cv::Vec3b>(y, x) = {grey, grey, grey};
    }
  }
  return out;
}

cv::Rect image_box(const Region& region, const Signature& signature, int box_side) {
  constexpr int scale = hls::geometry::base_scale;
  const auto base = [](int position) { return cvRound(static_cast<double>(position) / scale); };
  const Peak peak{base(region.x), base(region.y), region.saliency};
  const Box box = region_box(peak, box_side, hls::geometry::base_side(signature.width),
                             hls::geometry::base_side(signature.height));
  const cv::Rect whole(0, 0, signature.width, signature.height);
  return cv::Rect(box.x0 * scale, box.y0 * scale, (box.x1 - box.x0) * scale, (box.y1 - box.y0) * scale) &
         whole;
}

cv::Rect placed_box(const Region& region, const Signature& signature, int box_side, const cv::Rect& place) {
  const cv::Rect box = image_box(region, signature, box_side);
  const double sx = static_cast<double>(place.width) / signature.width;
  const double sy = static_cast<double>(place.height) / signature.height;
  const cv::Point from(cvRound(box.x * sx), cvRound(box.y * sy));
  const cv::Point to(cvRound(box.br().x * sx), cvRound(box.br().y * sy));
  const cv::Point corner(std::min(from.x, place.width - 1), std::min(from.y, place.height - 1));
  return {place.tl() + corner, cv::Size(std::max(1, to.x - from.x), std::max(1, to.y - from.y))};
}

void draw_box(cv::Mat& canvas, const cv::Rect& box, const cv::Scalar& colour, int thickness) {
  const auto frame = [&](int inset, const cv::Scalar& shade) {
    const cv::Rect inner(box.x + inset, box.y + inset, box.width - 2 * inset, box.height - 2 * inset);
    if (inner.width > 0 && inner.height > 0) cv::rectangle(canvas, inner, shade, 1);
  };
  frame(-1, black);
  for (int i = 0; i < thickness; ++i) frame(i, colour);
  frame(thickness, black);
}

cv::Scalar distinct_colour(int k) {
  // Steps of the golden angle round the colour circle never come close to an earlier colour for long.
  constexpr double golden_degrees = 137.508;
  const double hue = std::fmod(20 + k * golden_degrees, 360);
  const cv::Mat3f hsv(1, 1, cv::Vec3f(static_cast<float>(hue), 0.8F, 1.0F));
  cv::Mat3f bgr;
  cv::cvtColor(hsv, bgr, cv::COLOR_HSV2BGR);
  const cv::Vec3f colour = bgr(0, 0) * 255;
  return {std::round(colour[0]), std::round(colour[1]), std::round(colour[2])};
}

}  // namespace sailmap::drawing
