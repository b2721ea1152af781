// From image to maps per front end and size, from image to regions, and OpenCV's extraction of features.
#include <benchmark/benchmark.h>

#include <opencv2/features2d.hpp>
#include <opencv2/imgproc.hpp>
#include <string>

#include "bench_image.hpp"
#include "sailmap/frontend.hpp"
#include "sailmap/signature.hpp"

namespace sailmap::bench {
namespace {

// Also: how many regions or features an image has, so that times can be compared for what they are.
void run_frontend(benchmark::State& state, const std::string& name, Size size, bool with_regions) {
  const cv::Mat image = image_of_size(size.width, size.height);
  const auto frontend = make_frontend(name);
  Maps maps;
  std::size_t regions = 0;
  for (auto _ : state) {
    frontend->compute(view_of(image), maps);
    if (with_regions) regions = make_signature(maps, {}).regions.size();
    benchmark::DoNotOptimize(maps.saliency.samples);
  }
  if (with_regions) state.counters["regions"] = static_cast<double>(regions);
  state.counters["pixels_per_second"] = benchmark::Counter(
      static_cast<double>(size.width) * size.height * static_cast<double>(state.iterations()),
      benchmark::Counter::kIsRate);
}

void run_signature(benchmark::State& state, Size size) {
  const cv::Mat image = image_of_size(size.width, size.height);
  Maps maps;
  make_frontend("fixed")->compute(view_of(image), maps);
  for (auto _ : state) benchmark::DoNotOptimize(make_signature(maps, {}));
}

// With the grey conversion, as we start from colour too.
void run_features(benchmark::State& state, const cv::Ptr<cv::Feature2D>& features, Size size) {
  const cv::Mat image = image_of_size(size.width, size.height);
  cv::setNumThreads(1);
  cv::Mat grey;
  std::vector<cv::KeyPoint> points;
  cv::Mat descriptors;
  for (auto _ : state) {
    cv::cvtColor(image, grey, cv::COLOR_BGR2GRAY);
    features->detectAndCompute(grey, cv::noArray(), points, descriptors);
    benchmark::DoNotOptimize(descriptors.data);
  }
  state.counters["features"] = static_cast<double>(points.size());
}

template <class Run>
void register_run(const std::string& name, const Run& run) {
  benchmark::RegisterBenchmark(name.c_str(), run)->Unit(benchmark::kMillisecond);
}

const bool registered = [] {
  for (const Size size : {vga, full_hd}) {
    const std::string suffix = std::string("/").append(size_name(size.width, size.height));
    for (const char* name : {"fixed", "quantised", "reference"}) {
      register_run(std::string("frontend/").append(name) + suffix,
                   [=](benchmark::State& s) { run_frontend(s, name, size, false); });
    }
    register_run("regions" + suffix, [=](benchmark::State& s) { run_frontend(s, "fixed", size, true); });
    register_run("stage/signature" + suffix, [=](benchmark::State& s) { run_signature(s, size); });
    register_run("opencv/orb" + suffix,
                 [=](benchmark::State& s) { run_features(s, cv::ORB::create(), size); });
    register_run("opencv/sift" + suffix,
                 [=](benchmark::State& s) { run_features(s, cv::SIFT::create(), size); });
  }
  return true;
}();

}  // namespace
}  // namespace sailmap::bench
