#include <algorithm>
#include <limits>
#include <string>
#include <string_view>

#include "ground_truth_readers.hpp"
#include "sailmap/error.hpp"
#include "sailmap/ground_truth.hpp"
#include "text_lines.hpp"

namespace sailmap {

namespace {

struct Row {
  io::Line line;
  int query = 0;
  std::vector<int> candidates;  // rising, each once
};

int parse_index(const std::filesystem::path& path, const io::Line& line, std::string_view word) {
  const auto index = io::parse_integer(word);
  // Of so many images even the count fits.
  if (!index || *index < 0 || *index == std::numeric_limits<int>::max()) {
    throw io::line_error(path, line, "not an image index: '" + std::string(word) + "'");
  }
  return *index;
}

Row parse_row(const std::filesystem::path& path, const io::Line& line) {
  const std::string_view text = line.text;
  const std::size_t colon = text.find(':');
  if (colon == std::string_view::npos)
    throw io::line_error(path, line, "no colon; expected `query: candidates`");
  Row row{
      .line = line, .query = parse_index(path, line, io::trimmed(text.substr(0, colon))), .candidates = {}};
  for (const std::string_view word : io::split_words(text.substr(colon + 1))) {
    row.candidates.push_back(parse_index(path, line, word));
  }
  std::ranges::sort(row.candidates);
  row.candidates.erase(std::unique(row.candidates.begin(), row.candidates.end()), row.candidates.end());
  return row;
}

std::vector<Row> read_rows(const std::filesystem::path& path) {
  std::vector<Row> rows;
  for (const io::Line& line : io::read_lines(path)) rows.push_back(parse_row(path, line));
  if (rows.empty()) throw Error(path.string() + ": no ground truth in this file");
  return rows;
}

void check_index(const std::filesystem::path& path, const Row& row, const std::string& what, int index,
                 int count) {
  if (index < count) return;
  throw io::line_error(path, row.line,
                       what + " " + std::to_string(index) + " does not exist: there are " +
                           std::to_string(count) + " images, counted from 0");
}

}  // namespace

namespace io {

Extent text_extent(const std::filesystem::path& path) {
  Extent extent;
  for (const Row& row : read_rows(path)) {
    extent.queries = std::max(extent.queries, row.query + 1);
    if (!row.candidates.empty()) extent.candidates = std::max(extent.candidates, row.candidates.back() + 1);
  }
  return extent;
}

}  // namespace io

GroundTruth read_text_ground_truth(const std::filesystem::path& path, int queries, int candidates) {
  GroundTruth truth{.matches = std::vector<std::vector<int>>(static_cast<std::size_t>(queries))};
  std::vector<bool> seen(static_cast<std::size_t>(queries), false);
  for (Row& row : read_rows(path)) {
    check_index(path, row, "query", row.query, queries);
    if (!row.candidates.empty()) check_index(path, row, "candidate", row.candidates.back(), candidates);
    const auto query = static_cast<std::size_t>(row.query);
    if (seen[query])
      throw io::line_error(path, row.line, "query " + std::to_string(row.query) + " a second time");
    seen[query] = true;
    truth.matches[query] = std::move(row.candidates);
  }
  return truth;
}

}  // namespace sailmap
