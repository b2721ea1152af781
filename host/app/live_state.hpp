// What the live view knows of the map: a copy that is added to, and read by the server's threads.
#pragma once

#include <chrono>
#include <mutex>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "report/subject.hpp"
#include "sailmap/topological_map.hpp"

namespace sailmap::app {

// All functions may be called from any thread.
class LiveState {
 public:
  LiveState(std::string title, const TopologicalMap& map, std::string frontend);

  // Takes over what the map has more than it had.
  void update(const TopologicalMap& map);

  // The page's data before any image, as a report has it.
  [[nodiscard]] nlohmann::ordered_json empty_page() const;
  // What came after the first `images` images, in the page's columns; `layout` is the version the page has.
  [[nodiscard]] nlohmann::ordered_json news(std::size_t images, int layout);

  [[nodiscard]] std::optional<std::string> name(std::size_t image) const;

  // A loop with all that report::pair_of needs; nothing when there is none of that number.
  struct LoopCopy {
    report::Subject subject;  // of this one loop, without names
    std::string image_name;
    std::string place_name;
  };
  [[nodiscard]] std::optional<LoopCopy> loop(std::size_t number) const;

  [[nodiscard]] const MapConfig& config() const { return config_; }
  [[nodiscard]] const std::string& frontend() const { return frontend_; }

 private:
  using Clock = std::chrono::steady_clock;
  struct Image {
    std::string name;
    int node = 0;
    int best = -1;  // first image of the best node
    double score = 0;
    Reason reason = Reason::no_nodes;
  };
  void take(const Update& update, const TopologicalMap& map);
  void renew_layout();

  const std::string title_;
  const std::string frontend_;
  const MapConfig config_;
  const std::vector<int> sessions_;
  const Clock::time_point start_ = Clock::now();
  std::size_t images_at_start_ = 0;

  mutable std::mutex lock_;  // of what follows
  std::vector<Image> images_;
  std::vector<int> node_images_;  // the first image of each node
  std::vector<Edge> edges_;
  std::vector<report::Loop> loops_;
  Clock::time_point last_ = Clock::now();
  std::vector<double> layout_;
  int layout_version_ = 0;

  std::mutex layout_lock_;  // one layout at a time; of what follows
  Clock::time_point layout_done_;
  double layout_seconds_ = 0;     // of the last one ...
  std::size_t layout_nodes_ = 0;  // ... and of how many nodes it was
};

}  // namespace sailmap::app
