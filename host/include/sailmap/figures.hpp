// Pictures for people: saliency figures, matched pairs, precision-recall curves.
#pragma once

#include <filesystem>
#include <opencv2/core/mat.hpp>
#include <string>
#include <vector>

#include "sailmap/detection.hpp"
#include "sailmap/evaluation.hpp"
#include "sailmap/ground_truth.hpp"
#include "sailmap/maps.hpp"
#include "sailmap/signature.hpp"
#include "sailmap/topological_map.hpp"

namespace sailmap {

// As the paper's Fig. 2: the image with its regions, the ten feature maps, three conspicuity maps and the
// saliency map, labelled, as one picture (8-bit BGR). `box_side` in base-level pixels.
cv::Mat saliency_figure(const cv::Mat& image, const Maps& maps, const Signature& signature, int box_side,
                        const std::string& title);

// As Fig. 5 and 6: the images side by side, all regions drawn, matched ones joined, the verdict in words
// beneath.
cv::Mat match_figure(const cv::Mat& query, const cv::Mat& candidate, const Signature& query_signature,
                     const Signature& candidate_signature, const MatchResult& match, int box_side,
                     const std::string& verdict);

// PNG, JPEG or whatever the extension says; replaced whole or not at all. Throws Error when it cannot be
// written.
void write_image(const std::filesystem::path& path, const cv::Mat& image);

// SVG: precision-recall curve with the fixed threshold marked, and the similarity matrix with the ground
// truth outlined or marked. Throws Error when it cannot be written or gnuplot is missing.
void write_evaluation_plot(const std::filesystem::path& path, const Evaluation& evaluation,
                           const Plane<float>& scores, const GroundTruth& truth, const std::string& title);

// Bars in groups.
struct BarPanel {
  std::string title;                        // what the bars stand for
  std::vector<std::vector<double>> values;  // by group and series, 0 .. 1, shown as per cent; NaN: no bar
};

// SVG, as the paper's Fig. 8: panels one above the other, groups side by side, of each group one bar a series
// with its number above it. Colours that the colour-blind can tell apart, hatched after the eighth. Throws
// Error when there is no bar, the values do not fit the names, it cannot be written, or gnuplot is missing.
void write_bar_chart(const std::filesystem::path& path, const std::string& title,
                     const std::vector<std::string>& groups, const std::vector<std::string>& series,
                     const std::vector<BarPanel>& panels);

// SVG: the map as a graph laid out by graphviz, path edges grey, loop edges by similarity (orange at the
// threshold to dark red at four times it), the active node yellow; nodes with their number (of large maps
// every so many) and, as a tooltip, their image. Calls from several threads take turns. Throws Error when it
// cannot be written.
void write_map_plot(const std::filesystem::path& path, const TopologicalMap& map, const std::string& title);

}  // namespace sailmap
