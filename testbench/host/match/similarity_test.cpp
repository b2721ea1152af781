// Spec section 10: both constraints and eq. 7, by hand.
#include "sailmap/similarity.hpp"

#include <gmock/gmock.h>

#include "host/map_builders.hpp"
#include "sailmap/error.hpp"

namespace sailmap {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using testing::region;
using testing::signature;

MatchConfig method(Method value) {
  MatchConfig config;
  config.method = value;
  return config;
}

TEST(Similarity, OnlyPositionsNearerThanDeltaAreAdmissible) {
  // Delta = 15 % of 500 = 75 pixels; exactly 75 is too far.
  const Signature query = signature({region(100, 100, 0)});
  EXPECT_THAT(nearest_matches(query, signature({region(100, 175, 0)}), {}), IsEmpty());
  EXPECT_THAT(nearest_matches(query, signature({region(100, 174, 0)}), {}),
              ElementsAre(RegionMatch{0, 0, 0}));
}

TEST(Similarity, EachRegionTakesTheAdmissibleOneOfLeastDistance) {
  const Signature query = signature({region(100, 100, 1), region(200, 300, 5)});
  const Signature candidate =
      signature({region(200, 310, 9), region(110, 100, 1.5), region(90, 100, 0.75), region(300, 100, 1)});
  EXPECT_THAT(nearest_matches(query, candidate, {}),
              ElementsAre(RegionMatch{0, 2, 0.25}, RegionMatch{1, 0, 4}));
}

TEST(Similarity, TiesGoToTheFirstCandidate) {
  const Signature query = signature({region(100, 100, 1)});
  const Signature candidate = signature({region(110, 100, 2), region(90, 100, 0)});
  EXPECT_THAT(nearest_matches(query, candidate, {}), ElementsAre(RegionMatch{0, 0, 1}));
}

TEST(Similarity, TheLargestSetOfOneDisplacementCounts) {
  // Tolerance 8 % of 500 = 40 pixels. Three regions move by (10, 0), one by (-50, 0), which is too different.
  const Signature query =
      signature({region(50, 50, 0), region(150, 50, 1), region(50, 300, 2), region(200, 300, 3)});
  const Signature candidate =
      signature({region(60, 50, 0), region(160, 50, 1), region(60, 300, 2), region(150, 300, 3)});
  const auto nearest = nearest_matches(query, candidate, {});
  ASSERT_EQ(nearest.size(), 4U);
  EXPECT_THAT(consistent_matches(query, candidate, nearest, {}),
              ElementsAre(RegionMatch{0, 0, 0}, RegionMatch{1, 1, 0}, RegionMatch{2, 2, 0}));
}

TEST(Similarity, DisplacementsAgreeWithTheOneThatMostAgreeWith) {
  // Displacements 0, 40, 80 along x: 0 and 80 do not agree with each other, but both with 40 (within 40
  // pixels).
  const Signature query = signature({region(20, 50, 0), region(20, 200, 1), region(20, 350, 2)});
  const Signature candidate = signature({region(20, 50, 0), region(60, 200, 1), region(100, 350, 2)});
  MatchConfig config;
  config.search_radius = 0.2;
  EXPECT_EQ(match(query, candidate, config).matches.size(), 3U);
  config.displacement_tolerance = 0.079;
  EXPECT_EQ(match(query, candidate, config).matches.size(), 1U);
}

TEST(Similarity, Equation7) {
  const Signature query = signature({region(50, 50, 0), region(150, 50, 1), region(150, 250, 2)});
  const Signature candidate =
      signature({region(50, 50, 0.25), region(150, 50, 1.25), region(290, 390, 2), region(10, 390, 2)});
  // Two of 3 and 4 regions match, at 0.25 each.
  EXPECT_DOUBLE_EQ(match(query, candidate, method(Method::paper)).similarity, 2 / 0.5);
  EXPECT_DOUBLE_EQ(match(query, candidate, method(Method::paper_weighted)).similarity, 2 * 2 / (4 * 0.5));
}

TEST(Similarity, MethodsAgreeWhereAllRegionsMatch) {
  const Signature query = signature({region(50, 50, 0), region(150, 50, 1)});
  const Signature candidate = signature({region(50, 50, 0.5), region(150, 50, 1.25)});
  EXPECT_DOUBLE_EQ(match(query, candidate, method(Method::paper)).similarity, 2 / 0.75);
  EXPECT_DOUBLE_EQ(match(query, candidate, method(Method::paper_weighted)).similarity, 2 / 0.75);
}

TEST(Similarity, IdenticalImagesAreCappedAndNoMatchIsZero) {
  const Signature image = testing::image_of_place(3);
  for (const Method value : {Method::paper, Method::paper_weighted}) {
    EXPECT_DOUBLE_EQ(match(image, image, method(value)).similarity, 1e6);
    EXPECT_DOUBLE_EQ(match(image, signature({}), method(value)).similarity, 0);
    EXPECT_DOUBLE_EQ(match(signature({}), image, method(value)).similarity, 0);
    EXPECT_DOUBLE_EQ(
        match(signature({region(0, 0, 1)}), signature({region(299, 399, 1)}), method(value)).similarity, 0);
  }
}

TEST(Similarity, RefusesImagesOfDifferentSizeAndBadConfigurations) {
  Signature other = testing::image_of_place(0);
  other.width = 301;
  EXPECT_THROW(match(testing::image_of_place(0), other, {}), Error);
  const auto fault = [](auto change) {
    MatchConfig config;
    change(config);
    EXPECT_THROW(match(testing::image_of_place(0), testing::image_of_place(0), config), Error);
  };
  fault([](MatchConfig& c) { c.search_radius = 0; });
  fault([](MatchConfig& c) { c.displacement_tolerance = -0.1; });
  fault([](MatchConfig& c) { c.similarity_cap = 0; });
}

TEST(Similarity, MethodsHaveNames) {
  for (const std::string_view text : method_names()) EXPECT_EQ(name(method_from_name(text)), text);
  EXPECT_THROW(method_from_name("best"), Error);
}

}  // namespace
}  // namespace sailmap
