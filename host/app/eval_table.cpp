#include "eval_table.hpp"

#include <cmath>
#include <map>
#include <utility>

#include "sailmap/error.hpp"
#include "table_vocabularies.hpp"

namespace sailmap::app {
namespace {

double kilometres(const std::vector<Pose>& poses) {
  double metres = 0;
  for (std::size_t i = 1; i < poses.size(); ++i) {
    metres += std::hypot(poses[i].x - poses[i - 1].x, poses[i].y - poses[i - 1].y);
  }
  return metres / 1000;
}

// The parameters that describe the images well enough for all methods on signatures; none: there is no such
// method.
std::optional<Recogniser> describing(const std::vector<TableMethod>& methods) {
  std::optional<Recogniser> out;
  for (const TableMethod& method : methods) {
    if (method.recogniser.on_words()) continue;
    if (!out) out = method.recogniser;
    out->config.regions.describe_place |= method.recogniser.config.regions.describe_place;
  }
  return out;
}

// One data set; every view of its images is made once.
class RowEvaluator {
 public:
  RowEvaluator(const TableConfig& config, const TableDataSet& entry, const GroundTruth& truth,
               Vocabularies& vocabularies)
      : config_(config), entry_(entry), truth_(truth), vocabularies_(vocabularies) {}

  std::vector<TableCell> cells() {
    std::vector<TableCell> out;
    const std::optional<Recogniser> common = describing(config_.methods);
    if (common) signatures_ = describe(entry_.data, common->frontend, common->config.regions);
    for (const TableMethod& method : config_.methods) {
      out.push_back(method.recogniser.on_words() ? by_words(method) : by_signatures(method));
      if (out.back().measurement) out.back().measurement->scores = {};
    }
    return out;
  }

 private:
  TableCell by_signatures(const TableMethod& method) {
    return {measure(entry_.data, truth_, signatures_, method.recogniser), {}};
  }

  TableCell by_words(const TableMethod& method) {
    const ChosenVocabulary chosen = vocabularies_.choose(entry_, method);
    if (chosen.vocabulary == nullptr) return {std::nullopt, chosen.skipped};
    auto words = words_.find(chosen.vocabulary);
    if (words == words_.end()) {
      words = words_.emplace(chosen.vocabulary, describe(entry_.data, *chosen.vocabulary)).first;
    }
    Recogniser recogniser = method.recogniser;
    recogniser.vocabulary = chosen.name;
    return {measure(entry_.data, truth_, words->second, recogniser, *chosen.vocabulary), {}};
  }

  const TableConfig& config_;
  const TableDataSet& entry_;
  const GroundTruth& truth_;
  Vocabularies& vocabularies_;
  Views<Signature> signatures_;
  std::map<const fabmap::Vocabulary*, Views<fabmap::Histogram>> words_;
};

// Does the work of one entry; what goes wrong is told with its name.
template <class Work>
void named(const std::string& name, Work work) {
  try {
    work();
  } catch (const Error& fault) {
    throw Error(name + ": " + fault.what());
  }
}

// What is known of a data set before its images are looked at.
TableRow empty_row(const TableDataSet& entry, const GroundTruth& truth, std::size_t methods) {
  TableRow row;
  row.name = entry.name;
  row.skipped = entry.skipped;
  row.cells.assign(methods, {std::nullopt, entry.skipped});
  row.length = entry.length;
  if (!entry.skipped.empty()) return row;
  if (!row.length && holds_poses(entry.data.ground_truth)) {
    row.length = kilometres(read_poses(entry.data.ground_truth));
  }
  row.images = static_cast<int>(truth.matches.size());
  return row;
}

}  // namespace

Table evaluate_table(const TableConfig& config, const std::string& name) {
  Vocabularies vocabularies(config);
  std::vector<GroundTruth> truths(config.data_sets.size());
  const auto data_set = [&name](const TableDataSet& entry) {
    return name + ": data set '" + entry.name + "'";
  };
  // What is wrong with the last entry is told before the first one is evaluated.
  for (const TableMethod& method : config.methods) {
    if (method.recogniser.vocabulary.empty()) continue;
    named(name + ": method '" + method.name + "'", [&] { vocabularies.read(method.recogniser.vocabulary); });
  }
  for (std::size_t i = 0; i < truths.size(); ++i) {
    const TableDataSet& entry = config.data_sets[i];
    if (!entry.skipped.empty()) continue;
    named(data_set(entry), [&] {
      truths[i] = read_truth(entry.data);
      if (!entry.vocabulary.empty()) vocabularies.read(entry.vocabulary);
    });
  }
  Table table;
  for (const TableMethod& method : config.methods) table.methods.push_back(method.name);
  for (std::size_t i = 0; i < truths.size(); ++i) {
    const TableDataSet& entry = config.data_sets[i];
    named(data_set(entry), [&] {
      table.rows.push_back(empty_row(entry, truths[i], config.methods.size()));
      if (!entry.skipped.empty()) return;
      table.rows.back().cells = RowEvaluator(config, entry, truths[i], vocabularies).cells();
    });
  }
  return table;
}

}  // namespace sailmap::app
