// Scores read as evidence: odds, what stands out, what is usual for a candidate.
#include "sailmap/score_evidence.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numeric>

namespace sailmap {
namespace {

constexpr double bounded = std::numeric_limits<double>::infinity();
const float none = std::nanf("");

TEST(ScoreEvidence, OddsOfBothScales) {
  const std::vector<float> parts = {0.5F, 0.75F, 0.0F, 1.0F};
  const ScoreEvidence::Row row = ScoreEvidence(bounded).read(parts);
  EXPECT_FLOAT_EQ(row.odds[0], 1);
  EXPECT_FLOAT_EQ(row.odds[1], 3);
  EXPECT_EQ(row.odds[2], 0);
  EXPECT_TRUE(std::isfinite(row.odds[3]));
  EXPECT_FLOAT_EQ(ScoreEvidence(bounded).score(3), 0.75F);
  const std::vector<float> sums = {3.0F, 12.0F, -1.0F};
  const ScoreEvidence wide(3);
  EXPECT_FLOAT_EQ(wide.read(sums).odds[1], 4);
  EXPECT_EQ(wide.read(sums).odds[2], 0);
  EXPECT_FLOAT_EQ(wide.score(4), 12);
}

TEST(ScoreEvidence, WhatAllCandidatesHaveInCommonDoesNotStandOut) {
  const std::vector<float> scores = {3, 3, 6, 3, none};
  const ScoreEvidence::Row row = ScoreEvidence(3).read(scores);
  EXPECT_EQ(row.count, 4);
  EXPECT_EQ(row.standing, (std::vector<float>{0, 0, 1, 0, 0}));
  EXPECT_FALSE(row.admissible[4]);
}

TEST(ScoreEvidence, LikelihoodsHaveTheMeanOne) {
  ScoreEvidence evidence(3);
  const std::vector<float> scores = {1, none, 5, 0, 2};
  for (int i = 0; i < 3; ++i) {
    const std::vector<float> values = evidence.likelihoods(evidence.read(scores));
    EXPECT_NEAR(std::accumulate(values.begin(), values.end(), 0.0), 4, 1e-5);
    EXPECT_EQ(values[1], 0);
  }
}

TEST(ScoreEvidence, ACandidateThatAlwaysScoresSaysLittle) {
  ScoreEvidence evidence(3);
  std::vector<float> scores(50, 0.0F);
  scores[7] = 6;
  const float first = evidence.likelihoods(evidence.read(scores))[7];
  float last = 0;
  for (int i = 0; i < 50; ++i) last = evidence.likelihoods(evidence.read(scores))[7];
  EXPECT_LT(last, first / 5);
}

TEST(ScoreEvidence, NothingAdmissible) {
  const std::vector<float> scores = {none, none};
  EXPECT_EQ(ScoreEvidence(3).read(scores).count, 0);
  EXPECT_EQ(ScoreEvidence(3).read({}).count, 0);
}

}  // namespace
}  // namespace sailmap
