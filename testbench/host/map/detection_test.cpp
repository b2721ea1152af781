// Spec section 11: verdicts and their reasons.
#include "sailmap/detection.hpp"

#include <gmock/gmock.h>

#include <random>

#include "sailmap/error.hpp"

namespace sailmap {
namespace {

std::vector<RegionMatch> three_matches(int) { return {{0, 0, 0.1}, {1, 1, 0.1}, {2, 2, 0.1}}; }

TEST(Detection, TheThresholdItselfIsNotEnough) {
  EXPECT_EQ(decide({{0, 20}}, {}, three_matches).reason, Reason::below_threshold);
  EXPECT_EQ(decide({{0, 20.001}}, {}, three_matches).reason, Reason::accepted);
}

TEST(Detection, NamesBestAndRunnerUpOfAnotherPlace) {
  DetectionConfig config;
  config.same_place_nodes = 2;
  const Detection d = decide({{0, 5}, {7, 25}, {8, 60}, {10, 55}, {11, 24}}, config, three_matches);
  EXPECT_EQ(d.best.node, 8);
  EXPECT_EQ(d.runner_up.node, 11);
  EXPECT_DOUBLE_EQ(d.runner_up.similarity, 24);
  EXPECT_EQ(d.matches.size(), 3U);
}

TEST(Detection, TiesGoToTheOldestNode) {
  EXPECT_EQ(decide({{3, 30}, {4, 30}}, {}, three_matches).best.node, 3);
}

TEST(Detection, ARivalOfAnotherPlaceMakesItAmbiguousWhenAsked) {
  DetectionConfig config;
  config.same_place_nodes = 1;
  const std::vector<Candidate> rivals = {{0, 30}, {1, 29}, {5, 27}};
  EXPECT_EQ(decide(rivals, config, three_matches).reason, Reason::accepted);
  config.ambiguity_ratio = 0.9;
  EXPECT_EQ(decide(rivals, config, three_matches).reason, Reason::ambiguous);
  config.ambiguity_ratio = 0.91;
  EXPECT_EQ(decide(rivals, config, three_matches).reason, Reason::accepted);
}

TEST(Detection, TooFewMatchedRegions) {
  DetectionConfig config;
  config.min_matches = 4;
  EXPECT_EQ(decide({{0, 30}}, config, three_matches).reason, Reason::too_few_regions);
}

TEST(Detection, NoVerdictDependsOnWhatDoesNotMatter) {
  std::mt19937 random(5);
  const auto below = [&](int end) { return std::uniform_int_distribution<int>(0, end - 1)(random); };
  int accepted = 0;
  int ambiguous = 0;
  for (int run = 0; run < 2000; ++run) {
    DetectionConfig config;
    config.same_place_nodes = below(4);
    config.min_matches = 3 + below(2);
    config.ambiguity_ratio = 0.1 * (1 + below(14));
    std::vector<Candidate> candidates;
    for (int node = 0; node < 20; ++node) candidates.push_back({node, 1.0 * below(28)});
    const Detection all = decide(candidates, config, three_matches);
    std::erase_if(candidates, [&](const Candidate& c) { return c.similarity < least_that_matters(config); });
    const Detection some = decide(candidates, config, three_matches);
    // Without candidates `decide` cannot know that there were nodes.
    EXPECT_EQ(candidates.empty() ? Reason::below_threshold : some.reason, all.reason);
    if (all.reason != Reason::below_threshold) {
      EXPECT_EQ(some.best, all.best);
    }
    accepted += all.accepted() ? 1 : 0;
    ambiguous += all.reason == Reason::ambiguous ? 1 : 0;
  }
  EXPECT_GT(accepted, 100);
  EXPECT_GT(ambiguous, 100);
}

TEST(Detection, NothingToCompareWith) {
  const Detection d = decide({}, {}, three_matches);
  EXPECT_EQ(d.reason, Reason::no_nodes);
  EXPECT_EQ(d.best.node, -1);
}

TEST(Detection, ReasonsHaveNames) {
  for (const Reason reason : {Reason::accepted, Reason::below_threshold, Reason::too_few_regions,
                              Reason::ambiguous, Reason::excluded, Reason::no_nodes, Reason::no_regions}) {
    EXPECT_EQ(reason_from_name(name(reason)), reason);
  }
  EXPECT_THROW(reason_from_name("whim"), Error);
}

TEST(Detection, ThresholdsFitTheMethodsScale) {
  EXPECT_EQ(default_threshold(Method::paper), 20);
  EXPECT_LT(default_threshold(Method::paper_weighted), 20);
}

}  // namespace
}  // namespace sailmap
