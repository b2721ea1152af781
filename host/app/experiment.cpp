#include "experiment.hpp"

#include "sailmap/detection.hpp"
#include "sailmap/error.hpp"
#include "sailmap/temporal_filter.hpp"

namespace sailmap::app {
namespace {

// `describe_images(source)` gives a Described<T>.
template <class T, class DescribeImages>
Views<T> views_of(const DataSet& data, DescribeImages describe_images) {
  Described<T> queries = describe_images(data.queries());
  Views<T> out{std::move(queries.images), {}, queries.images_per_second};
  if (data.traverses()) out.candidates = describe_images(data.candidates()).images;
  return out;
}

}  // namespace

std::string DataSet::title() const { return traverses() ? query + " in " + reference : source; }

GroundTruth read_truth(const DataSet& data) {
  GroundTruthOptions options;
  options.queries = count_images(data.queries(), data.selection);
  options.candidates = data.traverses() ? count_images(data.candidates(), data.selection) : options.queries;
  options.same_sequence = !data.traverses();
  options.radius = data.radius;
  options.oxford = data.selection.oxford;
  options.side = data.selection.side;
  return data.reference_poses.empty() ? read_ground_truth(data.ground_truth, options)
                                      : read_ground_truth(data.ground_truth, data.reference_poses, options);
}

std::vector<std::string> recogniser_names() {
  std::vector<std::string> names;
  for (const std::string_view method : method_names()) names.emplace_back(method);
  names.emplace_back(fabmap_name);
  return names;
}

void settle(Recogniser& recogniser, bool threshold_given) {
  MapConfig& config = recogniser.config;
  double threshold = fabmap::default_threshold;
  if (!recogniser.fabmap()) {
    config.match.method = method_from_name(recogniser.method);
    config.regions.describe_place = config.match.method == Method::context;
    threshold = default_threshold(config.match.method);
    config.sparse_threshold = threshold;
  }
  if (!threshold_given) config.detection.threshold = threshold;
}

Views<Signature> describe(const DataSet& data, const std::string& frontend, const RegionConfig& regions) {
  return views_of<Signature>(data, [&](const std::string& source) {
    return describe_source(source, data.selection, frontend, regions);
  });
}

Views<fabmap::Words> describe(const DataSet& data, const fabmap::Vocabulary& vocabulary) {
  return views_of<fabmap::Words>(
      data, [&](const std::string& source) { return find_words(source, data.selection, vocabulary); });
}

Plane<float> score(const DataSet& data, const Views<Signature>& views, const Recogniser& recogniser) {
  const MatchConfig& match = recogniser.config.match;
  Plane<float> scores = data.traverses() ? score_traverses(views.queries, views.candidates, match)
                                         : score_sequence(views.queries, data.exclude_recent, match);
  if (recogniser.config.temporal < 2) return scores;
  return filter_scores(scores, temporal_config(match.method, recogniser.config.temporal));
}

Plane<float> score(const DataSet& data, const Views<fabmap::Words>& views, const Recogniser& recogniser,
                   const fabmap::Vocabulary& vocabulary) {
  const Plane<float> scores = data.traverses()
                                  ? fabmap::score_traverses(views.queries, views.candidates, vocabulary)
                                  : fabmap::score_sequence(views.queries, data.exclude_recent, vocabulary);
  return fabmap::filter_log_odds(scores, recogniser.config.temporal);
}

}  // namespace sailmap::app
