// The similarity matrix, thinned to what a page can show.
#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <vector>

#include "pictures.hpp"
#include "sailmap/ground_truth.hpp"
#include "sailmap/ref/plane.hpp"
#include "subject.hpp"

namespace sailmap::report {

inline constexpr int matrix_side = 400;     // cells of the page, at most
inline constexpr int matrix_columns = 800;  // nodes compared, at most, evenly over the map

// Rows are images, columns are images that made nodes. Both rise.
struct Similarities {
  std::vector<int> rows;
  std::vector<int> columns;
  Plane<float> scores;  // NaN where not admissible
  int unknown = 0;      // rows whose image could not be looked at, and were not in the map
};

// The images of the rows.
std::vector<int> matrix_rows(const TopologicalMap& map);

// `signature_of(image)` gives an image's regions, std::nullopt when they cannot be had; it is asked for the
// images of the rows, from one thread. Similarities of single images, before any temporal filter.
Similarities compare_images(const TopologicalMap& map,
                            const std::function<std::optional<Signature>(int image)>& signature_of);

// {"rows": first image of each, "columns": likewise, "cells": base64, row by row, 0 .. 254 from 0 to the
// ceiling, 255 not admissible, "ceiling", "truth": [column, row, ...]}. `truth` may be empty; its candidates
// are images too. Numbers of images are mapped by `rows` and `columns`.
nlohmann::ordered_json matrix_of(const Similarities& similarities, const GroundTruth& truth);

}  // namespace sailmap::report
