// Runs gnuplot.
#pragma once

#include <filesystem>
#include <string>

namespace sailmap {

// A folder for what goes to and comes from another program, removed with this object. Throws Error when it
// cannot be made.
class Scratch {
 public:
  Scratch();
  ~Scratch();
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;
  Scratch(Scratch&&) = delete;
  Scratch& operator=(Scratch&&) = delete;
  [[nodiscard]] std::filesystem::path file(const char* name) const { return folder_ / name; }

 private:
  std::filesystem::path folder_;
};

// Text as gnuplot reads it literally.
std::string gnuplot_text(const std::string& text);

// The SVG that gnuplot writes to its standard output for a script in `scratch`. Throws Error when gnuplot is
// missing or fails, with what it said.
std::string run_gnuplot(const std::filesystem::path& script, const Scratch& scratch);

}  // namespace sailmap
