// Precision-recall curve and similarity matrix as one SVG, drawn by gnuplot.
#include <fmt/format.h>
#include <gnuplot-iostream.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <fstream>
#include <utility>
#include <vector>

#include "drawing.hpp"
#include "gnuplot.hpp"
#include "sailmap/error.hpp"
#include "sailmap/figures.hpp"
#include "score_raster.hpp"

namespace sailmap {
namespace {

namespace fs = std::filesystem;
using Points = std::vector<std::pair<double, double>>;

constexpr int most_cells = 800;               // a side, so that the SVG stays small
constexpr int least_cells = 600;              // a side: about the panel's pixels
constexpr std::size_t most_segments = 12000;  // of the ground truth's outline
constexpr double least_band = 7;              // pixels between the outlines of a narrow band of matches

// The page and its two square panels, in pixels; y counts from the page's lower border.
constexpr int page_width = 1200;
constexpr int panel = 440;
constexpr int panel_bottom = 124;
constexpr int curve_left = 90;
constexpr int matrix_left = 650;
constexpr int title_size = 17;
constexpr int title_line = 26;

struct Page {
  std::vector<std::string> title;
  int height = 0;

  explicit Page(const std::string& text)
      : title(drawing::Text().wrapped(text, title_size, page_width - 40)),
        height(panel_bottom + panel + 62 + title_line * static_cast<int>(title.size())) {}
  static double across(double x) { return x / page_width; }
  [[nodiscard]] double up(double y) const { return y / height; }

  // The panel that comes next fills this part of the page.
  [[nodiscard]] std::string frame(double left, double bottom, double width, double high) const {
    return fmt::format(
        "set lmargin at screen {}\nset rmargin at screen {}\nset bmargin at screen {}\n"
        "set tmargin at screen {}\n",
        across(left), across(left + width), up(bottom), up(bottom + high));
  }
  // Its key stands beneath it.
  [[nodiscard]] std::string key(double left) const {
    return fmt::format("set key at screen {},{} left top vertical Left reverse samplen 1.5\n", across(left),
                       up(panel_bottom - 66));
  }
};

void send_title(Gnuplot& gp, const Page& page) {
  double y = page.height - title_line - 4;
  for (const std::string& line : page.title) {
    gp << "set label " << gnuplot_text(line) << " at screen 0.5," << page.up(y)
       << " center font 'DejaVu Sans," << title_size << "'\n";
    y -= title_line;
  }
}

void send_curve_panel(Gnuplot& gp, const Page& page, const Evaluation& e) {
  Points curve;
  // The curve starts at the precision of its first point: no recall has been paid for yet.
  curve.emplace_back(0, e.curve.front().precision);
  for (const CurvePoint& point : e.curve) curve.emplace_back(point.recall, point.precision);
  gp << "set title "
     << gnuplot_text(fmt::format("Precision and recall, average precision {:.3f}", e.average_precision))
     << "\nset xlabel 'recall' offset 0,0.3\nset ylabel 'precision' offset 0.5,0\nset xrange [0:1]\nset "
        "yrange [0:1]\n"
     << "set grid back lt 1 lc rgb '#e4e4e4' lw 0.7\n"
     << page.frame(curve_left, panel_bottom, panel, panel) << page.key(curve_left)
     << "plot '-' with lines lw 2.5 lc rgb '#1f77b4' title "
     << gnuplot_text(
            fmt::format("recall {:.3f} at 100 % precision, {:.3f} at 95 %", e.recall_at_100, e.recall_at_95))
     << ", '-' with points pt 7 ps 1.1 lc rgb '#d62728' title "
     << gnuplot_text(fmt::format("threshold {:g}: precision {:.3f}, recall {:.3f}", e.fixed.threshold,
                                 e.fixed.precision, e.fixed.recall))
     << "\n";
  gp.send1d(curve);
  gp.send1d(Points{{e.fixed.recall, e.fixed.precision}});
}

// float32, first row first, as gnuplot reads binary arrays.
void write_cells(const fs::path& path, const Plane<float>& cells, double ceiling) {
  std::ofstream out(path, std::ios::binary);
  for (const float cell : cells.samples()) {
    const float shown = std::isnan(cell) ? cell : std::min(cell, static_cast<float>(ceiling));
    const auto bytes = std::bit_cast<std::array<char, sizeof shown>>(shown);
    out.write(bytes.data(), bytes.size());
  }
  out.flush();
  if (!out) throw Error(path.string() + ": cannot be written");
}

// How wide and high the matrix is, and its cells are, in images.
struct Extent {
  double width, height;

  explicit Extent(const Plane<float>& scores) : width(scores.width()), height(scores.height()) {}
  [[nodiscard]] double per_column(const Plane<float>& cells) const { return width / cells.width(); }
  [[nodiscard]] double per_row(const Plane<float>& cells) const { return height / cells.height(); }
};

std::string matrix_title(const Extent& extent, const ScoreRaster& raster) {
  const double across = extent.per_column(raster.cells);
  const double down = extent.per_row(raster.cells);
  if (across <= 1 && down <= 1) return "Similarity of query and candidate";
  return fmt::format("Similarity, each cell the highest of {:.3g} x {:.3g} images", across, down);
}

void send_outline(Gnuplot& gp, const std::vector<Segment>& segments, double per_column, double per_row) {
  // Image i reaches from i - 1/2 to i + 1/2.
  for (const Segment& s : segments) {
    gp << s.x0 * per_column - 0.5 << ' ' << s.y0 * per_row - 0.5 << '\n'
       << s.x1 * per_column - 0.5 << ' ' << s.y1 * per_row - 0.5 << "\n\n";
  }
  gp << "e\n";
}

void send_matrix_panel(Gnuplot& gp, const Page& page, const fs::path& cell_file, const ScoreRaster& raster,
                       const Plane<float>& scores) {
  const Extent extent(scores);
  const Plane<float> cells = enlarged(raster.cells, least_cells);
  write_cells(cell_file, cells, raster.ceiling);
  const double dx = extent.per_column(cells);
  const double dy = extent.per_row(cells);
  // True to shape unless that is too slender to be seen.
  const double shape = std::clamp(extent.height / extent.width, 0.25, 4.0);
  const double width = panel * std::min(1.0, 1 / shape);
  const double high = panel * std::min(1.0, shape);
  const double cell = std::min(width / raster.cells.width(), high / raster.cells.height());
  const int margin = static_cast<int>(std::lround(std::max(0.0, (least_band - cell) / 2) / cell));
  const std::vector<Segment> segments = outline(widened(raster.is_match, margin), most_segments);
  const double bottom = panel_bottom + panel - high;
  gp << "unset grid\nset title " << gnuplot_text(matrix_title(extent, raster))
     << "\nset xlabel 'candidate'\nset ylabel 'query' offset 0,0\nset xrange [-0.5:" << extent.width - 0.5
     << "]\nset yrange [" << extent.height - 0.5 << ":-0.5]\n"
     << page.frame(matrix_left, bottom, width, high) << page.key(matrix_left)
     << "set colorbox user origin screen " << Page::across(matrix_left + width + 14) << ","
     << page.up(panel_bottom) << " size screen " << Page::across(16) << "," << page.up(panel)
     << "\nset cbrange [0:" << raster.ceiling << "]\nset cblabel "
     << gnuplot_text(fmt::format("similarity, clipped at {:.3g} ({:g}th percentile)", raster.ceiling,
                                 100 * ceiling_part))
     << "\nset palette maxcolors 100 defined (0 '#e3eaf3', 0.25 '#a9c5e2', 0.5 '#5f97cb', 0.75 '#2361a4', 1 "
        "'#061f4a')"
     << "\nplot " << gnuplot_text(cell_file.string()) << " binary array=(" << cells.width() << ","
     << cells.height() << ") format='%float' dx=" << dx << " dy=" << dy << " origin=(" << dx / 2 - 0.5 << ","
     << dy / 2 - 0.5 << ") with image notitle";
  if (segments.empty()) {
    gp << "\n";
    return;
  }
  gp << ", '-' with lines lw 0.8 lc rgb '#e31a1c' title 'ground truth lies within the outlines'\n";
  send_outline(gp, segments, extent.per_column(raster.cells), extent.per_row(raster.cells));
}

}  // namespace

void write_evaluation_plot(const fs::path& path, const Evaluation& evaluation, const Plane<float>& scores,
                           const GroundTruth& truth, const std::string& title) {
  if (evaluation.curve.empty()) throw Error(path.string() + ": there is no precision-recall curve to draw");
  const ScoreRaster raster = rasterise(scores, truth, most_cells);
  const Scratch scratch;
  const fs::path script = scratch.file("script");
  {
    const Page page(title);
    Gnuplot gp(fmt::format(">{}", script.string()));
    gp << std::defaultfloat << std::setprecision(7) << "set encoding utf8\nset terminal svg size "
       << page_width << "," << page.height
       << " font 'DejaVu Sans,13' background 'white' noenhanced\nset multiplot\n"
       << "set tics out nomirror scale 0.6\n";
    send_title(gp, page);
    send_curve_panel(gp, page, evaluation);
    gp << "unset label\n";
    send_matrix_panel(gp, page, scratch.file("cells"), raster, scores);
    gp << "unset multiplot\n";
  }
  write_plot(path, script, scratch);
}

}  // namespace sailmap
