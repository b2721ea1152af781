// The figures of docs/recognition.md, a little below: real sequences, one configuration.
#include <gtest/gtest.h>
#include <tbb/parallel_for.h>

#include <functional>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "sailmap/detection.hpp"
#include "sailmap/evaluation.hpp"
#include "sailmap/frontend.hpp"
#include "sailmap/image_source.hpp"
#include "sailmap/temporal_filter.hpp"
#include "sailmap_data.hpp"

namespace sailmap {
namespace {

using Change = std::function<void(cv::Mat& image, std::size_t index)>;

std::vector<Signature> describe_all(const std::vector<std::filesystem::path>& paths,
                                    const Change& change = {}) {
  std::vector<Signature> out(paths.size());
  RegionConfig config;
  config.describe_place = true;
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, paths.size(), 20), [&](const auto& range) {
    const auto frontend = make_frontend("quantised");
    Maps maps;
    for (std::size_t i = range.begin(); i < range.end(); ++i) {
      cv::Mat image = read_image(paths[i]);
      if (change) change(image, i);
      frontend->compute(view_of(image), maps);
      out[i] = make_signature(maps, config);
    }
  });
  return out;
}

struct Figures {
  double average_precision, recall_at_100, precision, recall;
};

void expect_at_least(const Evaluation& e, const Figures& least) {
  EXPECT_GE(e.average_precision, least.average_precision);
  EXPECT_GE(e.recall_at_100, least.recall_at_100);
  EXPECT_GE(e.fixed.precision, least.precision);
  EXPECT_GE(e.fixed.recall, least.recall);
}

void expect_figures(const std::string& name, int exclude, const Figures& single, const Figures& filtered) {
  const auto folder = testing::data_folder() / name;
  const std::vector<Signature> images = describe_all(list_images((folder / "images").string()));
  const auto count = static_cast<int>(images.size());
  const GroundTruth truth = read_text_ground_truth(folder / "ground_truth.txt", count, count);
  MatchConfig config;
  config.method = Method::context;
  const Plane<float> scores = score_sequence(images, exclude, config);
  const double threshold = default_threshold(Method::context);
  expect_at_least(evaluate(scores, truth, threshold), single);
  const Plane<float> sequences =
      filter_scores(scores, temporal_config(Method::context, default_temporal_images));
  expect_at_least(evaluate(sequences, truth, threshold), filtered);
}

TEST(RealSequences, Corridor) {
  SAILMAP_NEEDS_DATA("rtabmap_corridor");
  expect_figures("rtabmap_corridor", 20, {0.94, 0.8, 0.95, 0.88}, {0.98, 0.95, 0.95, 0.93});
}

TEST(RealSequences, GardensPoint) {
  SAILMAP_NEEDS_DATA("gardens_point");
  expect_figures("gardens_point", 50, {0.985, 0.8, 0.95, 0.74}, {0.985, 0.9, 0.95, 0.85});
}

// The second of two laps has lost its colours, of which the map says much.
TEST(RealSequences, AGreyLapIsRecognisedAmongColouredImages) {
  SAILMAP_NEEDS_DATA("gardens_point");
  constexpr int lap = 50;
  const auto all = list_images((testing::data_folder() / "gardens_point" / "images").string());
  std::vector<std::filesystem::path> paths;
  for (std::size_t i = 0; i < all.size(); i += 4) paths.push_back(all[i]);
  ASSERT_EQ(paths.size(), 2 * lap);
  const auto images = describe_all(paths, [](cv::Mat& image, std::size_t i) {
    if (i < lap) return;
    cv::cvtColor(image, image, cv::COLOR_BGR2GRAY);
    cv::cvtColor(image, image, cv::COLOR_GRAY2BGR);
  });
  MatchConfig config;
  config.method = Method::context;
  GroundTruth truth{std::vector<std::vector<int>>(images.size())};
  for (int place = 0; place < lap; ++place) truth.matches[static_cast<std::size_t>(lap + place)] = {place};
  const Evaluation single =
      evaluate(score_sequence(images, 10, config), truth, default_threshold(Method::context));
  EXPECT_GE(single.average_precision, 0.7);
}

}  // namespace
}  // namespace sailmap
