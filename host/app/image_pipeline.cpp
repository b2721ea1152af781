#include "image_pipeline.hpp"

#include <tbb/info.h>
#include <tbb/parallel_pipeline.h>

#include <atomic>
#include <memory>
#include <optional>
#include <utility>

#include "describe_image.hpp"
#include "sailmap/error.hpp"

namespace sailmap::app {
namespace {

// An image on its way: to be decoded, described, or the fault that came in between.
struct Item {
  PendingFrame frame;
  Signature signature;
  std::exception_ptr fault;
};
using Handle = std::shared_ptr<Item>;

// A fault of the source itself is an item too, so that the images before it are used first.
Handle read(ImageSource& source) {
  auto item = std::make_shared<Item>();
  try {
    std::optional<PendingFrame> frame = source.next_pending();
    if (!frame) return nullptr;
    item->frame = std::move(*frame);
  } catch (const Error&) {
    item->fault = std::current_exception();
  }
  return item;
}

void describe(Item& item, const ImagePipeline& pipeline) {
  if (item.fault) return;
  // One front end a thread: it keeps its memory from image to image.
  thread_local std::unique_ptr<Frontend> frontend;
  thread_local DescribedImage described;
  try {
    if (!frontend || frontend->name() != pipeline.frontend) frontend = make_frontend(pipeline.frontend);
    describe_into(item.frame.name, item.frame.read(), *frontend, pipeline.regions, described);
    item.signature = std::move(described.signature);
  } catch (const Error&) {
    item.fault = std::current_exception();
  }
  item.frame.read = nullptr;
}

}  // namespace

void run_pipeline(ImageSource& source, const ImagePipeline& pipeline) {
  std::atomic<bool> over = false;
  const auto in_flight = 2 * static_cast<std::size_t>(tbb::info::default_concurrency());
  const auto reading =
      tbb::make_filter<void, Handle>(tbb::filter_mode::serial_in_order, [&](tbb::flow_control& flow) {
        Handle item = over || !pipeline.go_on() ? nullptr : read(source);
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
        const bool more = item->fault ? pipeline.on_fault(item->fault)
                                      : pipeline.use(std::move(item->frame.name), std::move(item->signature));
        if (!more) over = true;
      });
  tbb::parallel_pipeline(in_flight, reading & describing & using_up);
}

}  // namespace sailmap::app
