// Several data sets and methods in one run: the paper's Table I.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "measurement.hpp"
#include "table_config.hpp"

namespace sailmap::app {

// One method on one data set.
struct TableCell {
  std::optional<Measurement> measurement;  // its scores are not kept
  std::string skipped;                     // why there is none
};

// One data set.
struct TableRow {
  std::string name;
  std::string skipped;           // why it was not evaluated; empty: it was
  std::optional<double> length;  // km, as given or along the poses
  int images = 0;                // queries, of two traverses
  std::vector<TableCell> cells;  // one a method
};

struct Table {
  std::vector<std::string> methods;
  std::vector<TableRow> rows;
};

// Everything that can be checked without the images is checked first. Throws Error in one line that names
// `config` (for messages), the entry and the fault.
Table evaluate_table(const TableConfig& config, const std::string& name);

}  // namespace sailmap::app
