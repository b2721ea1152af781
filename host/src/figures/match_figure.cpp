// As the paper's Fig. 5 and 6: two images side by side, matched regions joined.
#include <fmt/format.h>

#include <algorithm>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <sstream>
#include <vector>

#include "drawing.hpp"
#include "sailmap/figures.hpp"

namespace sailmap {
namespace {

constexpr int margin = 20;
constexpr int gap = 40;
constexpr int line_height = 30;
constexpr double text_height = 13;
constexpr int panel_width = 700;
const cv::Scalar unmatched(225, 225, 225);

std::vector<std::string> wrapped(const std::string& text, int width) {
  std::vector<std::string> lines(1);
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    const std::string longer = lines.back().empty() ? word : lines.back() + " " + word;
    if (!lines.back().empty() && text_width(longer, text_height) > width) {
      lines.push_back(word);
    } else {
      lines.back() = longer;
    }
  }
  return lines;
}

cv::Rect panel_box(const Region& region, const Signature& signature, int box_side, const cv::Rect& panel) {
  return placed(image_box(region, signature, box_side), {signature.width, signature.height}, panel);
}

cv::Point centre(const cv::Rect& box) { return {box.x + box.width / 2, box.y + box.height / 2}; }

void draw_all_regions(cv::Mat& canvas, const Signature& signature, int box_side, const cv::Rect& panel) {
  for (const Region& region : signature.regions) {
    draw_box(canvas, panel_box(region, signature, box_side, panel), unmatched, 2);
  }
}

void draw_distance(cv::Mat& canvas, const cv::Point& at, double distance, const cv::Scalar& colour) {
  const std::string text = fmt::format("{:.2f}", distance);
  const int width = text_width(text, 9);
  cv::rectangle(canvas, cv::Rect(at.x - width / 2 - 3, at.y - 8, width + 6, 16), white, cv::FILLED);
  cv::rectangle(canvas, cv::Rect(at.x - width / 2 - 3, at.y - 8, width + 6, 16), colour, 1);
  draw_text(canvas, text, {at.x, at.y + 5}, 9, ink, Anchor::centre);
}

}  // namespace

cv::Mat match_figure(const cv::Mat& query, const cv::Mat& candidate, const Signature& query_signature,
                     const Signature& candidate_signature, const MatchResult& match, int box_side,
                     const std::string& verdict) {
  const double shape = std::clamp(static_cast<double>(query.rows) / query.cols, 0.2, 2.0);
  const int panel_height = cvRound(panel_width * shape);
  const std::vector<std::string> lines = wrapped(verdict, 2 * panel_width + gap);
  cv::Mat canvas(2 * margin + panel_height + line_height * static_cast<int>(lines.size()) + 8,
                 2 * margin + 2 * panel_width + gap, CV_8UC3, white);
  const cv::Rect left(margin, margin, panel_width, panel_height);
  const cv::Rect right(margin + panel_width + gap, margin, panel_width, panel_height);
  paste(canvas, query, left);
  paste(canvas, candidate, right);
  draw_all_regions(canvas, query_signature, box_side, left);
  draw_all_regions(canvas, candidate_signature, box_side, right);

  const int count = static_cast<int>(match.matches.size());
  for (int k = 0; k < count; ++k) {
    const RegionMatch& m = match.matches[static_cast<std::size_t>(k)];
    const cv::Scalar colour = hue(k, count);
    const cv::Rect from = panel_box(query_signature.regions[static_cast<std::size_t>(m.query)],
                                    query_signature, box_side, left);
    const cv::Rect to = panel_box(candidate_signature.regions[static_cast<std::size_t>(m.candidate)],
                                  candidate_signature, box_side, right);
    draw_box(canvas, from, colour, 2);
    draw_box(canvas, to, colour, 2);
    cv::line(canvas, centre(from), centre(to), {0, 0, 0}, 4, cv::LINE_AA);
    cv::line(canvas, centre(from), centre(to), colour, 2, cv::LINE_AA);
  }
  // Labels last, spread along the lines so that they do not cover one another.
  for (int k = 0; k < count; ++k) {
    const RegionMatch& m = match.matches[static_cast<std::size_t>(k)];
    const cv::Point from = centre(panel_box(query_signature.regions[static_cast<std::size_t>(m.query)],
                                            query_signature, box_side, left));
    const cv::Point to = centre(panel_box(candidate_signature.regions[static_cast<std::size_t>(m.candidate)],
                                          candidate_signature, box_side, right));
    const double t = 0.35 + 0.3 * (k % 4) / 3.0;
    draw_distance(canvas, {cvRound(from.x + t * (to.x - from.x)), cvRound(from.y + t * (to.y - from.y))},
                  m.distance, hue(k, count));
  }
  int y = margin + panel_height + line_height;
  for (const std::string& line : lines) {
    draw_text(canvas, line, {margin, y}, text_height, ink);
    y += line_height;
  }
  return canvas;
}

}  // namespace sailmap
