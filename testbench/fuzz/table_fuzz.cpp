// The configuration of `eval --table`.
#include <algorithm>
#include <cmath>

#include "app/table_config.hpp"
#include "foreign_file.hpp"

namespace {

using namespace sailmap;
using fuzz::demand;

template <class Entry>
void check_names(const std::vector<Entry>& entries) {
  demand(!entries.empty(), "there is an entry");
  for (auto entry = entries.begin(); entry != entries.end(); ++entry) {
    demand(
        std::find_if(entries.begin(), entry, [&](const Entry& e) { return e.name == entry->name; }) == entry,
        "each name is there once");
  }
}

void check(const app::TableDataSet& entry) {
  const app::DataSet& data = entry.data;
  demand(!entry.name.empty(), "a data set has a name");
  demand(std::isfinite(data.radius) && data.radius >= 0, "the radius is a distance");
  demand(!entry.length || (std::isfinite(*entry.length) && *entry.length > 0), "the length is a distance");
  demand(data.exclude_recent >= 0, "so many images can be left out");
  demand(entry.vocabulary.empty() || entry.train_on.empty(), "words have one origin");
  if (!entry.skipped.empty()) return;
  demand(data.traverses() ? !data.query.empty() && data.source.empty() : !data.source.empty(),
         "either one sequence or two traverses");
}

void check(const app::TableMethod& method) {
  const std::vector<std::string> known = app::recogniser_names();
  demand(std::ranges::find(known, method.recogniser.method) != known.end(), "a method is one that there is");
  demand(std::isfinite(method.recogniser.config.detection.threshold), "the threshold is finite");
  demand(method.recogniser.config.temporal >= 0 && method.recogniser.config.temporal <= 1000,
         "the filter spans 0 to 1000 images");
  demand(method.training.words >= 2 && method.training.features >= 1, "words can be learned");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static fuzz::ForeignFile file(".json");
  const std::filesystem::path& path = file.hold(data, size);
  const auto config = fuzz::read_foreign(path, [&] { return app::read_table_config(path, {}); });
  if (!config) return 0;
  check_names(config->data_sets);
  check_names(config->methods);
  for (const app::TableDataSet& entry : config->data_sets) {
    check(entry);
    const auto is_named = [&](const app::TableDataSet& other) { return other.name == entry.train_on; };
    demand(entry.train_on.empty() || std::ranges::any_of(config->data_sets, is_named),
           "train_on names a data set");
  }
  for (const app::TableMethod& method : config->methods) check(method);
  return 0;
}
