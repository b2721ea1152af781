// What neighbours in the route say of a candidate.
#include "context/neighbour_evidence.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "sailmap/context.hpp"
#include "synthetic_maps.hpp"

namespace sailmap {
namespace {

using context::mean_along_route;
using testing::scene_maps;

struct Route {
  std::vector<PlaceDescriptor> places;

  [[nodiscard]] std::vector<const PlaceDescriptor*> pointers() const {
    std::vector<const PlaceDescriptor*> out;
    for (const PlaceDescriptor& place : places) out.push_back(&place);
    return out;
  }
};

// Two images of one place, then one of another, then the first place again.
Route places() {
  Route route;
  for (const Maps& maps : {scene_maps(1), scene_maps(1, 3), scene_maps(2), scene_maps(1)}) {
    route.places.push_back(describe_place(maps));
  }
  return route;
}

TEST(NeighbourEvidence, NeighboursThatShowThePlaceCountWithSixTenths) {
  const Route route = places();
  ASSERT_GT(match_contexts(route.places[0], route.places[1]).similarity, 0.15);
  ASSERT_LT(match_contexts(route.places[1], route.places[2]).similarity, 0.05);
  const auto means = mean_along_route(route.pointers(), {0, 1, 2, 3}, {1.0, 0.5, 0.25, 0.75});
  ASSERT_EQ(means.size(), 4U);
  EXPECT_DOUBLE_EQ(means[0], (1.0 + 0.6 * 0.5) / 1.6);
  EXPECT_DOUBLE_EQ(means[1], (0.5 + 0.6 * 1.0) / 1.6);
  EXPECT_DOUBLE_EQ(means[2], 0.25);  // between two of another place
  EXPECT_DOUBLE_EQ(means[3], 0.75);  // the same place, but not next to it in the route
}

TEST(NeighbourEvidence, ThePartSharedRisesWithSimilarity) {
  double last = 0.4;  // that of the neighbour, who counts for little at first
  for (const double shift : {70.0, 50.0, 30.0, 10.0}) {
    Route route;
    route.places = {describe_place(scene_maps(5)), describe_place(scene_maps(5, shift))};
    const double similarity = match_contexts(route.places[0], route.places[1]).similarity;
    const double shared = std::clamp((similarity - 0.05) / 0.1, 0.0, 1.0);
    const double mean = mean_along_route(route.pointers(), {0, 1}, {0.4, 1.0})[0];
    EXPECT_NEAR(mean, (0.4 + 0.6 * shared) / (1 + 0.6 * shared), 1e-12);
    EXPECT_GE(mean, last);
    last = mean;
  }
  EXPECT_GT(last, 0.6);
}

TEST(NeighbourEvidence, ANeighbourThatWasNotProposedHasNoEvidence) {
  const Route route = places();
  EXPECT_DOUBLE_EQ(mean_along_route(route.pointers(), {1}, {0.5}).front(), 0.5 / 1.6);
  EXPECT_TRUE(mean_along_route(route.pointers(), {}, {}).empty());
}

TEST(NeighbourEvidence, TheOrderOfProposalsDoesNotMatter) {
  const Route route = places();
  const auto forwards = mean_along_route(route.pointers(), {0, 1, 3}, {1.0, 0.5, 0.75});
  const auto mixed = mean_along_route(route.pointers(), {3, 1, 0}, {0.75, 0.5, 1.0});
  EXPECT_EQ(forwards, (std::vector<double>{mixed[2], mixed[1], mixed[0]}));
}

// One image of two places that cannot be told apart: the route around it tells.
TEST(NeighbourEvidence, OfEqualCandidatesTheOneWithRightNeighboursWins) {
  const PlaceDescriptor image = describe_place(scene_maps(3, 20));
  std::vector<PlaceDescriptor> route;
  for (const double moved : {55.0, 20.0, 55.0}) route.push_back(describe_place(scene_maps(3, moved)));
  for (unsigned other = 10; other < 30; ++other) route.push_back(describe_place(scene_maps(other)));
  for (const double moved : {5.0, 20.0, 5.0}) route.push_back(describe_place(scene_maps(3, moved)));
  ASSERT_EQ(route[1], image);
  ASSERT_EQ(route[24], image);
  const auto scores = score_contexts(describe_place(scene_maps(3)), Route{route}.pointers());
  const auto odds = [](float score) { return score / (1 - score); };
  EXPECT_GT(odds(scores[24]), 2 * odds(scores[1]));
}

}  // namespace
}  // namespace sailmap
