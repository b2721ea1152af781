#include "measurement.hpp"

#include <fmt/format.h>

#include <utility>

#include "evaluate/evaluation_json.hpp"
#include "map/config_json.hpp"

namespace sailmap::app {
namespace {

using nlohmann::ordered_json;

Measurement measured(const DataSet& data, const GroundTruth& truth, const Recogniser& recogniser,
                     Plane<float> scores, double images_per_second) {
  Measurement out;
  out.data = data;
  out.recogniser = recogniser;
  out.evaluation = evaluate(scores, truth, recogniser.config.detection.threshold);
  out.images = scores.height();
  out.candidates = scores.width();
  out.scores = std::move(scores);
  out.images_per_second = images_per_second;
  return out;
}

ordered_json words_config(const Measurement& m, const fabmap::Vocabulary& vocabulary) {
  const MapConfig& config = m.recogniser.config;
  ordered_json json = {{"vocabulary",
                        {{"file", m.recogniser.vocabulary.string()},
                         {"words", vocabulary.tree.size()},
                         {"features", vocabulary.features},
                         {"training_images", vocabulary.training.size()}}}};
  if (m.recogniser.method == fabmap_name) {
    const fabmap::FabmapConfig fabmap;
    json["fabmap"] = {{"detect_present", fabmap.detect_present},
                      {"detect_absent", fabmap.detect_absent},
                      {"new_place_prior", fabmap.new_place_prior}};
  }
  json["detection"] = {{"threshold", config.detection.threshold}};
  json["exclude_recent"] = m.data.exclude_recent;
  json["temporal"] = config.temporal;
  return json;
}

}  // namespace

Measurement measure(const DataSet& data, const GroundTruth& truth, const Views<Signature>& views,
                    const Recogniser& recogniser) {
  Measurement out =
      measured(data, truth, recogniser, score(data, views, recogniser), views.images_per_second);
  MapConfig config = recogniser.config;
  config.exclude_recent = data.exclude_recent;
  out.config = to_json(config);
  return out;
}

Measurement measure(const DataSet& data, const GroundTruth& truth, const Views<fabmap::Histogram>& views,
                    const Recogniser& recogniser, const fabmap::Vocabulary& vocabulary) {
  Measurement out =
      measured(data, truth, recogniser, score(data, views, recogniser, vocabulary), views.images_per_second);
  out.config = words_config(out, vocabulary);
  return out;
}

std::string title_of(const Measurement& m) {
  std::string title = m.data.title() + ", " + m.recogniser.method;
  if (m.recogniser.config.temporal > 1) {
    title += fmt::format(", temporal filter of {} images", m.recogniser.config.temporal);
  }
  return title;
}

ordered_json to_json(const Measurement& m) {
  ordered_json json;
  if (m.data.traverses()) {
    json = {{"query", m.data.query}, {"reference", m.data.reference}};
  } else {
    json = {{"source", m.data.source}};
  }
  json.update(
      {{"ground_truth", m.data.ground_truth},
       {"frontend", m.recogniser.on_words() ? ordered_json(nullptr) : ordered_json(m.recogniser.frontend)},
       {"method", m.recogniser.method},
       {"config", m.config},
       {"images", m.images},
       {"candidates", m.candidates},
       {"images_per_second", m.images_per_second}});
  json.update(to_json(m.evaluation));
  return json;
}

void print(const Measurement& m) {
  const Evaluation& e = m.evaluation;
  const std::string described_by = m.recogniser.on_words() ? "vocabulary " + m.recogniser.vocabulary.string()
                                                           : "front end " + m.recogniser.frontend;
  fmt::print("{}\n", title_of(m));
  fmt::print("{} queries, {} with a true match among their candidates; {}, {:.1f} images per second\n\n",
             e.queries, e.queries_with_match, described_by, m.images_per_second);
  fmt::print("at threshold {:g}:  {:>10} {:>6} {:>14} {:>11}\n", e.fixed.threshold, "detections", "right",
             "precision (%)", "recall (%)");
  fmt::print("{:{}}  {:>10} {:>6} {:>14.1f} {:>11.1f}\n\n", "",
             fmt::formatted_size("at threshold {:g}:", e.fixed.threshold), e.fixed.detections, e.fixed.right,
             100 * e.fixed.precision, 100 * e.fixed.recall);
  fmt::print("average precision             {:.3f}\n", e.average_precision);
  fmt::print("recall at 100 % precision     {:.3f}\n", e.recall_at_100);
  fmt::print("recall at 95 % precision      {:.3f}\n", e.recall_at_95);
  fmt::print("best F1                       {:.3f} at threshold {:g}\n", e.best_f1, e.best_f1_threshold);
  for (std::size_t k = 0; k < recall_ranks.size(); ++k) {
    fmt::print("{:<30}{:.3f}\n", fmt::format("recall@{}", recall_ranks[k]), e.recall_at[k]);
  }
}

}  // namespace sailmap::app
