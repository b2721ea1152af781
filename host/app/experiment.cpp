#include "experiment.hpp"

#include <limits>

#include "sailmap/bag_of_words.hpp"
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

std::vector<fabmap::Words> words_of(const std::vector<fabmap::Histogram>& images) {
  std::vector<fabmap::Words> words;
  for (const fabmap::Histogram& image : images) words.push_back(image.words);
  return words;
}

Plane<float> fabmap_scores(const DataSet& data, const Views<fabmap::Histogram>& views,
                           const fabmap::Vocabulary& vocabulary) {
  const std::vector<fabmap::Words> queries = words_of(views.queries);
  return data.traverses() ? fabmap::score_traverses(queries, words_of(views.candidates), vocabulary)
                          : fabmap::score_sequence(queries, data.exclude_recent, vocabulary);
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
  names.emplace_back(bow_name);
  return names;
}

void settle(Recogniser& recogniser, bool threshold_given) {
  MapConfig& config = recogniser.config;
  double threshold = recogniser.method == bow_name ? bow::default_threshold : fabmap::default_threshold;
  if (!recogniser.on_words()) {
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

Views<fabmap::Histogram> describe(const DataSet& data, const fabmap::Vocabulary& vocabulary) {
  return views_of<fabmap::Histogram>(
      data, [&](const std::string& source) { return find_words(source, data.selection, vocabulary); });
}

Plane<float> score(const DataSet& data, const Views<Signature>& views, const Recogniser& recogniser) {
  const MatchConfig& match = recogniser.config.match;
  Plane<float> scores = data.traverses() ? score_traverses(views.queries, views.candidates, match)
                                         : score_sequence(views.queries, data.exclude_recent, match);
  if (recogniser.config.temporal < 2) return scores;
  return filter_scores(scores, temporal_config(match.method, recogniser.config.temporal));
}

Plane<float> score(const DataSet& data, const Views<fabmap::Histogram>& views, const Recogniser& recogniser,
                   const fabmap::Vocabulary& vocabulary) {
  const int temporal = recogniser.config.temporal;
  if (recogniser.method == fabmap_name) {
    return fabmap::filter_log_odds(fabmap_scores(data, views, vocabulary), temporal);
  }
  const Plane<float> scores = data.traverses()
                                  ? bow::score_traverses(views.queries, views.candidates, vocabulary)
                                  : bow::score_sequence(views.queries, data.exclude_recent, vocabulary);
  // Cosines are within 0 and 1 already.
  return filter_scores(scores, {.images = temporal, .scale = std::numeric_limits<double>::infinity()});
}

}  // namespace sailmap::app
