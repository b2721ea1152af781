#include "poses.hpp"

#include <GeographicLib/LocalCartesian.hpp>
#include <algorithm>
#include <array>
#include <cctype>
#include <optional>
#include <string>
#include <string_view>

#include "text_lines.hpp"

namespace sailmap::io {

namespace {

using Numbers = std::vector<double>;

// All words of a line as numbers; nothing when one of them is none.
std::optional<Numbers> numbers_of(const std::vector<std::string_view>& words) {
  Numbers numbers;
  for (const std::string_view word : words) {
    const auto number = parse_number(word);
    if (!number) return std::nullopt;
    numbers.push_back(*number);
  }
  return numbers;
}

// Formats with the same count of numbers, separated by white space, on every line.
struct Columns {
  std::string_view format;
  std::size_t count;
  std::size_t x;
  std::size_t y;
};
// A row of KITTI is the 3 x 4 matrix of the pose; its camera looks along z, so x and z span the ground.
constexpr std::array<Columns, 2> known_formats = {Columns{"KITTI", 12, 3, 11}, Columns{"TUM", 8, 1, 2}};

Track read_columns(const std::filesystem::path& path, const std::vector<Line>& lines,
                   const Columns& columns) {
  Track track;
  for (const Line& line : lines) {
    const auto words = split_words(line.text);
    const auto numbers = numbers_of(words);
    if (!numbers || numbers->size() != columns.count) {
      throw line_error(
          path, line,
          "a " + std::string(columns.format) + " pose has " + std::to_string(columns.count) + " numbers");
    }
    track.poses.push_back({(*numbers)[columns.x], (*numbers)[columns.y]});
  }
  return track;
}

// Which fields of a CSV file hold the position.
struct CsvColumns {
  std::size_t x = 0;
  std::size_t y = 0;
  bool geographic = false;
};

std::string lower(std::string_view text) {
  std::string out(text);
  std::ranges::transform(out, out.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return out;
}

std::optional<std::size_t> find_field(const std::vector<std::string_view>& fields, std::string_view name) {
  const auto found =
      std::ranges::find_if(fields, [name](std::string_view field) { return lower(field) == name; });
  if (found == fields.end()) return std::nullopt;
  return static_cast<std::size_t>(found - fields.begin());
}

CsvColumns find_csv_columns(const std::filesystem::path& path, const Line& header) {
  struct Names {
    std::string_view x, y;
    bool geographic;
  };
  constexpr std::array<Names, 3> names = {Names{"x", "y", false}, Names{"lon", "lat", true},
                                          Names{"longitude", "latitude", true}};
  const auto fields = split_fields(header.text, ',');
  for (const Names& pair : names) {
    const auto x = find_field(fields, pair.x);
    const auto y = find_field(fields, pair.y);
    if (x && y) return {*x, *y, pair.geographic};
  }
  throw line_error(path, header, "a CSV header must name x,y or lat,lon");
}

bool on_earth(const Pose& degrees) {
  return degrees.x >= -180 && degrees.x <= 180 && degrees.y >= -90 && degrees.y <= 90;
}

Pose read_csv_pose(const std::filesystem::path& path, const Line& line, const CsvColumns& columns) {
  const auto fields = split_fields(line.text, ',');
  if (fields.size() <= std::max(columns.x, columns.y)) throw line_error(path, line, "too few fields");
  const auto x = parse_number(fields[columns.x]);
  const auto y = parse_number(fields[columns.y]);
  if (!x || !y) throw line_error(path, line, "the position is not two numbers");
  const Pose pose{*x, *y};
  if (columns.geographic && !on_earth(pose)) {
    throw line_error(path, line, "latitude must be -90..90 and longitude -180..180 degrees");
  }
  return pose;
}

Track read_csv(const std::filesystem::path& path, const std::vector<Line>& lines) {
  const CsvColumns columns = find_csv_columns(path, lines.front());
  Track track{.poses = {}, .geographic = columns.geographic};
  for (std::size_t i = 1; i < lines.size(); ++i)
    track.poses.push_back(read_csv_pose(path, lines[i], columns));
  if (track.poses.empty()) throw Error(path.string() + ": no pose after the header");
  return track;
}

}  // namespace

Track read_track(const std::filesystem::path& path) {
  const std::vector<Line> lines = read_lines(path);
  if (lines.empty()) throw Error(path.string() + ": no pose in this file");
  if (lines.front().text.find(',') != std::string::npos) return read_csv(path, lines);
  const std::size_t count = split_words(lines.front().text).size();
  const auto* const format = std::ranges::find(known_formats, count, &Columns::count);
  if (format == known_formats.end()) {
    throw line_error(
        path, lines.front(),
        "neither a KITTI pose (12 numbers), a TUM pose (8), a CSV header, nor `query: candidates`");
  }
  return read_columns(path, lines, *format);
}

std::vector<Pose> in_plane(const Track& track, const Pose& origin) {
  if (!track.geographic) return track.poses;
  const GeographicLib::LocalCartesian plane(origin.y, origin.x);
  std::vector<Pose> poses;
  for (const Pose& degrees : track.poses) {
    Pose metres;
    double height = 0;
    plane.Forward(degrees.y, degrees.x, 0, metres.x, metres.y, height);
    poses.push_back(metres);
  }
  return poses;
}

}  // namespace sailmap::io

namespace sailmap {

std::vector<Pose> read_poses(const std::filesystem::path& path) {
  const io::Track track = io::read_track(path);
  return io::in_plane(track, track.poses.front());
}

}  // namespace sailmap
