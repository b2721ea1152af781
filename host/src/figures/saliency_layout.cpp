#include "saliency_layout.hpp"

#include <algorithm>

#include "drawing.hpp"

namespace sailmap {
namespace {

using L = SaliencyLayout;

constexpr int gap = 14;        // between panels of one kind
constexpr int group_gap = 40;  // between kinds
constexpr int heading_room = 46;
constexpr int inner_width = saliency_figure_width - 2 * L::margin;
// Times as wide as high: above, image and saliency stand one above the other, and all panels do.
constexpr double widest_beside = 2.5;
constexpr double widest_in_columns = 8;
constexpr int least_cell = 230;  // room for the caption of a narrow panel
constexpr std::array<const char*, conspicuity_count> kind_names = {"Intensity", "Colour", "Orientation"};
constexpr std::array<int, conspicuity_count> kind_columns = {1, 2, 2};
constexpr std::array<std::size_t, conspicuity_count> first_of_kind = {
    0, hls::geometry::intensity_maps, hls::geometry::intensity_maps + hls::geometry::colour_maps};
constexpr const char* conspicuity_title = "Conspicuity: sum of each kind's normalised feature maps";

double shape(const cv::Size& image) { return static_cast<double>(image.width) / image.height; }

cv::Rect centred(const cv::Size& size, int x, int y, int room) {
  return {x + (room - size.width) / 2, y, size.width, size.height};
}

void place_in_columns(SaliencyLayout& out, const cv::Size& image, int y) {
  constexpr int widest_tile = (inner_width - 2 * gap - 2 * group_gap) / 5;
  const cv::Size tile = drawing::fit(image, {widest_tile, 400});
  const int cell = std::max(tile.width, least_cell);
  const int inner = 5 * cell + 2 * gap + 2 * group_gap;
  out.canvas.width = inner + 2 * L::margin;

  const bool beside = shape(image) <= widest_beside;
  out.big_room = beside ? (inner - group_gap) / 2 : inner;
  const cv::Size big = drawing::fit(image, {out.big_room, 760});
  const cv::Point step =
      beside ? cv::Point(out.big_room + group_gap, 0) : cv::Point(0, big.height + L::caption_room + gap / 2);
  out.image = centred(big, L::margin, y, out.big_room);
  out.saliency = out.image + step;
  y = out.saliency.br().y + L::caption_room + heading_room;

  const int row = tile.height + L::caption_room + gap / 2;
  const int conspicuity_y = y + 2 * row + heading_room - gap / 2;
  int x = L::margin;
  for (std::size_t kind = 0; kind < conspicuity_count; ++kind) {
    const int columns = kind_columns[kind];
    const int width = columns * cell + (columns - 1) * gap;
    out.feature_headings[kind] = {kind_names[kind], {x, y - 18}, width};
    for (int k = 0; k < 2 * columns; ++k) {
      const std::size_t i = first_of_kind[kind] + static_cast<std::size_t>(k);
      out.features[i] = centred(tile, x + (k % columns) * (cell + gap), y + (k / columns) * row, cell);
      out.feature_rooms[i] = cell;
    }
    out.conspicuities[kind] = centred(tile, x, conspicuity_y, width);
    out.conspicuity_rooms[kind] = cell;
    x += width + group_gap;
  }
  out.conspicuity_heading = {conspicuity_title, {L::margin, conspicuity_y - 18}, inner};
  out.canvas.height = conspicuity_y + tile.height + L::caption_room + L::margin;
}

void place_in_rows(SaliencyLayout& out, const cv::Size& image, int y) {
  const cv::Size panel = drawing::fit(image, {inner_width, inner_width});
  const auto next = [&] {
    const cv::Rect place(L::margin, y, panel.width, panel.height);
    y += panel.height + L::caption_room + gap / 2;
    return place;
  };
  const auto heading = [&](const char* text) {
    y += heading_room;
    return Heading{text, {L::margin, y - 18}, panel.width};
  };
  out.canvas.width = saliency_figure_width;
  out.big_room = inner_width;
  out.feature_rooms.fill(inner_width);
  out.conspicuity_rooms.fill(inner_width);
  out.image = next();
  out.saliency = next();
  for (std::size_t kind = 0; kind < conspicuity_count; ++kind) {
    out.feature_headings[kind] = heading(kind_names[kind]);
    for (int k = 0; k < 2 * kind_columns[kind]; ++k) {
      out.features[first_of_kind[kind] + static_cast<std::size_t>(k)] = next();
    }
  }
  out.conspicuity_heading = heading(conspicuity_title);
  for (cv::Rect& place : out.conspicuities) place = next();
  out.canvas.height = y + L::margin;
}

}  // namespace

SaliencyLayout lay_out_saliency(const cv::Size& image, int title_lines) {
  SaliencyLayout out;
  const int y = L::margin + title_lines * L::title_line + (title_lines > 0 ? 6 : 0);
  if (shape(image) > widest_in_columns) {
    place_in_rows(out, image, y);
  } else {
    place_in_columns(out, image, y);
  }
  return out;
}

}  // namespace sailmap
