// A progress bar on standard error, drawn only when a person watches.
#pragma once

#include <chrono>
#include <optional>
#include <string>

namespace sailmap::app {

class Progress {
 public:
  // `total`: how many steps there will be, when known.
  Progress(std::string what, std::optional<int> total);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  void step_to(int done);
  // Takes the bar off the screen, so that a line can be printed; the next step draws it again.
  void clear();

 private:
  void draw(int done);

  std::string what_;
  std::optional<int> total_;
  bool watched_;
  bool drawn_ = false;
  std::chrono::steady_clock::time_point start_;
  std::chrono::steady_clock::time_point last_;
};

}  // namespace sailmap::app
