// Saliency maps of opencv_contrib, from the same images.
#include <benchmark/benchmark.h>

#include <opencv2/saliency.hpp>
#include <string>

#include "bench_image.hpp"

namespace sailmap::bench {
namespace {

void run_saliency(benchmark::State& state, const cv::Ptr<cv::saliency::StaticSaliency>& saliency, Size size) {
  const cv::Mat image = image_of_size(size.width, size.height);
  cv::setNumThreads(1);
  cv::Mat map;
  for (auto _ : state) {
    if (!saliency->computeSaliency(image, map)) state.SkipWithError("no saliency map");
    benchmark::DoNotOptimize(map.data);
  }
}

template <class Algorithm>
void register_saliency(const std::string& name) {
  for (const Size size : {vga, full_hd}) {
    benchmark::RegisterBenchmark(("opencv/" + name + "/" + size_name(size.width, size.height)).c_str(),
                                 [size](benchmark::State& s) { run_saliency(s, Algorithm::create(), size); })
        ->Unit(benchmark::kMillisecond);
  }
}

const bool registered = [] {
  register_saliency<cv::saliency::StaticSaliencySpectralResidual>("spectral_residual");
  register_saliency<cv::saliency::StaticSaliencyFineGrained>("fine_grained");
  return true;
}();

}  // namespace
}  // namespace sailmap::bench
