// A page that shows a map or an evaluation: one self-contained HTML file that asks nothing of a network
// (docs/report.md).
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "sailmap/ground_truth.hpp"
#include "sailmap/topological_map.hpp"

namespace sailmap {

class MapStore;

struct ReportOptions {
  std::string title;                 // empty: the file's name
  std::vector<Pose> positions;       // where each image was taken, metres; empty: not known
  std::optional<GroundTruth> truth;  // of a map: one entry an image
  std::filesystem::path image_root;  // where image files are looked for that are not where their names say
  const MapStore* store = nullptr;   // the map's file: regions, thumbnails, sessions; nullptr: none
  int pairs = 60;                    // loops shown as pictures, at most
  std::vector<int> images;           // images whose saliency is wanted in any case
  int thumbnails = 160;              // further images shown, evenly over the sequence, at most
  std::size_t budget = 8'000'000;    // bytes of pictures on the page, at most; pictures are left out beyond
};

// Image files that cannot be read, or have changed, are named on the page and are no error. Throws Error when
// positions, truth or images do not fit the map, and when the page cannot be written.
void write_report(const std::filesystem::path& path, const TopologicalMap& map, const std::string& frontend,
                  const ReportOptions& options);

// Of the file that `sailmap eval --json` wrote; positions and truth do not apply. Throws Error, naming the
// file, when it is not one.
void write_evaluation_report(const std::filesystem::path& path, const std::filesystem::path& evaluation,
                             const ReportOptions& options);

}  // namespace sailmap
