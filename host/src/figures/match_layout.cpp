#include "match_layout.hpp"

#include <algorithm>

#include "drawing.hpp"

namespace sailmap {
namespace {

using L = MatchLayout;

constexpr int least_gap = 32;
constexpr int legend_room = 30;
constexpr int tallest = 760;
constexpr int widest_side_by_side = 3;  // times as wide as high

bool is_wide(const cv::Size& image) { return image.width > widest_side_by_side * image.height; }

}  // namespace

MatchLayout lay_out_match(const cv::Size& query, const cv::Size& candidate, int verdict_lines) {
  MatchLayout out;
  const bool stacked = is_wide(query) || is_wide(candidate);
  const int room = stacked ? L::text_width : (L::text_width - least_gap) / 2;
  const cv::Size a = drawing::fit(query, {room, tallest});
  const cv::Size b = drawing::fit(candidate, {room, tallest});
  const int top = L::margin + L::caption_room;
  if (stacked) {
    out.query = cv::Rect({L::margin, top}, a);
    out.candidate = cv::Rect({L::margin, out.query.br().y + least_gap / 2 + L::caption_room}, b);
  } else {
    // Narrow images stand close to each other, so that the lines between them are short, but leave room for
    // labels.
    const int gap = least_gap + (room - std::max(a.width, b.width)) / 4;
    const int left = L::margin + (L::text_width - a.width - gap - b.width) / 2;
    out.query = cv::Rect({left, top}, a);
    out.candidate = cv::Rect({left + a.width + gap, top}, b);
  }
  const int bottom = std::max(out.query.br().y, out.candidate.br().y);
  out.legend = {L::margin, bottom + legend_room - 6};
  out.verdict = {L::margin, bottom + legend_room + L::verdict_line - 6};
  out.canvas = {L::text_width + 2 * L::margin,
                bottom + legend_room + verdict_lines * L::verdict_line + L::margin};
  return out;
}

std::vector<cv::Rect> place_labels(const std::vector<LabelledLine>& lines,
                                   const std::vector<cv::Rect>& obstacles) {
  std::vector<cv::Rect> placed;
  for (const LabelledLine& line : lines) {
    const auto at = [&line](double part) {
      const cv::Point centre(cvRound(line.from.x + part * (line.to.x - line.from.x)),
                             cvRound(line.from.y + part * (line.to.y - line.from.y)));
      return cv::Rect(centre - cv::Point(line.label.width / 2, line.label.height / 2), line.label);
    };
    const auto covered = [&](const cv::Rect& label) {
      int area = 0;
      for (const cv::Rect& other : placed)
        area += 4 * (label & other).area();  // labels hide labels altogether
      for (const cv::Rect& other : obstacles) area += (label & other).area();
      return area;
    };
    cv::Rect best = at(0.5);
    for (int step = 1; step <= 40 && covered(best) > 0; ++step) {
      for (const double part : {0.5 - step * 0.01, 0.5 + step * 0.01}) {
        const cv::Rect label = at(part);
        if (covered(label) < covered(best)) best = label;
      }
    }
    placed.push_back(best);
  }
  return placed;
}

}  // namespace sailmap
