#include "gnuplot.hpp"

#include <algorithm>
#include <boost/process.hpp>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <system_error>

#include "drawing.hpp"
#include "sailmap/error.hpp"
#include "sailmap/file.hpp"

namespace sailmap {
namespace {

namespace fs = std::filesystem;
namespace process = boost::process;

std::string contents(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

// The end of gnuplot's messages on one line: the fault comes last.
std::string fault_of(const fs::path& messages) {
  const std::string text = drawing::printable(contents(messages));
  constexpr std::size_t most = 300;
  return text.size() > most ? "..." + text.substr(text.size() - most) : text;
}

// The SVG that gnuplot writes to its standard output for a script in `scratch`.
std::string run_gnuplot(const fs::path& script, const Scratch& scratch) {
  const boost::filesystem::path program = process::search_path("gnuplot");
  if (program.empty()) throw Error("gnuplot is needed to draw this, and is not installed");
  const fs::path svg = scratch.file("plot.svg");
  const fs::path messages = scratch.file("messages");
  // Files rather than pipes: a pipe whose reader has died would end this program.
  std::error_code failed;
  const int status =
      process::system(program, script.string(), process::std_in<process::null, process::std_out> svg.string(),
                      process::std_err > messages.string(), failed);
  if (failed) throw Error("gnuplot cannot be run: " + failed.message());
  std::string drawn = contents(svg);
  if (status != 0 || drawn.find("</svg>") == std::string::npos) {
    throw Error("gnuplot failed with status " + std::to_string(status) + ": " + fault_of(messages));
  }
  return drawn;
}

}  // namespace

Scratch::Scratch() {
  std::error_code failed;
  std::string pattern = (fs::temp_directory_path(failed) / "sailmap-plot-XXXXXX").string();
  if (failed || ::mkdtemp(pattern.data()) == nullptr) {
    throw Error(pattern + ": cannot make a folder for gnuplot's files (is TMPDIR right?)");
  }
  folder_ = pattern;
}

Scratch::~Scratch() {
  std::error_code ignored;
  fs::remove_all(folder_, ignored);
}

std::string gnuplot_text(const std::string& text) {
  // Within single quotes gnuplot expands nothing; in double quotes `...` would run a command.
  std::string out = "'";
  for (const char c : drawing::printable(text)) out += c == '\'' ? "''" : std::string(1, c);
  return out + "'";
}

void write_plot(const std::filesystem::path& path, const std::filesystem::path& script,
                const Scratch& scratch) {
  std::string svg;
  try {
    svg = run_gnuplot(script, scratch);
  } catch (const Error& fault) {
    throw Error(path.string() + ": " + fault.what());
  }
  write_file(path, [&svg](std::ostream& out) { out << svg; });
}

}  // namespace sailmap
