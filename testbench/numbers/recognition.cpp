#include "recognition.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <opencv2/imgcodecs.hpp>
#include <vector>

#include "sailmap/error.hpp"
#include "sailmap/evaluation.hpp"
#include "sailmap/frontend.hpp"
#include "sailmap/ground_truth.hpp"
#include "sailmap/signature.hpp"

namespace sailmap::numbers {
namespace {

Signature signature_of(const std::filesystem::path& path, const std::string& frontend) {
  const cv::Mat image = cv::imread(path.string(), cv::IMREAD_COLOR);
  if (image.empty()) throw Error(path.string() + ": no image");
  Maps maps;
  make_frontend(frontend)->compute(
      {image.cols, image.rows, image.data, static_cast<std::ptrdiff_t>(image.step[0])}, maps);
  return make_signature(maps, {});
}

std::vector<Signature> signatures(const std::filesystem::path& folder, const std::string& frontend) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) files.push_back(entry.path());
  std::ranges::sort(files);
  std::vector<Signature> out(files.size());
  tbb::parallel_for(std::size_t{0}, out.size(),
                    [&](std::size_t i) { out[i] = signature_of(files[i], frontend); });
  return out;
}

}  // namespace

Recognition recognise(const std::filesystem::path& folder, int exclude_recent, const std::string& frontend) {
  const std::vector<Signature> images = signatures(folder / "images", frontend);
  GroundTruthOptions options;
  options.queries = static_cast<int>(images.size());
  options.candidates = options.queries;
  const GroundTruth truth = read_ground_truth(folder / "ground_truth.txt", options);
  const auto average_precision = [&](Method method) {
    MatchConfig config;
    config.method = method;
    return evaluate(score_sequence(images, exclude_recent, config), truth, 0).average_precision;
  };
  return {average_precision(Method::paper), average_precision(Method::paper_weighted)};
}

}  // namespace sailmap::numbers
