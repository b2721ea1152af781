// Precision-recall curve and similarity matrix as one SVG, drawn by gnuplot.
#include <fmt/format.h>
#include <gnuplot-iostream.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <utility>
#include <vector>

#include "sailmap/error.hpp"
#include "sailmap/figures.hpp"
#include "sailmap/file.hpp"
#include "score_raster.hpp"

namespace sailmap {
namespace {

namespace fs = std::filesystem;
using Points = std::vector<std::pair<double, double>>;

// A folder for what goes to and comes from gnuplot, removed in the end.
class Scratch {
 public:
  Scratch() {
    std::string pattern = (fs::temp_directory_path() / "sailmap-plot-XXXXXX").string();
    if (::mkdtemp(pattern.data()) == nullptr) throw Error(pattern + ": cannot make this folder");
    folder_ = pattern;
  }
  ~Scratch() {
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
  }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;
  [[nodiscard]] fs::path file(const char* name) const { return folder_ / name; }

 private:
  fs::path folder_;
};

// Text inside gnuplot's double quotes; its "enhanced" markup is switched off.
std::string quoted(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') out += '\\';
    if (c != '\n') out += c;
  }
  return out + "\"";
}

void send_curve_panel(Gnuplot& gp, const Evaluation& e) {
  Points curve;
  // The curve starts at the precision of its first point: no recall has been paid for yet.
  curve.emplace_back(0, e.curve.front().precision);
  for (const CurvePoint& point : e.curve) curve.emplace_back(point.recall, point.precision);
  gp << "set title " << quoted(fmt::format("Precision and recall: AP {:.3f}", e.average_precision)) << "\n"
     << "set xlabel 'recall'\nset ylabel 'precision'\nset xrange [0:1.01]\nset yrange [0:1.02]\n"
     << "set size ratio 1\nset grid lc rgb '#dddddd'\nset key bottom left Left reverse samplen 1.5\n";
  const std::string fixed =
      fmt::format("threshold {:g}: P {:.2f}, R {:.2f}", e.fixed.threshold, e.fixed.precision, e.fixed.recall);
  gp << "plot '-' with lines lw 2.5 lc rgb '#1f77b4' title "
     << quoted(fmt::format("R@100P {:.3f}, R@95P {:.3f}", e.recall_at_100, e.recall_at_95))
     << ", '-' with points pt 7 ps 1 lc rgb '#d62728' title " << quoted(fixed) << "\n";
  gp.send1d(curve);
  gp.send1d(Points{{e.fixed.recall, e.fixed.precision}});
}

// float32 cells, first row first, as gnuplot reads binary arrays.
void write_cells(const fs::path& path, const ScoreRaster& raster) {
  std::ofstream out(path, std::ios::binary);
  for (const float cell : raster.cells.samples()) {
    const float shown = std::isnan(cell) ? cell : std::min(cell, static_cast<float>(raster.ceiling));
    out.write(reinterpret_cast<const char*>(&shown), sizeof shown);
  }
  if (!out) throw Error(path.string() + ": cannot be written");
}

Points match_centres(const ScoreRaster& raster) {
  Points centres;
  for (int y = 0; y < raster.is_match.height(); ++y) {
    for (int x = 0; x < raster.is_match.width(); ++x) {
      if (raster.is_match(x, y) != 0) centres.emplace_back((x + 0.5) * raster.step, (y + 0.5) * raster.step);
    }
  }
  return centres;
}

void send_matrix_panel(Gnuplot& gp, const fs::path& cells, const ScoreRaster& raster,
                       const Plane<float>& scores) {
  const Points matches = match_centres(raster);
  const double step = raster.step;
  gp << "set title 'Similarity of query and candidate'\n"
     << "set xlabel 'candidate'\nset ylabel 'query'\nset xrange [0:" << scores.width() << "]\nset yrange ["
     << scores.height() << ":0]\nset size noratio\nunset grid\nset key top right samplen 1\n"
     << "set cbrange [0:" << raster.ceiling << "]\nset cblabel "
     << quoted(fmt::format("similarity (clipped at {:.3g}, its 99.5th percentile)", raster.ceiling)) << "\n"
     << "set palette defined (0 '#ffffff', 0.15 '#e3ecf7', 0.5 '#6ea3d4', 1 '#08306b')\n"
     << "plot " << quoted(cells.string()) << " binary array=(" << raster.cells.width() << ","
     << raster.cells.height() << ") format='%float' dx=" << step << " dy=" << step << " origin=(" << step / 2
     << "," << step / 2 << ") with image pixels notitle";
  if (matches.empty()) {
    gp << "\n";
    return;
  }
  gp << ", '-' with points pt 6 ps 0.3 lw 0.7 lc rgb '#d62728' title 'ground truth'\n";
  gp.send1d(matches);
}

std::string contents(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace

void write_evaluation_plot(const fs::path& path, const Evaluation& evaluation, const Plane<float>& scores,
                           const GroundTruth& truth, const std::string& title) {
  if (std::system("command -v gnuplot >/dev/null 2>&1") != 0) {
    throw Error(path.string() + ": gnuplot is needed to draw it, and is not installed");
  }
  constexpr int most_cells = 400;
  const Scratch scratch;
  const fs::path svg = scratch.file("plot.svg");
  const fs::path cells = scratch.file("cells");
  const ScoreRaster raster = rasterise(scores, truth, most_cells);
  write_cells(cells, raster);
  {
    Gnuplot gp("gnuplot 2>" + scratch.file("messages").string());
    gp << "set terminal svg size 1200,560 font 'DejaVu Sans,13' background 'white' noenhanced\nset output "
       << quoted(svg.string()) << "\nset multiplot layout 1,2 title " << quoted(title)
       << "\nset tics out nomirror\n";
    send_curve_panel(gp, evaluation);
    send_matrix_panel(gp, cells, raster, scores);
    gp << "unset multiplot\nunset output\n";
  }
  const std::string drawn = contents(svg);
  if (drawn.find("</svg>") == std::string::npos) {
    throw Error(path.string() + ": gnuplot failed: " + contents(scratch.file("messages")).substr(0, 200));
  }
  write_file(path, [&drawn](std::ostream& out) { out << drawn; });
}

}  // namespace sailmap
