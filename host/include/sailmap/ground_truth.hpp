// Which images show the same place: readers for what data sets offer.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace sailmap {

// matches[q]: candidates that show the same place as query q, rising, 0-based.
struct GroundTruth {
  std::vector<std::vector<int>> matches;
};

enum class Side { left, right };

// Text, one line per query: `query: candidate candidate ...`. Lines may be missing (no matches) and come in
// any order; blank lines and lines that begin with # are skipped. Throws Error naming file, line and fault
// for anything else, for an index outside 0..queries-1 or 0..candidates-1, and for a query named twice.
GroundTruth read_text_ground_truth(const std::filesystem::path& path, int queries, int candidates);

// MATLAB .mat: the one two-dimensional numeric or logical matrix of the file (FAB-MAP's loop matrices), dense
// or sparse, in the format of MATLAB 5 to 7.2; non-zero at (query, candidate) means the same place. Text
// beside it does no harm. Throws Error when there is no matrix, or several, when it is not queries x
// candidates or holds NaN, and when the file is cut short, damaged, or holds cells, structures or objects.
GroundTruth read_mat_ground_truth(const std::filesystem::path& path, int queries, int candidates);

// Position of each image, metres in a local plane (or the data set's own unit).
struct Pose {
  double x = 0;
  double y = 0;
};

// KITTI (12 numbers a line: x and z of the translation are the ground plane), TUM (`time x y z qx qy qz qw`:
// x, y), or CSV with a header that names x,y or lat,lon (WGS84 degrees, projected to metres with
// GeographicLib); told apart by content. Throws Error naming file, line and fault.
std::vector<Pose> read_poses(const std::filesystem::path& path);

// Images within `radius` of each other show the same place. `candidates` may be the same as `queries`; then
// an image does not match itself.
GroundTruth ground_truth_from_poses(const std::vector<Pose>& queries, const std::vector<Pose>& candidates,
                                    double radius, bool same_sequence);

struct GroundTruthOptions {
  int queries = 0;  // images of the query sequence after `--side` was applied
  int candidates = 0;
  bool same_sequence = true;  // false: two traverses
  double radius = 0;          // for poses; must be > 0 there
  // FAB-MAP's Oxford data sets: the images of both cameras interleave (left first); the matrix is either over
  // all images or over pairs.
  bool oxford = false;
  Side side = Side::left;
};

// Chooses the reader by extension (.mat) and content (text or poses) and applies the options.
GroundTruth read_ground_truth(const std::filesystem::path& path, const GroundTruthOptions& options);

// Of two traverses given as poses: one file each.
GroundTruth read_ground_truth(const std::filesystem::path& query_poses,
                              const std::filesystem::path& candidate_poses,
                              const GroundTruthOptions& options);

// True when the file holds poses rather than matches, by its content.
bool holds_poses(const std::filesystem::path& path);

}  // namespace sailmap
