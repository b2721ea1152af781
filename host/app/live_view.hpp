// The report's page, served while a run goes on (docs/report.md).
#pragma once

#include <CLI/CLI.hpp>
#include <memory>
#include <optional>
#include <string>

#include "sailmap/topological_map.hpp"

namespace sailmap::app {

struct ViewOptions {
  std::optional<int> port;            // none: no view; 0: any free one
  std::string address = "127.0.0.1";  // loopback: nobody outside this machine
};

inline constexpr int default_view_port = 8017;

// --view and --view-address.
void add_view_options(CLI::App& command, ViewOptions& options);

// Serves from threads of its own, of low priority; the run waits for none of them. Without a port it does
// nothing. Images are served by their number in the map alone, reduced and encoded anew, never by a path.
class LiveView {
 public:
  // Takes the port. Throws Error when it cannot be had.
  LiveView(const ViewOptions& options, std::string title);
  ~LiveView();
  LiveView(const LiveView&) = delete;
  LiveView& operator=(const LiveView&) = delete;
  LiveView(LiveView&&) = delete;
  LiveView& operator=(LiveView&&) = delete;

  // Begins to serve, with what the map holds already.
  void begin(const TopologicalMap& map, const std::string& frontend);
  // After each image that was added to the map.
  void update(const TopologicalMap& map);

 private:
  class Server;
  std::unique_ptr<Server> server_;  // none without a port
};

}  // namespace sailmap::app
