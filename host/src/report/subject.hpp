// What a report is about, whether it was a map or an evaluation: images by number, and the loops among them.
#pragma once

#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "sailmap/evaluation.hpp"
#include "sailmap/report.hpp"
#include "sailmap/topological_map.hpp"

namespace sailmap::report {

// An accepted detection. Images go by their number in Subject::names.
struct Loop {
  int image = 0;
  std::vector<int> views;  // the images of the known place at that time, the first made the node; never empty
  double score = 0;
  int rival = -1;  // an image of the runner-up, -1 when there is none
  double rival_score = 0;
  std::optional<std::vector<RegionMatch>> matches;  // as recorded; none: to be computed from the images
  std::optional<bool> right;                        // by ground truth, where it is known
};

// How far a loop is from having been decided otherwise: the smaller of the distances to the threshold and to
// the runner-up, as a part of the score.
double margin(const Loop& loop, double threshold);

struct Subject {
  std::string title;
  std::string frontend;  // empty: there are no regions (FAB-MAP, bag of words)
  MapConfig config;
  double threshold = 0;
  std::vector<std::string> names;  // of two traverses the queries, then the references
  std::vector<Loop> loops;         // by image
  const TopologicalMap* map = nullptr;
};

Subject subject_of(const TopologicalMap& map, const std::string& frontend, const ReportOptions& options);

// Nodes that were made before this image could be compared with `image`.
int first_not_admissible(const TopologicalMap& map, int image);

// Where an image's regions are kept: in the map, where it made a node; else perhaps in its file.
class StoredSignatures {
 public:
  explicit StoredSignatures(const TopologicalMap* map);
  // Those of further images, from the file.
  void add(int image, Signature signature);
  [[nodiscard]] const Signature* of(int image) const;  // nullptr when they are not kept

 private:
  std::vector<const Signature*> by_image_;
  std::map<int, Signature> others_;
};

// Precision and recall of the map's own detections: whether an image of the detected node is a true match.
// Also sets Loop::right. Throws Error when there is nothing to recall.
Evaluation judge(Subject& subject, const GroundTruth& truth);

// Six significant digits: the page is read by people, and shorter by half.
double shortened(double value);

}  // namespace sailmap::report
