// The vocabularies that a table's FAB-MAP needs, each read or learned once.
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "sailmap/fabmap.hpp"
#include "table_config.hpp"

namespace sailmap::app {

// A vocabulary for one method on one data set.
struct ChosenVocabulary {
  const fabmap::Vocabulary* vocabulary = nullptr;  // none when skipped
  std::filesystem::path name;                      // its file, or where it was learned
  std::string skipped;                             // why there is none
};

class Vocabularies {
 public:
  // `config` must outlive the object.
  explicit Vocabularies(const TableConfig& config) : config_(config) {}

  // Throws Error naming the file.
  const fabmap::Vocabulary& read(const std::filesystem::path& path);
  // That of the data set, if it says one, else of the method. Throws Error when it cannot be read or learned.
  ChosenVocabulary choose(const TableDataSet& entry, const TableMethod& method);

 private:
  const fabmap::Vocabulary& learn(const TableDataSet& from, const fabmap::TrainingConfig& training);

  const TableConfig& config_;
  std::map<std::string, fabmap::Vocabulary> known_;
};

}  // namespace sailmap::app
