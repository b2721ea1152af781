#include "recognition.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <opencv2/imgcodecs.hpp>
#include <vector>

#include "sailmap/error.hpp"
#include "sailmap/evaluation.hpp"
#include "sailmap/frontend.hpp"
#include "sailmap/ground_truth.hpp"
#include "sailmap/signature.hpp"

namespace sailmap::numbers {
namespace {

Signature signature_of(const std::filesystem::path& path, const std::string& frontend, SignatureMaker maker) {
  const cv::Mat image = cv::imread(path.string(), cv::IMREAD_COLOR);
  if (image.empty()) throw Error(path.string() + ": no image");
  Maps maps;
  Signature signature;
  RegionConfig regions;
  regions.signature = maker;
  make_frontend(frontend)->describe(
      {image.cols, image.rows, image.data, static_cast<std::ptrdiff_t>(image.step[0])}, regions, maps,
      signature);
  return signature;
}

std::vector<Signature> signatures(const std::filesystem::path& folder, const std::string& frontend,
                                  SignatureMaker maker) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) files.push_back(entry.path());
  std::ranges::sort(files);
  std::vector<Signature> out(files.size());
  tbb::parallel_for(std::size_t{0}, out.size(),
                    [&](std::size_t i) { out[i] = signature_of(files[i], frontend, maker); });
  return out;
}

}  // namespace

Recognition recognise(const std::filesystem::path& folder, int exclude_recent, const std::string& frontend,
                      SignatureMaker signature) {
  const std::vector<Signature> images = signatures(folder / "images", frontend, signature);
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

SignatureDifference compare_signatures(const std::filesystem::path& folder) {
  const std::vector<Signature> host = signatures(folder, "fixed", SignatureMaker::host);
  const std::vector<Signature> chip = signatures(folder, "fixed", SignatureMaker::chip);
  SignatureDifference out;
  for (std::size_t image = 0; image < host.size(); ++image) {
    const std::vector<Region>& a = host[image].regions;
    const std::vector<Region>& b = chip[image].regions;
    out.regions += static_cast<int>(a.size());
    out.other_regions += std::abs(static_cast<int>(a.size()) - static_cast<int>(b.size()));
    for (std::size_t r = 0; r < std::min(a.size(), b.size()); ++r) {
      const bool same = a[r].x == b[r].x && a[r].y == b[r].y && a[r].saliency == b[r].saliency;
      out.other_regions += same ? 0 : 1;
      for (std::size_t i = 0; i < feature_count; ++i) {
        const double difference = double{a[r].descriptor[i]} - double{b[r].descriptor[i]};
        out.largest_entry = std::max(out.largest_entry, std::abs(difference));
      }
    }
  }
  return out;
}

}  // namespace sailmap::numbers
