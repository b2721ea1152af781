// The configuration file of `sailmap eval --table`: data sets and methods, in JSON (docs/data_sets.md).
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "experiment.hpp"
#include "sailmap/fabmap.hpp"

namespace sailmap::app {

struct TableDataSet {
  std::string name;
  DataSet data;                      // paths as they are to be opened
  std::optional<double> length;      // km
  std::filesystem::path vocabulary;  // of FAB-MAP on this data set; empty: none
  std::string train_on;              // the data set that FAB-MAP's words are learned from; empty: none
  std::string skipped;               // why it cannot be evaluated; empty: it can
};

struct TableMethod {
  std::string name;
  Recogniser recogniser;
  fabmap::TrainingConfig training;  // of FAB-MAP where a data set says train_on
};

struct TableConfig {
  std::vector<TableDataSet> data_sets;
  std::vector<TableMethod> methods;
};

// `common`: front end and parameters that hold for all methods. Throws Error in one line that names file,
// entry and fault. A data set that is not filled in, or whose folder is empty, is not wrong but skipped.
TableConfig read_table_config(const std::filesystem::path& path, const Recogniser& common);

}  // namespace sailmap::app
