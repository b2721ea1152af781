#include "table_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "sailmap/figures.hpp"

namespace sailmap::app {
namespace {

using nlohmann::ordered_json;

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

// What the table shows of each method; the first two are those of the paper's Table I.
struct Measure {
  const char* title;
  bool per_cent;
  double (*of)(const Evaluation&);
};
constexpr std::array<Measure, 4> measures = {
    Measure{"Precision (%)", true,
            // Where nothing is detected there is nothing to be right or wrong.
            [](const Evaluation& e) { return e.fixed.detections > 0 ? e.fixed.precision : nothing; }},
    Measure{"Recall (%)", true, [](const Evaluation& e) { return e.fixed.recall; }},
    Measure{"Average precision", false, [](const Evaluation& e) { return e.average_precision; }},
    Measure{"Recall at 100 % precision (%)", true, [](const Evaluation& e) { return e.recall_at_100; }}};

constexpr const char* no_number = "-";

std::string shown(const TableCell& cell, const Measure& measure) {
  if (!cell.measurement) return no_number;
  const double value = measure.of(cell.measurement->evaluation);
  if (std::isnan(value)) return no_number;
  return measure.per_cent ? fmt::format("{:.1f}", 100 * value) : fmt::format("{:.3f}", value);
}

std::string length_of(const TableRow& row) {
  return row.length ? fmt::format("{:.1f} km", *row.length) : no_number;
}

// Of the first method that was evaluated: the queries with a true match are the same for all.
std::string matches_of(const TableRow& row) {
  for (const TableCell& cell : row.cells) {
    if (cell.measurement) return std::to_string(cell.measurement->evaluation.queries_with_match);
  }
  return no_number;
}

constexpr std::array<const char*, 4> lead = {"Data set", "Length", "Images", "Revisits"};

std::array<std::string, 4> lead_of(const TableRow& row) {
  return {row.name, length_of(row), row.images > 0 ? std::to_string(row.images) : no_number, matches_of(row)};
}

std::vector<std::string> notes_of(const Table& table) {
  std::vector<std::string> notes;
  for (const TableRow& row : table.rows) {
    if (!row.skipped.empty()) {
      notes.push_back(fmt::format("{}: skipped, {}", row.name, row.skipped));
      continue;
    }
    for (std::size_t m = 0; m < row.cells.size(); ++m) {
      const TableCell& cell = row.cells[m];
      if (!cell.skipped.empty()) {
        notes.push_back(fmt::format("{}, {}: skipped, {}", row.name, table.methods[m], cell.skipped));
      } else if (cell.measurement && cell.measurement->evaluation.fixed.detections == 0) {
        notes.push_back(fmt::format("{}, {}: nothing is detected at threshold {:g}", row.name,
                                    table.methods[m], cell.measurement->evaluation.fixed.threshold));
      }
    }
  }
  return notes;
}

// Characters, not bytes: columns of names with accents stay aligned.
std::size_t characters(const std::string& text) {
  return static_cast<std::size_t>(
      std::ranges::count_if(text, [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
}

std::string padded(const std::string& text, std::size_t width, bool left) {
  const std::string space(width - std::min(width, characters(text)), ' ');
  return left ? text + space : space + text;
}

// A column of the text: its cells, the first being its header.
using Column = std::vector<std::string>;

std::size_t width_of(const Column& column) {
  std::size_t width = 0;
  for (const std::string& cell : column) width = std::max(width, characters(cell));
  return width;
}

std::vector<Column> lead_columns(const Table& table) {
  std::vector<Column> columns;
  for (std::size_t k = 0; k < lead.size(); ++k) {
    Column column{lead[k]};
    for (const TableRow& row : table.rows) column.push_back(lead_of(row)[k]);
    columns.push_back(std::move(column));
  }
  return columns;
}

Column column_of(const Table& table, const Measure& measure, std::size_t method) {
  Column column{table.methods[method]};
  for (const TableRow& row : table.rows) column.push_back(shown(row.cells[method], measure));
  return column;
}

// Field of a CSV line.
std::string quoted(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string out = "\"";
  for (const char c : text) out += c == '"' ? "\"\"" : std::string(1, c);
  return out + "\"";
}

// Cell of a Markdown table.
std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '|' || c == '\\') out += '\\';
    out += c == '\n' ? ' ' : c;
  }
  return out;
}

}  // namespace

std::string to_text(const Table& table) {
  constexpr const char* gap = "  ";
  std::vector<std::string> lines(table.rows.size() + 2);  // titles, headers, rows
  const auto append = [&](const Column& column, std::size_t width, bool left) {
    for (std::size_t i = 0; i < column.size(); ++i) lines[i + 1] += padded(column[i], width, left) + gap;
  };
  for (const Column& column : lead_columns(table)) {
    append(column, width_of(column), column.front() == lead.front());
  }
  lines[0] = std::string(characters(lines[1]), ' ');
  for (const Measure& measure : measures) {
    std::vector<Column> columns;
    std::size_t width = 0;
    for (std::size_t m = 0; m < table.methods.size(); ++m) {
      columns.push_back(column_of(table, measure, m));
      width += width_of(columns.back()) + (m > 0 ? 2 : 0);
    }
    // A title wider than its columns widens the first of them.
    const std::size_t title = characters(measure.title);
    const std::size_t more = title > width ? title - width : 0;
    for (std::size_t m = 0; m < columns.size(); ++m) {
      append(columns[m], width_of(columns[m]) + (m == 0 ? more : 0), false);
    }
    lines[0] += padded(measure.title, std::max(width, title), false) + gap;
    for (std::string& line : lines) line += gap;
  }
  std::string out;
  for (std::string& line : lines) {
    line.erase(line.find_last_not_of(' ') + 1);
    out += line + '\n';
  }
  for (const std::string& note : notes_of(table)) out += note + '\n';
  return out;
}

std::string to_markdown(const Table& table) {
  std::vector<Column> columns = lead_columns(table);
  for (const Measure& measure : measures) {
    for (std::size_t m = 0; m < table.methods.size(); ++m) {
      Column column = column_of(table, measure, m);
      column[0] = fmt::format("{}, {}", measure.title, table.methods[m]);
      columns.push_back(std::move(column));
    }
  }
  std::string out;
  for (std::size_t line = 0; line <= table.rows.size(); ++line) {
    for (const Column& column : columns) out += "| " + escaped(column[line]) + " ";
    out += "|\n";
    if (line > 0) continue;
    for (std::size_t k = 0; k < columns.size(); ++k) out += k == 0 ? "|---" : "|---:";
    out += "|\n";
  }
  const std::vector<std::string> notes = notes_of(table);
  if (!notes.empty()) out += '\n';
  for (const std::string& note : notes) out += "- " + note + '\n';
  return out;
}

std::string to_csv(const Table& table) {
  std::string out =
      "data_set,length_km,images,queries,queries_with_match,method,threshold,detections,right,precision,"
      "recall,average_precision,recall_at_100_precision,recall_at_95_precision,best_f1,skipped\n";
  for (const TableRow& row : table.rows) {
    for (std::size_t m = 0; m < row.cells.size(); ++m) {
      const TableCell& cell = row.cells[m];
      const std::string length = row.length ? fmt::format("{}", *row.length) : "";
      const std::string name = quoted(row.name);
      const std::string method = quoted(table.methods[m]);
      if (!cell.measurement) {
        out += fmt::format("{},{},{},,,{},,,,,,,,,,{}\n", name, length, row.images, method,
                           quoted(cell.skipped));
        continue;
      }
      const Evaluation& e = cell.measurement->evaluation;
      out += fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},\n", name, length, row.images,
                         e.queries, e.queries_with_match, method, e.fixed.threshold, e.fixed.detections,
                         e.fixed.right, e.fixed.precision, e.fixed.recall, e.average_precision,
                         e.recall_at_100, e.recall_at_95, e.best_f1);
    }
  }
  return out;
}

ordered_json to_json(const Table& table) {
  ordered_json rows = ordered_json::array();
  for (const TableRow& row : table.rows) {
    ordered_json json = {{"name", row.name}};
    json["length_km"] = row.length ? ordered_json(*row.length) : ordered_json(nullptr);
    if (!row.skipped.empty()) json["skipped"] = row.skipped;
    ordered_json results = ordered_json::object();
    for (std::size_t m = 0; m < row.cells.size(); ++m) {
      const TableCell& cell = row.cells[m];
      results[table.methods[m]] =
          cell.measurement ? to_json(*cell.measurement) : ordered_json{{"skipped", cell.skipped}};
    }
    json["results"] = std::move(results);
    rows.push_back(std::move(json));
  }
  return {{"methods", table.methods}, {"data_sets", std::move(rows)}};
}

void write_table_plot(const std::filesystem::path& path, const Table& table) {
  std::vector<std::string> groups;
  BarPanel recall{"Recall (%)", {}};
  BarPanel precision{"Precision (%)", {}};
  for (const TableRow& row : table.rows) {
    if (!row.skipped.empty()) continue;
    groups.push_back(row.name);
    recall.values.emplace_back();
    precision.values.emplace_back();
    for (const TableCell& cell : row.cells) {
      const bool there = cell.measurement.has_value();
      precision.values.back().push_back(there ? measures[0].of(cell.measurement->evaluation) : nothing);
      recall.values.back().push_back(there ? measures[1].of(cell.measurement->evaluation) : nothing);
    }
  }
  write_bar_chart(path, "Recall and precision at each method's threshold", groups, table.methods,
                  {recall, precision});
}

}  // namespace sailmap::app
