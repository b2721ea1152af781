// Two maps held against each other, image by image. Numbers of images and nodes differ as soon as one map has
// an image more, so that images go by their names, and nodes and edges by the images that made the nodes.
#pragma once

#include <compare>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "sailmap/map_store.hpp"

namespace sailmap::app {

// The same name for the second time is another image.
struct ImageKey {
  std::string name;
  int occurrence = 1;
  auto operator<=>(const ImageKey&) const = default;
};

std::string text_of(const ImageKey& key);

struct EdgeOfImages {
  ImageKey from;
  ImageKey to;
  EdgeKind kind = EdgeKind::path;
  auto operator<=>(const EdgeOfImages&) const = default;
};

template <class T>
struct OnlyIn {
  std::vector<T> a;
  std::vector<T> b;
  [[nodiscard]] bool empty() const { return a.empty() && b.empty(); }
};

struct ParameterChange {
  std::string name;  // "match.method"; "frontend"
  nlohmann::ordered_json a;
  nlohmann::ordered_json b;
};

struct DetectionOfImage {
  Reason reason = Reason::no_nodes;
  std::optional<ImageKey> node;  // the image that made the best node, when there is one
  double similarity = 0;         // to it
};

struct DetectionChange {
  ImageKey image;
  DetectionOfImage a;
  DetectionOfImage b;
};

struct MapComparison {
  std::vector<ParameterChange> parameters;
  OnlyIn<ImageKey> images;
  std::vector<ImageKey> regions;  // kept in both maps, with different regions or descriptors
  OnlyIn<ImageKey> nodes;
  OnlyIn<EdgeOfImages> edges;
  std::vector<DetectionChange> detections;  // of images in both
  [[nodiscard]] bool equal() const;
};

// A detection differs by its verdict, its best node or its similarity, when that differs by more than
// `tolerance` times the larger of the two.
MapComparison compare(const StoredMap& a, const StoredMap& b, double tolerance);

}  // namespace sailmap::app
