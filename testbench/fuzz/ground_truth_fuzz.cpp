// Text ground truth: alone, and where the content decides whether a file holds matches or poses.
#include "io/ground_truth_readers.hpp"
#include "matches.hpp"

namespace {

using namespace sailmap;

constexpr int queries = 6;
constexpr int candidates = 9;

void read_as(const std::filesystem::path& path, const GroundTruthOptions& options) {
  const auto truth = fuzz::read_foreign(path, [&] { return read_ground_truth(path, options); });
  if (truth) fuzz::check_matches(*truth, options.queries, options.candidates, options.same_sequence);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static fuzz::ForeignFile file(".gt");
  const std::filesystem::path& path = file.hold(data, size);
  const auto truth =
      fuzz::read_foreign(path, [&] { return read_text_ground_truth(path, queries, candidates); });
  const auto extent = fuzz::read_foreign(path, [&] { return io::text_extent(path); });
  if (truth) {
    fuzz::check_matches(*truth, queries, candidates, false);
    fuzz::demand(extent && extent->queries <= queries && extent->candidates <= candidates,
                 "the extent is that of the matches");
  }
  read_as(path, {.queries = queries, .candidates = candidates, .same_sequence = false, .radius = 1});
  read_as(path, {.queries = queries, .candidates = queries, .radius = 1});
  for (const Side side : {Side::left, Side::right}) {
    read_as(path, {.queries = 3, .candidates = 3, .radius = 1, .oxford = true, .side = side});
  }
  return 0;
}
