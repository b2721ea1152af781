// MATLAB's .mat as ground truth.
#include "io/ground_truth_readers.hpp"
#include "matches.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace sailmap;
  // A user has as many images as the matrix says: no more than so many here.
  constexpr int most_images = 4096;
  static fuzz::ForeignFile file(".mat");
  const std::filesystem::path& path = file.hold(data, size);
  const auto extent = fuzz::read_foreign(path, [&] { return io::mat_extent(path); });
  if (!extent) return 0;
  fuzz::demand(extent->queries >= 0 && extent->candidates >= 0, "sizes are not negative");
  const int queries = std::min(extent->queries, most_images);
  const int candidates = std::min(extent->candidates, most_images);
  const auto truth =
      fuzz::read_foreign(path, [&] { return read_mat_ground_truth(path, queries, candidates); });
  if (truth) fuzz::check_matches(*truth, queries, candidates, false);
  const GroundTruthOptions pairs{
      .queries = queries / 2, .candidates = candidates / 2, .same_sequence = false, .oxford = true};
  const auto left = fuzz::read_foreign(path, [&] { return read_ground_truth(path, pairs); });
  if (left) fuzz::check_matches(*left, pairs.queries, pairs.candidates, false);
  return 0;
}
