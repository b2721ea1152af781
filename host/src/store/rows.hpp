// The tables of a map file, one struct each: what a row holds, in the order of its columns
// (docs/map_file.md).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

namespace sailmap::store {

using Blob = std::vector<unsigned char>;

// One row: what the map was made with.
struct MapRow {
  static constexpr const char* table = "map";
  static constexpr const char* columns = "id, sailmap, frontend, parameters";
  int id = 0;
  std::string sailmap;     // version of the program that made the file
  std::string frontend;    // its name
  std::string parameters;  // MapConfig as JSON
  auto fields() { return std::tie(id, sailmap, frontend, parameters); }
};

// One run of the program over a source.
struct SessionRow {
  static constexpr const char* table = "session";
  static constexpr const char* columns = "id, source, started, first_image, images, skipped, seconds";
  int id = 0;
  std::string source;
  double started = 0;   // seconds since 1970
  int first_image = 0;  // the images up to the next session's are its own
  int images = 0;
  int skipped = 0;     // images that could not be read
  double seconds = 0;  // how long it took
  auto fields() { return std::tie(id, source, started, first_image, images, skipped, seconds); }
};

struct ImageRow {
  static constexpr const char* table = "image";
  static constexpr const char* columns = "id, name, time, node, new_node, is_view";
  int id = 0;
  std::string name;
  std::optional<double> time;  // seconds since 1970
  int node = 0;                // active node after it
  int new_node = 0;            // 1: it made that node
  int is_view = 0;             // 1: it stands for that node
  auto fields() { return std::tie(id, name, time, node, new_node, is_view); }
};

struct SignatureRow {
  static constexpr const char* table = "signature";
  static constexpr const char* columns = "id, width, height, regions, place";
  int id = 0;     // of the image
  int width = 0;  // of the image, pixels
  int height = 0;
  Blob regions;  // signature_bytes.hpp
  Blob place;    // empty: not described
  auto fields() { return std::tie(id, width, height, regions, place); }
};

struct DetectionRow {
  static constexpr const char* table = "detection";
  static constexpr const char* columns =
      "id, reason, best_node, best_similarity, runner_up_node, runner_up_similarity, matches";
  int id = 0;  // of the image
  std::string reason;
  int best_node = -1;  // -1: none
  double best_similarity = 0;
  int runner_up_node = -1;
  double runner_up_similarity = 0;
  Blob matches;  // signature_bytes.hpp
  auto fields() {
    return std::tie(id, reason, best_node, best_similarity, runner_up_node, runner_up_similarity, matches);
  }
};

struct ThumbnailRow {
  static constexpr const char* table = "thumbnail";
  static constexpr const char* columns = "id, jpeg";
  int id = 0;  // of the image
  Blob jpeg;
  auto fields() { return std::tie(id, jpeg); }
};

struct NodeRow {
  static constexpr const char* table = "node";
  static constexpr const char* columns = "id, first_image";
  int id = 0;
  int first_image = 0;
  auto fields() { return std::tie(id, first_image); }
};

struct EdgeRow {
  static constexpr const char* table = "edge";
  static constexpr const char* columns = "id, from_node, to_node, kind";
  int id = 0;
  int from_node = 0;
  int to_node = 0;
  std::string kind;
  auto fields() { return std::tie(id, from_node, to_node, kind); }
};

}  // namespace sailmap::store
