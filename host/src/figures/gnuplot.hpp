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

// Writes the SVG that gnuplot draws from a script in `scratch` into the file `path`. Throws Error, beginning
// with the path, when gnuplot is missing or fails, with what it said, and when the file cannot be written.
void write_plot(const std::filesystem::path& path, const std::filesystem::path& script,
                const Scratch& scratch);

}  // namespace sailmap
