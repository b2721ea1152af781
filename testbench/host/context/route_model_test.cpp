// The model of a route on likelihoods made by hand: what it foretells, and what it learns of steps and
// breaks.
#include "sailmap/route_model.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

namespace sailmap {
namespace {

constexpr int places = 60;

// One place stands out by so much; the mean is 1.
std::vector<float> seen_at(int place, float by = 20) {
  const float mean = (places - 1 + by) / places;
  std::vector<float> out(places, 1 / mean);
  out[static_cast<std::size_t>(place)] = by / mean;
  return out;
}

RouteModel::Estimate follow(RouteModel& model, int images, const std::function<int(int)>& place) {
  RouteModel::Estimate last;
  for (int i = 0; i < images; ++i) last = model.advance(seen_at(place(i)), places, 0);
  return last;
}

std::ptrdiff_t best(const std::vector<float>& values) {
  return std::max_element(values.begin(), values.end()) - values.begin();
}

TEST(RouteModel, KnowsNothingBeforeTheFirstImage) {
  RouteModel model(10);
  const RouteModel::Estimate first = model.advance(seen_at(7), places, 0);
  for (const float value : first.prior) EXPECT_EQ(value, 1);
  EXPECT_EQ(first.expected, 1);
  EXPECT_EQ(model.trust(), 0);
}

TEST(RouteModel, OneForecastThatHeldProvesNothing) {
  RouteModel model(10);
  const RouteModel::Estimate second = follow(model, 2, [](int i) { return i + 5; });
  for (const float value : second.prior) EXPECT_NEAR(value, 1, 1e-5);
}

TEST(RouteModel, ForetellsTheNextPlaceInEitherDirectionAndAtAnySpeed) {
  for (const int speed : {1, 2, 3, -1, -3}) {
    RouteModel model(10);
    const auto place = [speed](int i) { return (speed > 0 ? 0 : places - 1) + speed * i; };
    const RouteModel::Estimate last = follow(model, 19, place);
    EXPECT_EQ(best(last.prior), place(18)) << speed;
    EXPECT_EQ(best(last.followed), place(18)) << speed;
    EXPECT_GT(last.expected, 3) << speed;
    EXPECT_GT(model.trust(), 0.9) << speed;
  }
}

TEST(RouteModel, TrustsNoRouteWhereImagesJump) {
  RouteModel model(10);
  follow(model, 100, [](int i) { return i * 37 % places; });
  EXPECT_LT(model.trust(), 0.1);
}

TEST(RouteModel, LearnsHowOftenARouteBreaks) {
  RouteModel whole(10);
  RouteModel broken(10);
  follow(whole, 60, [](int i) { return i; });
  follow(broken, 60, [](int i) { return i / 6 * 23 % 50 + i % 6; });
  EXPECT_LT(whole.observed_breaks(), 0.05);
  EXPECT_GT(broken.observed_breaks(), 0.06);
}

TEST(RouteModel, ABreakIsNotExpected) {
  RouteModel model(10);
  follow(model, 30, [](int i) { return i; });
  const RouteModel::Estimate jump = model.advance(seen_at(55, 200), places, 0);
  EXPECT_LT(jump.expected, 0.7);
  EXPECT_LT(jump.prior[55], 0.2);
}

TEST(RouteModel, APathThatRunsOffTheMapMayBeAnywhere) {
  RouteModel model(10);
  const RouteModel::Estimate amid = follow(model, 20, [](int i) { return 3 * i; });
  EXPECT_LT(amid.prior[20], 0.3);
  EXPECT_GT(amid.on_map, 0.9);
  const double breaks = model.observed_breaks();
  const RouteModel::Estimate beyond = model.advance(seen_at(20), places, 0);
  EXPECT_GT(beyond.prior[20], 0.7);
  EXPECT_LT(beyond.on_map, 0.5);
  EXPECT_LT(model.observed_breaks(), breaks + 0.02);  // hardly a break
}

TEST(RouteModel, APathIsAttestedOnceAnImageShowedItsPlaceAndUntilItLeavesTheMap) {
  RouteModel model(10);
  const auto at = [&](int place, double shown) {
    return model.advance(seen_at(place), places, shown).attested;
  };
  for (int i = 30; i < 40; ++i) EXPECT_EQ(at(i, 0), 0) << i;
  EXPECT_EQ(at(40, 1), 0);  // the images before
  for (int i = 41; i < places; ++i) EXPECT_GT(at(i, 0), 0.8) << i;
  EXPECT_LT(at(20, 0), 0.7);
  EXPECT_LT(at(21, 0), 0.1);
}

TEST(RouteModel, HowSurelyAnImageShowsItsPlaceCounts) {
  RouteModel model(10);
  const auto at = [&](int place, double shown) {
    return model.advance(seen_at(place), places, shown).attested;
  };
  for (int i = 0; i < 20; ++i) at(i, 0);
  at(20, 0.5);
  EXPECT_NEAR(at(21, 0.5), 0.5, 0.02);
  EXPECT_NEAR(at(22, 0), 0.75, 0.03);
}

TEST(RouteModel, ALostPathIsForgottenButNotWhatWasLearned) {
  RouteModel model(10);
  follow(model, 30, [](int i) { return i; });
  const double trust = model.trust();
  model.lose();
  EXPECT_EQ(model.trust(), trust);
  for (const float value : model.advance(seen_at(31), places, 0).prior) EXPECT_EQ(value, 1);
}

}  // namespace
}  // namespace sailmap
