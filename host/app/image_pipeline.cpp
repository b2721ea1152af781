#include "image_pipeline.hpp"

#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_pipeline.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <memory>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <optional>
#include <utility>

#include "describe_image.hpp"
#include "sailmap/error.hpp"
#include "sailmap/xrt.hpp"

namespace sailmap::app {
namespace {

// An image on its way: to be decoded, described, or the fault that came in between.
struct Item {
  PendingFrame frame;
  PipelineImage image;
  std::exception_ptr fault;
};
using Handle = std::shared_ptr<Item>;

// A fault of the source itself is an item too, so that the images before it are used first.
Handle read(ImageSource& source, const ImagePipeline& pipeline) {
  auto item = std::make_shared<Item>();
  try {
    std::optional<PendingFrame> frame = source.next_pending();
    while (frame && !pipeline.wanted(frame->name)) frame = source.next_pending();
    if (!frame) return nullptr;
    item->frame = std::move(*frame);
  } catch (const Error&) {
    item->fault = std::current_exception();
  }
  return item;
}

// A JPEG of the image, not wider than it is itself.
std::vector<unsigned char> thumbnail_of(const cv::Mat& image, int width) {
  const double scale = std::min(1.0, static_cast<double>(width) / image.cols);
  cv::Mat small;
  cv::resize(image, small, {}, scale, scale, cv::INTER_AREA);
  std::vector<unsigned char> jpeg;
  cv::imencode(".jpg", small, jpeg, {cv::IMWRITE_JPEG_QUALITY, 80});
  return jpeg;
}

void describe(Item& item, const ImagePipeline& pipeline) {
  if (item.fault) return;
  // One front end a thread: it keeps its memory from image to image.
  thread_local std::unique_ptr<Frontend> frontend;
  thread_local DescribedImage described;
  try {
    if (!frontend || frontend->name() != pipeline.frontend) frontend = make_frontend(pipeline.frontend);
    describe_into(item.frame.name, item.frame.read(), *frontend, pipeline.regions, described);
    item.image = {item.frame.name, std::move(described.signature), {item.frame.time, {}}};
    if (pipeline.thumbnail_width > 0) {
      item.image.note.thumbnail = thumbnail_of(described.image, pipeline.thumbnail_width);
    }
  } catch (const Error&) {
    item.fault = std::current_exception();
  }
  item.frame.read = nullptr;
}

}  // namespace

void run_pipeline(ImageSource& source, const ImagePipeline& pipeline) {
  std::atomic<bool> over = false;
  // Threads that wait for a device leave their processors idle: so many more of them.
  const int waiting = waiting_threads(pipeline.frontend);
  const int threads = tbb::info::default_concurrency() + waiting;
  std::optional<tbb::global_control> more_threads;
  if (waiting > 0) more_threads.emplace(tbb::global_control::max_allowed_parallelism, threads);
  const auto in_flight = 2 * static_cast<std::size_t>(threads);
  const auto reading =
      tbb::make_filter<void, Handle>(tbb::filter_mode::serial_in_order, [&](tbb::flow_control& flow) {
        Handle item = over || !pipeline.go_on() ? nullptr : read(source, pipeline);
        if (!item) flow.stop();
        return item;
      });
  const auto describing =
      tbb::make_filter<Handle, Handle>(tbb::filter_mode::parallel, [&](const Handle& item) {
        describe(*item, pipeline);
        return item;
      });
  const auto using_up =
      tbb::make_filter<Handle, void>(tbb::filter_mode::serial_in_order, [&](const Handle& item) {
        if (over) return;
        const bool more = item->fault ? pipeline.on_fault(item->fault) : pipeline.use(std::move(item->image));
        if (!more) over = true;
      });
  tbb::task_arena(threads).execute(
      [&] { tbb::parallel_pipeline(in_flight, reading & describing & using_up); });
}

}  // namespace sailmap::app
