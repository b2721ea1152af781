// As the paper's Fig. 5 and 6: two images side by side, matched regions joined.
#include <fmt/format.h>

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "drawing.hpp"
#include "match_layout.hpp"
#include "sailmap/error.hpp"
#include "sailmap/figures.hpp"

namespace sailmap {
namespace {

using L = MatchLayout;
const cv::Scalar unmatched_colour(215, 215, 215);

// One of the two images with its regions, and where it stands.
struct Panel {
  cv::Mat image;
  const Signature& signature;
  cv::Rect place;

  [[nodiscard]] cv::Rect box(std::size_t region, int box_side) const {
    return drawing::placed_box(signature.regions[region], signature, box_side, place);
  }
};

// A matched pair as it is drawn.
struct Pair {
  cv::Rect from;
  cv::Rect to;
  cv::Scalar colour;
  std::string distance;
};

cv::Point centre(const cv::Rect& box) { return {box.x + box.width / 2, box.y + box.height / 2}; }

void check(const cv::Mat& image, const Signature& signature, const char* which) {
  if (image.cols == signature.width && image.rows == signature.height) return;
  throw Error(fmt::format("match figure: the {} is {}x{} pixels, but its signature is of {}x{}", which,
                          image.cols, image.rows, signature.width, signature.height));
}

void check(const MatchResult& match, const Signature& query, const Signature& candidate) {
  const auto is_region = [](int i, const Signature& s) {
    return i >= 0 && i < static_cast<int>(s.regions.size());
  };
  for (const RegionMatch& m : match.matches) {
    if (is_region(m.query, query) && is_region(m.candidate, candidate)) continue;
    throw Error(fmt::format("match figure: regions {} and {} are matched, but there are {} and {} regions",
                            m.query, m.candidate, query.regions.size(), candidate.regions.size()));
  }
}

// Two significant digits, and two decimals where they are no fewer.
std::string distance_text(double distance) {
  return distance == 0 || distance >= 0.1 ? fmt::format("{:.2f}", distance) : fmt::format("{:.2g}", distance);
}

std::vector<Pair> pairs_of(const MatchResult& match, const Panel& query, const Panel& candidate,
                           int box_side) {
  std::vector<Pair> pairs;
  for (std::size_t k = 0; k < match.matches.size(); ++k) {
    const RegionMatch& m = match.matches[k];
    pairs.push_back({query.box(static_cast<std::size_t>(m.query), box_side),
                     candidate.box(static_cast<std::size_t>(m.candidate), box_side),
                     drawing::distinct_colour(static_cast<int>(k)), distance_text(m.distance)});
  }
  return pairs;
}

void draw_panel(cv::Mat& canvas, const Panel& panel, int box_side) {
  drawing::paste(canvas, panel.image, panel.place);
  cv::Mat inside = canvas(panel.place);
  for (const Region& region : panel.signature.regions) {
    const cv::Rect box = drawing::placed_box(region, panel.signature, box_side, {{0, 0}, panel.place.size()});
    drawing::draw_box(inside, box, unmatched_colour, 1);
  }
}

void draw_pairs(cv::Mat& canvas, const std::vector<Pair>& pairs) {
  for (const Pair& pair : pairs) {
    cv::line(canvas, centre(pair.from), centre(pair.to), drawing::black, 4, cv::LINE_AA);
    cv::line(canvas, centre(pair.from), centre(pair.to), pair.colour, 2, cv::LINE_AA);
  }
  for (const Pair& pair : pairs) {
    drawing::draw_box(canvas, pair.from, pair.colour, 3);
    drawing::draw_box(canvas, pair.to, pair.colour, 3);
  }
}

void draw_distances(cv::Mat& canvas, const std::vector<Pair>& pairs, const drawing::Text& text) {
  constexpr int size = 13;
  std::vector<LabelledLine> lines;
  std::vector<cv::Rect> boxes;
  for (const Pair& pair : pairs) {
    lines.push_back({centre(pair.from), centre(pair.to), {text.width(pair.distance, size) + 10, size + 5}});
    boxes.insert(boxes.end(), {pair.from, pair.to});
  }
  const std::vector<cv::Rect> labels = place_labels(lines, boxes);
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    cv::rectangle(canvas, labels[k], pairs[k].colour, cv::FILLED);
    cv::rectangle(canvas, labels[k], drawing::black, 1);
    text.draw(canvas, pairs[k].distance, {labels[k].x + 5, labels[k].br().y - 5}, size, drawing::black);
  }
}

void draw_words(cv::Mat& canvas, const MatchLayout& layout, const MatchResult& match,
                const std::vector<std::string>& verdict, const drawing::Text& text) {
  const std::string legend =
      match.matches.empty()
          ? fmt::format("similarity {:.4g}; no region matched", match.similarity)
          : fmt::format("similarity {:.4g}; {} matched region{}, the numbers are descriptor distances",
                        match.similarity, match.matches.size(), match.matches.size() == 1 ? "" : "s");
  text.draw(canvas, legend, layout.legend, L::legend_size, drawing::faint_ink);
  cv::Point at = layout.verdict;
  for (const std::string& line : verdict) {
    text.draw(canvas, line, at, L::verdict_size, drawing::ink);
    at.y += L::verdict_line;
  }
}

std::string caption(const char* which, const Signature& signature) {
  const std::size_t count = signature.regions.size();
  return fmt::format("{}: {} region{}", which, count, count == 1 ? "" : "s");
}

void draw_captions(cv::Mat& canvas, const Panel& query, const Panel& candidate, const drawing::Text& text) {
  const cv::Point above(0, -9);
  const std::string left = caption("query", query.signature);
  const int width = text.width(left, L::caption_size);
  cv::Point at = query.place.tl() + above;
  // Beside another one a narrow image has its caption end with it.
  const bool beside = query.place.y == candidate.place.y;
  if (beside && width > query.place.width) at.x = query.place.br().x - width;
  text.draw(canvas, left, at, L::caption_size, drawing::ink);
  text.draw(canvas, caption("candidate", candidate.signature), candidate.place.tl() + above, L::caption_size,
            drawing::ink);
}

}  // namespace

cv::Mat match_figure(const cv::Mat& query, const cv::Mat& candidate, const Signature& query_signature,
                     const Signature& candidate_signature, const MatchResult& match, int box_side,
                     const std::string& verdict) {
  const cv::Mat left = drawing::to_bgr(query, "match figure, query");
  const cv::Mat right = drawing::to_bgr(candidate, "match figure, candidate");
  check(left, query_signature, "query");
  check(right, candidate_signature, "candidate");
  check(match, query_signature, candidate_signature);
  if (box_side < 1) throw Error(fmt::format("match figure: box side {} is below 1", box_side));

  const drawing::Text text;
  const std::vector<std::string> lines = text.wrapped(verdict, L::verdict_size, L::text_width);
  const MatchLayout layout = lay_out_match(left.size(), right.size(), static_cast<int>(lines.size()));
  const Panel first{left, query_signature, layout.query};
  const Panel second{right, candidate_signature, layout.candidate};
  const std::vector<Pair> pairs = pairs_of(match, first, second, box_side);

  cv::Mat canvas(layout.canvas, CV_8UC3, drawing::white);
  draw_panel(canvas, first, box_side);
  draw_panel(canvas, second, box_side);
  draw_captions(canvas, first, second, text);
  draw_pairs(canvas, pairs);
  draw_distances(canvas, pairs, text);
  draw_words(canvas, layout, match, lines, text);
  return canvas;
}

}  // namespace sailmap
