// What `sailmap eval --json` writes, as `tune` and `report` read it back.
#include "app/evaluation_file.hpp"
#include "foreign_file.hpp"
#include "report/evaluation_file.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace sailmap;
  static fuzz::ForeignFile file(".json");
  const std::filesystem::path& path = file.hold(data, size);
  const auto read = fuzz::read_foreign(path, [&] { return app::read_evaluation(path); });
  if (read) {
    fuzz::demand(read->evaluation.queries_with_match > 0 &&
                     read->evaluation.queries_with_match <= read->evaluation.queries,
                 "queries are counted");
    for (const CurvePoint& point : read->evaluation.curve) {
      fuzz::demand(point.precision >= 0 && point.precision <= 1 && point.recall >= 0 && point.recall <= 1,
                   "precision and recall are within 0 and 1");
    }
  }
  fuzz::read_foreign(path, [&] { return report::read_evaluation_file(path), true; });
  return 0;
}
