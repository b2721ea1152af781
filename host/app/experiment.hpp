// One data set, one way to recognise places, their scores: what `eval` measures.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "describe_source.hpp"
#include "sailmap/evaluation.hpp"
#include "sailmap/topological_map.hpp"

namespace sailmap::app {

// One sequence, or two traverses, and their ground truth.
struct DataSet {
  std::string source;     // one sequence, ...
  std::string reference;  // ... or the map's images ...
  std::string query;      // ... and the queries
  std::string ground_truth;
  std::string reference_poses;
  double radius = 0;
  Selection selection;
  int exclude_recent = MapConfig{}.exclude_recent;  // of one sequence

  [[nodiscard]] bool traverses() const { return !reference.empty(); }
  // Where the queries are, and what they are compared with.
  [[nodiscard]] const std::string& queries() const { return traverses() ? query : source; }
  [[nodiscard]] const std::string& candidates() const { return traverses() ? reference : source; }
  // For people: "images", "now in before".
  [[nodiscard]] std::string title() const;
};

// Counts the images and reads the ground truth. Throws Error when either cannot be, or they do not fit.
GroundTruth read_truth(const DataSet& data);

// The methods that work on visual words: they need a vocabulary and hold an image against many others.
inline constexpr const char* fabmap_name = "fabmap";
inline constexpr const char* bow_name = "bow";

// The methods that work on signatures, and these.
std::vector<std::string> recogniser_names();

struct Recogniser {
  std::string method;                // one of recogniser_names()
  std::filesystem::path vocabulary;  // of methods on words, for messages and results
  std::string frontend;              // of the others
  MapConfig config;                  // threshold and temporal filter of all, the rest of the others

  [[nodiscard]] bool on_words() const { return method == fabmap_name || method == bow_name; }
};

// Makes the rest of the configuration what the method needs: its default threshold, unless one was given, and
// its descriptors.
void settle(Recogniser& recogniser, bool threshold_given);

// What a recogniser knows of a data set's images.
template <class T>
struct Views {
  std::vector<T> queries;
  std::vector<T> candidates;  // of two traverses; empty: the queries
  double images_per_second = 0;
};

Views<Signature> describe(const DataSet& data, const std::string& frontend, const RegionConfig& regions);
Views<fabmap::Histogram> describe(const DataSet& data, const fabmap::Vocabulary& vocabulary);

// Row = query, column = candidate, NaN where not admissible; the temporal filter is applied.
Plane<float> score(const DataSet& data, const Views<Signature>& views, const Recogniser& recogniser);
Plane<float> score(const DataSet& data, const Views<fabmap::Histogram>& views, const Recogniser& recogniser,
                   const fabmap::Vocabulary& vocabulary);

}  // namespace sailmap::app
