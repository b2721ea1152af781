#include "sailmap/ground_truth.hpp"

#include <algorithm>
#include <string>

#include "ground_truth_readers.hpp"
#include "poses.hpp"
#include "sailmap/error.hpp"
#include "text_lines.hpp"

namespace sailmap {

namespace {

namespace fs = std::filesystem;

bool is_mat(const fs::path& path) { return path.extension() == ".mat"; }

GroundTruth read_matches(const fs::path& path, int queries, int candidates) {
  return is_mat(path) ? read_mat_ground_truth(path, queries, candidates)
                      : read_text_ground_truth(path, queries, candidates);
}

// Of the images of both cameras, left first, those of one: image k of the side is image 2k or 2k + 1.
template <class T>
std::vector<T> every_second(const std::vector<T>& both, Side side) {
  std::vector<T> one;
  for (std::size_t i = side == Side::left ? 0 : 1; i < both.size(); i += 2) one.push_back(both[i]);
  return one;
}

GroundTruth of_side(const GroundTruth& both, Side side) {
  const int parity = side == Side::left ? 0 : 1;
  GroundTruth one{.matches = every_second(both.matches, side)};
  for (std::vector<int>& matches : one.matches) {
    std::erase_if(matches, [parity](int candidate) { return candidate % 2 != parity; });
    for (int& candidate : matches) candidate /= 2;
  }
  return one;
}

// A matrix over pairs fits as it is; whatever is larger must be over the images of both cameras.
GroundTruth read_oxford_matches(const fs::path& path, const GroundTruthOptions& options) {
  const io::Extent extent = is_mat(path) ? io::mat_extent(path) : io::text_extent(path);
  if (extent.queries <= options.queries && extent.candidates <= options.candidates) {
    return read_matches(path, options.queries, options.candidates);
  }
  return of_side(read_matches(path, 2 * options.queries, 2 * options.candidates), options.side);
}

void drop_diagonal(GroundTruth& truth) {
  for (std::size_t query = 0; query < truth.matches.size(); ++query) {
    std::erase(truth.matches[query], static_cast<int>(query));
  }
}

// One pose an image.
std::vector<Pose> poses_of(const fs::path& path, std::vector<Pose> poses, int images,
                           const GroundTruthOptions& options) {
  const auto count = static_cast<std::size_t>(images);
  if (options.oxford && poses.size() == 2 * count) poses = every_second(poses, options.side);
  if (poses.size() != count) {
    throw Error(path.string() + ": " + std::to_string(poses.size()) + " poses for " + std::to_string(images) +
                " images");
  }
  return poses;
}

}  // namespace

bool holds_poses(const fs::path& path) {
  if (is_mat(path)) return false;
  const auto lines = io::read_lines(path);
  if (lines.empty()) throw Error(path.string() + ": neither matches nor poses in this file");
  const std::string& first = lines.front().text;
  // A colon follows the query; a CSV header may have one in the name of a field.
  return first.find(':') == std::string::npos || first.find(',') != std::string::npos;
}

GroundTruth read_ground_truth(const fs::path& path, const GroundTruthOptions& options) {
  if (holds_poses(path)) {
    if (!options.same_sequence) {
      throw Error(path.string() + ": poses of one traverse; two traverses need a file each");
    }
    const auto poses = poses_of(path, read_poses(path), options.queries, options);
    return ground_truth_from_poses(poses, poses, options.radius, true);
  }
  GroundTruth truth = options.oxford ? read_oxford_matches(path, options)
                                     : read_matches(path, options.queries, options.candidates);
  if (options.same_sequence) drop_diagonal(truth);
  return truth;
}

GroundTruth read_ground_truth(const fs::path& query_poses, const fs::path& candidate_poses,
                              const GroundTruthOptions& options) {
  const io::Track queries = io::read_track(query_poses);
  const io::Track candidates = io::read_track(candidate_poses);
  if (queries.geographic != candidates.geographic) {
    throw Error(query_poses.string() + " and " + candidate_poses.string() +
                ": one has degrees and the other does not");
  }
  const Pose& origin = candidates.poses.front();  // one plane for both traverses
  return ground_truth_from_poses(
      poses_of(query_poses, io::in_plane(queries, origin), options.queries, options),
      poses_of(candidate_poses, io::in_plane(candidates, origin), options.candidates, options),
      options.radius, false);
}

}  // namespace sailmap
