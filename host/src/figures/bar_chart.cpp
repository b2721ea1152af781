// Bars in groups, one panel above the other, as one SVG drawn by gnuplot.
#include <fmt/format.h>
#include <gnuplot-iostream.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <tuple>

#include "drawing.hpp"
#include "gnuplot.hpp"
#include "sailmap/error.hpp"
#include "sailmap/figures.hpp"

namespace sailmap {
namespace {

namespace fs = std::filesystem;

// Pixels.
constexpr int page_width = 1200;
constexpr int least_left_margin = 84;
constexpr int most_left_margin = 260;
constexpr int right_margin = 24;
constexpr int title_height = 44;
constexpr int key_line = 24;
constexpr int panel_height = 230;
constexpr int panel_title = 40;
constexpr int font_size = 13;
constexpr int number_size = 11;
constexpr int number_width = 26;  // of "100" with some air
constexpr int most_name_height = 170;

// Okabe and Ito's colours, neighbours differing in brightness too.
constexpr std::array<const char*, 8> colours = {"#0072b2", "#e69f00", "#009e73", "#f0e442",
                                                "#d55e00", "#56b4e9", "#cc79a7", "#999999"};

std::string fill_of(std::size_t series) {
  const std::string border = "border lc rgb '#303030'";
  if (series < colours.size()) return "fillstyle solid 1 " + border;
  return fmt::format("fillstyle pattern {} {}", 4 + series / colours.size() % 4, border);
}

struct BarLayout {
  std::size_t groups;
  std::size_t series;
  std::size_t key_columns;
  int key_height;
  int name_height;  // beneath each panel
  bool slanted;     // names of the groups
  int left_margin;
  int height;

  BarLayout(const std::vector<std::string>& group_names, const std::vector<std::string>& series_names,
            std::size_t panels)
      : groups(group_names.size()), series(series_names.size()) {
    const drawing::Text text;
    const auto widest = [&text](const std::vector<std::string>& names) {
      int width = 0;
      for (const std::string& name : names) width = std::max(width, text.width(name, font_size));
      return width;
    };
    const int inner = page_width - least_left_margin - right_margin;
    key_columns =
        std::clamp<std::size_t>(static_cast<std::size_t>(inner / (widest(series_names) + 60)), 1, series);
    key_height = key_line * static_cast<int>((series + key_columns - 1) / key_columns) + 6;
    const int names = widest(group_names);
    slanted = names + 10 > inner / static_cast<int>(groups);
    constexpr double slope = std::numbers::pi / 6;
    const int to_the_left = static_cast<int>(names * std::cos(slope)) - inner / static_cast<int>(2 * groups);
    left_margin =
        slanted ? std::clamp(to_the_left + 16, least_left_margin, most_left_margin) : least_left_margin;
    name_height = slanted ? std::min(most_name_height, 24 + static_cast<int>(names * std::sin(slope))) : 30;
    height =
        title_height + key_height + static_cast<int>(panels) * (panel_title + panel_height + name_height);
  }

  [[nodiscard]] double bar() const { return 0.84 / static_cast<double>(series); }  // a group is 1 wide
  [[nodiscard]] double bar_pixels() const {
    return bar() * (page_width - left_margin - right_margin) / static_cast<double>(groups);
  }
  [[nodiscard]] double middle(std::size_t group, std::size_t k) const {
    const double from_centre = static_cast<double>(k) - (static_cast<double>(series) - 1) / 2;
    return static_cast<double>(group) + from_centre * bar();
  }
  // Of panel k, counted from the page's lower border.
  [[nodiscard]] int bottom(std::size_t k) const {
    const int above = static_cast<int>(k + 1) * (panel_title + panel_height + name_height);
    return height - title_height - key_height - above + name_height;
  }
  [[nodiscard]] double up(double y) const { return y / height; }
};

void check(const fs::path& path, const std::vector<std::string>& groups,
           const std::vector<std::string>& series, const std::vector<BarPanel>& panels) {
  bool any = false;
  for (const BarPanel& panel : panels) {
    bool fits = panel.values.size() == groups.size();
    for (const auto& group : panel.values) {
      fits = fits && group.size() == series.size();
      any = any || std::ranges::any_of(group, [](double value) { return !std::isnan(value); });
    }
    if (!fits) throw Error(path.string() + ": the bars do not fit the names of groups and series");
  }
  if (!any) throw Error(path.string() + ": there is nothing to draw");
}

// What all panels have in common.
void send_frame(Gnuplot& gp, const BarLayout& page, const std::vector<std::string>& groups) {
  gp << "set encoding utf8\nset terminal svg size " << page_width << "," << page.height
     << " font 'DejaVu Sans," << font_size << "' background 'white' noenhanced\nset multiplot\n"
     << "set lmargin at screen " << static_cast<double>(page.left_margin) / page_width
     << "\nset rmargin at screen " << 1 - static_cast<double>(right_margin) / page_width
     << "\nset tics out nomirror scale 0.6\nset yrange [0:110]\nset ytics 0,20,100\nset xrange [-0.5:"
     << static_cast<double>(groups.size()) - 0.5 << "]\nset border 3\n"
     << "set grid ytics back lt 1 lc rgb '#e4e4e4' lw 0.7\nset boxwidth " << page.bar()
     << "\nset xtics scale 0 " << (page.slanted ? "rotate by 30 right" : "norotate") << " (";
  for (std::size_t g = 0; g < groups.size(); ++g) {
    gp << (g > 0 ? ", " : "") << gnuplot_text(groups[g]) << " " << g;
  }
  gp << ")\n";
}

using Bars = std::vector<std::pair<double, double>>;
using Numbers = std::vector<std::tuple<double, double, std::string>>;

Bars bars_of(const BarPanel& panel, const BarLayout& page, std::size_t series) {
  Bars bars;
  for (std::size_t g = 0; g < page.groups; ++g) {
    const double value = panel.values[g][series];
    if (!std::isnan(value)) bars.emplace_back(page.middle(g, series), 100 * value);
  }
  return bars;
}

// Above the bars; upright where they are narrow.
Numbers numbers_of(const BarPanel& panel, const BarLayout& page) {
  Numbers numbers;
  for (std::size_t k = 0; k < page.series; ++k) {
    for (const auto& [x, y] : bars_of(panel, page, k)) numbers.emplace_back(x, y, fmt::format("{:.0f}", y));
  }
  return numbers;
}

void send_panel(Gnuplot& gp, const BarPanel& panel, const BarLayout& page, std::size_t k,
                const std::vector<std::string>& series) {
  const bool numbered = page.bar_pixels() >= number_size + 1;
  const bool upright = page.bar_pixels() < number_width;
  gp << "set bmargin at screen " << page.up(page.bottom(k)) << "\nset tmargin at screen "
     << page.up(page.bottom(k) + panel_height) << "\nset title " << gnuplot_text(panel.title)
     << " offset 0,-0.3\n";
  gp << "plot ";
  for (std::size_t s = 0; s < series.size(); ++s) {
    gp << (s > 0 ? ", " : "") << "'-' with boxes " << fill_of(s) << " lc rgb '" << colours[s % colours.size()]
       << "' title " << gnuplot_text(series[s]);
  }
  if (numbered) {
    gp << ", '-' with labels " << (upright ? "rotate by 90 left offset 0,0.3" : "center offset 0,0.55")
       << " font 'DejaVu Sans," << number_size << "' notitle";
  }
  gp << "\n";
  for (std::size_t s = 0; s < series.size(); ++s) {
    // Without a point gnuplot would warn: one outside the axes.
    Bars bars = bars_of(panel, page, s);
    if (bars.empty()) bars.emplace_back(-10, 0);
    gp.send1d(bars);
  }
  if (numbered) gp.send1d(numbers_of(panel, page));
}

}  // namespace

void write_bar_chart(const fs::path& path, const std::string& title, const std::vector<std::string>& groups,
                     const std::vector<std::string>& series, const std::vector<BarPanel>& panels) {
  check(path, groups, series, panels);
  const BarLayout page(groups, series, panels.size());
  const Scratch scratch;
  const fs::path script = scratch.file("script");
  {
    Gnuplot gp(fmt::format(">{}", script.string()));
    gp << std::defaultfloat << std::setprecision(7);
    send_frame(gp, page, groups);
    gp << "set label " << gnuplot_text(title) << " at screen 0.5," << page.up(page.height - 28)
       << " center font 'DejaVu Sans,17'\nset key at screen 0.5," << page.up(page.height - title_height)
       << " center top horizontal Left reverse samplen 1.2 maxcols " << page.key_columns << "\n";
    for (std::size_t k = 0; k < panels.size(); ++k) {
      send_panel(gp, panels[k], page, k, series);
      gp << "unset label\nunset key\n";
    }
    gp << "unset multiplot\n";
  }
  write_plot(path, script, scratch);
}

}  // namespace sailmap
