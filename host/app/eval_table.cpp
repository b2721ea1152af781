#include "eval_table.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "sailmap/error.hpp"
#include "sailmap/image_source.hpp"

namespace sailmap::app {
namespace {

// Of more images the words would not be better, but the wait and the memory greater.
constexpr std::size_t most_training_images = 500;

double length_of(const std::vector<Pose>& poses) {
  double metres = 0;
  for (std::size_t i = 1; i < poses.size(); ++i) {
    metres += std::hypot(poses[i].x - poses[i - 1].x, poses[i].y - poses[i - 1].y);
  }
  return metres / 1000;
}

class Evaluator {
 public:
  Evaluator(const TableConfig& config, std::string name) : config_(config), name_(std::move(name)) {}

  Table run() {
    prepare();
    Table table;
    for (const TableMethod& method : config_.methods) table.methods.push_back(method.name);
    for (const TableDataSet& entry : config_.data_sets) table.rows.push_back(row(entry));
    return table;
  }

 private:
  // Does the work of one data set; what goes wrong is told with its name.
  template <class Work>
  auto named(const TableDataSet& entry, Work work) const {
    try {
      return work();
    } catch (const Error& fault) {
      throw Error(name_ + ": data set '" + entry.name + "': " + fault.what());
    }
  }

  // Ground truths and vocabulary files of all data sets, so that what is wrong with the last one is told
  // before the first one is evaluated.
  void prepare() {
    for (const TableMethod& method : config_.methods) {
      if (method.recogniser.vocabulary.empty()) continue;
      try {
        read_vocabulary(method.recogniser.vocabulary);
      } catch (const Error& fault) {
        throw Error(name_ + ": method '" + method.name + "': " + fault.what());
      }
    }
    for (const TableDataSet& entry : config_.data_sets) {
      if (!entry.skipped.empty()) continue;
      named(entry, [&] {
        truths_[entry.name] = read_truth(entry.data);
        if (!entry.vocabulary.empty()) read_vocabulary(entry.vocabulary);
      });
    }
  }

  const fabmap::Vocabulary& read_vocabulary(const std::filesystem::path& path) {
    const auto found = vocabularies_.find(path.string());
    if (found != vocabularies_.end()) return found->second;
    return vocabularies_.emplace(path.string(), fabmap::read_vocabulary(path)).first->second;
  }

  // Words learned from at most most_training_images images of a data set, evenly spread.
  const fabmap::Vocabulary& learned(const TableDataSet& from, const fabmap::TrainingConfig& training) {
    const std::string key = "train_on " + from.name + " " + std::to_string(training.words) + " " +
                            std::to_string(training.features);
    const auto found = vocabularies_.find(key);
    if (found != vocabularies_.end()) return found->second;
    const auto all = selected_images(from.data.candidates(), from.data.selection);
    const std::size_t count = std::min(all.size(), most_training_images);
    const auto image = [&](std::size_t i) { return read_image(all[i * all.size() / count]); };
    return vocabularies_.emplace(key, named(from, [&] { return fabmap::train(count, image, training); }))
        .first->second;
  }

  TableRow row(const TableDataSet& entry) {
    TableRow out;
    out.name = entry.name;
    out.skipped = entry.skipped;
    out.cells.resize(config_.methods.size());
    for (TableCell& cell : out.cells) cell.skipped = entry.skipped;
    if (!entry.skipped.empty()) return out;
    out.length = entry.length;
    if (!out.length && holds_poses(entry.data.ground_truth)) {
      out.length = length_of(read_poses(entry.data.ground_truth));
    }
    out.images = static_cast<int>(truths_.at(entry.name).matches.size());
    named(entry, [&] { measure_signatures(entry, out.cells); });
    for (std::size_t m = 0; m < config_.methods.size(); ++m) {
      if (config_.methods[m].recogniser.fabmap()) out.cells[m] = measure_fabmap(entry, config_.methods[m]);
    }
    return out;
  }

  // The images are described once for all methods that work on signatures.
  void measure_signatures(const TableDataSet& entry, std::vector<TableCell>& cells) {
    const Recogniser* any = nullptr;
    bool describe_place = false;
    for (const TableMethod& method : config_.methods) {
      if (method.recogniser.fabmap()) continue;
      any = &method.recogniser;
      describe_place = describe_place || method.recogniser.config.regions.describe_place;
    }
    if (any == nullptr) return;
    RegionConfig regions = any->config.regions;
    regions.describe_place = describe_place;
    const Views<Signature> views = describe(entry.data, any->frontend, regions);
    for (std::size_t m = 0; m < cells.size(); ++m) {
      const Recogniser& recogniser = config_.methods[m].recogniser;
      if (recogniser.fabmap()) continue;
      cells[m].measurement = measure(entry.data, truths_.at(entry.name), views, recogniser);
      cells[m].measurement->scores = {};
    }
  }

  TableCell measure_fabmap(const TableDataSet& entry, const TableMethod& method) {
    TableCell cell;
    Recogniser recogniser = method.recogniser;
    const fabmap::Vocabulary* vocabulary = nullptr;
    if (!entry.train_on.empty()) {
      const TableDataSet& from = *std::ranges::find(config_.data_sets, entry.train_on, &TableDataSet::name);
      if (!from.skipped.empty()) {
        cell.skipped = "its words are learned from " + from.name + ", which is skipped";
        return cell;
      }
      vocabulary = &learned(from, method.training);
      recogniser.vocabulary = "learned from " + from.name;
    } else {
      if (!entry.vocabulary.empty()) recogniser.vocabulary = entry.vocabulary;
      if (recogniser.vocabulary.empty()) {
        cell.skipped = "it has no vocabulary: give the data set vocabulary or train_on";
        return cell;
      }
      vocabulary = &read_vocabulary(recogniser.vocabulary);
    }
    cell.measurement = named(entry, [&] {
      return measure(entry.data, truths_.at(entry.name), describe(entry.data, *vocabulary), recogniser,
                     *vocabulary);
    });
    cell.measurement->scores = {};
    return cell;
  }

  const TableConfig& config_;
  std::string name_;
  std::map<std::string, GroundTruth> truths_;
  std::map<std::string, fabmap::Vocabulary> vocabularies_;
};

}  // namespace

Table evaluate_table(const TableConfig& config, const std::string& name) {
  return Evaluator(config, name).run();
}

}  // namespace sailmap::app
