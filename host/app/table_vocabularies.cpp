#include "table_vocabularies.hpp"

#include <algorithm>

#include "sailmap/error.hpp"
#include "sailmap/image_source.hpp"

namespace sailmap::app {
namespace {

// Of more images the words would not be better, but the wait and the memory greater.
constexpr std::size_t most_training_images = 500;

}  // namespace

const fabmap::Vocabulary& Vocabularies::read(const std::filesystem::path& path) {
  const auto found = known_.find(path.string());
  if (found != known_.end()) return found->second;
  return known_.emplace(path.string(), fabmap::read_vocabulary(path)).first->second;
}

// Of images evenly spread.
const fabmap::Vocabulary& Vocabularies::learn(const TableDataSet& from,
                                              const fabmap::TrainingConfig& training) {
  const std::string key = "train_on " + from.name + " " + std::to_string(training.words) + " " +
                          std::to_string(training.features);
  const auto found = known_.find(key);
  if (found != known_.end()) return found->second;
  try {
    const auto all = selected_images(from.data.candidates(), from.data.selection);
    const std::size_t count = std::min(all.size(), most_training_images);
    const auto image = [&](std::size_t i) { return read_image(all[i * all.size() / count]); };
    return known_.emplace(key, fabmap::train(count, image, training)).first->second;
  } catch (const Error& fault) {
    throw Error("learning words from '" + from.name + "': " + fault.what());
  }
}

ChosenVocabulary Vocabularies::choose(const TableDataSet& entry, const TableMethod& method) {
  if (!entry.train_on.empty()) {
    const auto from = std::ranges::find(config_.data_sets, entry.train_on, &TableDataSet::name);
    if (!from->skipped.empty()) {
      return {nullptr, {}, "its words are learned from " + from->name + ", which is skipped"};
    }
    return {&learn(*from, method.training), "learned from " + from->name, {}};
  }
  const std::filesystem::path& file =
      entry.vocabulary.empty() ? method.recogniser.vocabulary : entry.vocabulary;
  if (file.empty()) return {nullptr, {}, "it has no vocabulary: give the data set vocabulary or train_on"};
  return {&read(file), file, {}};
}

}  // namespace sailmap::app
