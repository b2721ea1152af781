#include "run_source.hpp"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <exception>
#include <utility>

#include "sailmap/error.hpp"
#include "sailmap/frontend.hpp"
#include "sailmap/xrt.hpp"

namespace sailmap::app {
namespace {

// Set by the first signal: the run ends after the image at hand, and the map is complete.
volatile std::sig_atomic_t interrupted = 0;

void on_interrupt(int signal) {
  interrupted = 1;
  std::signal(signal, SIG_DFL);  // a second one ends the program at once
}

// Unreadable images are reported and passed over when the user asked for that.
void skip(const std::exception_ptr& fault, bool skip_bad, Progress& progress) {
  try {
    std::rethrow_exception(fault);
  } catch (const DeviceError&) {
    throw;  // all images would be passed over
  } catch (const Error& error) {
    if (!skip_bad) throw;
    progress.clear();
    spdlog::warn("skipped {}", error.what());
  }
}

}  // namespace

void run_source(ImageSource& source, const SourceRun& run, RunCounts& counts) {
  check_signature(run.frontend, run.regions);
  std::signal(SIGINT, on_interrupt);
  std::signal(SIGTERM, on_interrupt);
  const auto start = std::chrono::steady_clock::now();
  std::optional<int> total = source.size();
  if (run.max_images > 0) total = std::min(total.value_or(run.max_images), run.max_images);
  Progress progress("run", total);
  ImagePipeline pipeline;
  pipeline.frontend = run.frontend;
  pipeline.regions = run.regions;
  pipeline.thumbnail_width = run.thumbnail_width;
  pipeline.wanted = run.wanted;
  pipeline.go_on = [] { return interrupted == 0; };
  pipeline.on_fault = [&](const std::exception_ptr& fault) {
    skip(fault, run.skip_bad, progress);
    ++counts.skipped;
    return true;
  };
  pipeline.use = [&](PipelineImage image) {
    run.use(std::move(image), progress);
    progress.step_to(++counts.images);
    counts.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return run.max_images == 0 || counts.images < run.max_images;
  };
  run_pipeline(source, pipeline);
  const bool ended = interrupted == 0 && (run.max_images == 0 || counts.images < run.max_images);
  if (const auto early = source.early_end(); early && ended) {
    progress.clear();
    spdlog::warn("{}", *early);
  }
}

}  // namespace sailmap::app
