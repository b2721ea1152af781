// Spec section 12: precision and recall from scores and ground truth.
#include "sailmap/evaluation.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "sailmap/error.hpp"

namespace sailmap {
namespace {

// What counts of one query.
struct Query {
  float best = 0;      // score of its best candidate
  bool right = false;  // that candidate is a true match
  bool has_match = false;
  int rank = 0;  // of the best true match, from 1; 0 when it has none
};

bool is_match(const std::vector<int>& matches, int candidate) {
  return std::binary_search(matches.begin(), matches.end(), candidate);
}

// Nothing when the query has no admissible candidate. Ties go to the first candidate.
bool summarise(const Plane<float>& scores, int q, const std::vector<int>& matches, Query& out) {
  int best = -1;
  int best_match = -1;
  for (int c = 0; c < scores.width(); ++c) {
    const float score = scores(c, q);
    if (std::isnan(score)) continue;
    if (best < 0 || score > scores(best, q)) best = c;
    if (is_match(matches, c) && (best_match < 0 || score > scores(best_match, q))) best_match = c;
  }
  if (best < 0) return false;
  out.best = scores(best, q);
  out.right = is_match(matches, best);
  out.has_match = best_match >= 0;
  if (!out.has_match) return true;
  out.rank = 1;
  for (int c = 0; c < scores.width(); ++c) {
    const float score = scores(c, q);
    const float against = scores(best_match, q);
    if (score > against || (score == against && c < best_match)) ++out.rank;
  }
  return true;
}

double part(int some, int all) { return all > 0 ? static_cast<double>(some) / all : 0; }

// Sweeps the threshold down over the queries, which are sorted by falling score; queries of equal score enter
// together.
std::vector<CurvePoint> sweep(const std::vector<Query>& queries, int with_match) {
  std::vector<CurvePoint> curve;
  int right = 0;
  for (std::size_t i = 0; i < queries.size(); ++i) {
    right += queries[i].right ? 1 : 0;
    if (i + 1 < queries.size() && queries[i + 1].best == queries[i].best) continue;
    curve.push_back({queries[i].best, part(right, static_cast<int>(i) + 1), part(right, with_match)});
  }
  return curve;
}

void summarise_curve(Evaluation& out) {
  double recall = 0;
  for (const CurvePoint& point : out.curve) {
    out.average_precision += (point.recall - recall) * point.precision;
    recall = point.recall;
    if (point.precision >= 1) out.recall_at_100 = std::max(out.recall_at_100, point.recall);
    if (point.precision >= 0.95) out.recall_at_95 = std::max(out.recall_at_95, point.recall);
    const double sum = point.precision + point.recall;
    const double f1 = sum > 0 ? 2 * point.precision * point.recall / sum : 0;
    if (f1 > out.best_f1) {
      out.best_f1 = f1;
      out.best_f1_threshold = point.threshold;
    }
  }
}

FixedThreshold at_threshold(const std::vector<Query>& queries, int with_match, double threshold) {
  FixedThreshold out;
  out.threshold = threshold;
  for (const Query& query : queries) {
    if (!(static_cast<double>(query.best) > threshold)) continue;
    ++out.detections;
    out.right += query.right ? 1 : 0;
  }
  out.precision = out.detections > 0 ? part(out.right, out.detections) : 1;
  out.recall = part(out.right, with_match);
  return out;
}

}  // namespace

Evaluation evaluate(const Plane<float>& scores, const GroundTruth& truth, double threshold) {
  if (static_cast<int>(truth.matches.size()) != scores.height()) {
    throw Error("ground truth is for " + std::to_string(truth.matches.size()) + " queries, but there are " +
                std::to_string(scores.height()));
  }
  std::vector<Query> queries;
  for (int q = 0; q < scores.height(); ++q) {
    Query query;
    if (summarise(scores, q, truth.matches[static_cast<std::size_t>(q)], query)) queries.push_back(query);
  }
  Evaluation out;
  out.queries = static_cast<int>(queries.size());
  std::array<int, 3> found{};
  for (const Query& query : queries) {
    if (!query.has_match) continue;
    ++out.queries_with_match;
    for (std::size_t k = 0; k < found.size(); ++k) found[k] += query.rank <= recall_ranks[k] ? 1 : 0;
  }
  if (out.queries_with_match == 0) {
    throw Error(
        "no query has an admissible true match: nothing can be recalled (is exclude_recent too large?)");
  }
  for (std::size_t k = 0; k < found.size(); ++k) out.recall_at[k] = part(found[k], out.queries_with_match);
  std::stable_sort(queries.begin(), queries.end(),
                   [](const Query& a, const Query& b) { return a.best > b.best; });
  out.curve = sweep(queries, out.queries_with_match);
  summarise_curve(out);
  out.fixed = at_threshold(queries, out.queries_with_match, threshold);
  return out;
}

}  // namespace sailmap
