#include "shared_device.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <opencv2/imgproc.hpp>
#include <utility>

#include "frontends/packed_maps.hpp"

namespace sailmap::fpga {
namespace {

// Where slots go that the kernel may still write to: freed, their memory would be someone else's. Never
// destroyed, nor is the device that they belong to.
void bury(std::unique_ptr<Device> device, std::vector<std::unique_ptr<Slot>> slots) {
  if (device->closes_after_fault()) {
    device.reset();  // before the slots that it works on
    return;
  }
  static std::mutex mutex;
  static auto& buried =
      *new std::vector<std::pair<std::unique_ptr<Device>, std::vector<std::unique_ptr<Slot>>>>;
  const std::lock_guard lock(mutex);
  buried.emplace_back(std::move(device), std::move(slots));
}

// As the kernel reads them.
void pack(const ImageView& image, std::span<std::byte> to) {
  // A cv::Mat has no pixels that cannot be written.
  auto* const data = const_cast<std::uint8_t*>(image.data);  // NOLINT(cppcoreguidelines-pro-type-const-cast)
  const cv::Mat from(image.height, image.width, CV_8UC3, data, static_cast<std::size_t>(image.stride));
  cv::Mat pixels(image.height, image.width, CV_8UC4, to.data());
  cv::cvtColor(from, pixels, image.order == ChannelOrder::rgb ? cv::COLOR_RGB2RGBA : cv::COLOR_BGR2RGBA);
}

template <class Word>
std::span<const Word> words_of(Slot& slot, Buffer buffer, const BufferSizes& sizes) {
  return slot.words<Word>(buffer, sizes[index_of(buffer)]);
}

PackedMaps packed_maps(Slot& slot, const Call& call) {
  const BufferSizes sizes = buffer_sizes(maps_kernel, call.width, call.height);
  return {words_of<std::uint32_t>(slot, Buffer::intensity_maps, sizes),
          words_of<std::uint64_t>(slot, Buffer::colour_maps, sizes),
          words_of<std::uint64_t>(slot, Buffer::orientation_maps, sizes),
          words_of<std::uint64_t>(slot, Buffer::conspicuity_maps, sizes),
          words_of<std::uint16_t>(slot, Buffer::saliency, sizes),
          words_of<std::uint32_t>(slot, Buffer::statistics, sizes)};
}

bool possible(const Limits& limits) {
  using hls::geometry::valid_side;
  const std::uint32_t beat = limits.beat;
  return valid_side(static_cast<int>(limits.max_width)) && valid_side(static_cast<int>(limits.max_height)) &&
         (beat == 1 || beat == 2 || beat == 4 || beat == 8) && limits.max_width % beat == 0;
}

std::span<const std::uint32_t> report_of(Slot& slot) {
  return slot.words<std::uint32_t>(Buffer::report, std::size_t{4} * SAILMAP_REPORT_WORDS);
}

// Throws DeviceError when the kernel did not do what the call asked for.
void check_report(const KernelInterface& kernel, Slot& slot, const Call& call) {
  const auto report = report_of(slot);
  const auto demand = [](bool holds, const std::string& fault) {
    if (!holds) throw DeviceError(fault);
  };
  demand(report[SAILMAP_REPORT_VERSION] == kernel.version,
         fmt::format("the kernel reports version 0x{:08x}, this program is for 0x{:08x}",
                     report[SAILMAP_REPORT_VERSION], kernel.version));
  const bool frame = call.width > 0;
  const std::uint32_t status = frame ? SAILMAP_STATUS_DONE : SAILMAP_STATUS_REFUSED;
  demand(report[SAILMAP_REPORT_STATUS] == status,
         fmt::format("the kernel reports status {}, not {}", report[SAILMAP_REPORT_STATUS], status));
  demand(report[SAILMAP_REPORT_FRAME] == call.frame,
         fmt::format("the kernel reports frame {} where frame {} was asked for", report[SAILMAP_REPORT_FRAME],
                     call.frame));
  demand(report[SAILMAP_REPORT_WIDTH] == call.width && report[SAILMAP_REPORT_HEIGHT] == call.height,
         fmt::format("the kernel reports a frame of {}x{} where one of {}x{} was asked for",
                     report[SAILMAP_REPORT_WIDTH], report[SAILMAP_REPORT_HEIGHT], call.width, call.height));
  const std::size_t words =
      buffer_sizes(kernel, call.width, call.height)[index_of(kernel.output)] / kernel.output_bytes;
  demand(report[SAILMAP_REPORT_OUTPUT_WORDS] == words,
         fmt::format("the kernel reports {} of {} words where a frame of {}x{} has {}", kernel.output_name,
                     report[SAILMAP_REPORT_OUTPUT_WORDS], call.width, call.height, words));
}

}  // namespace

bool Limits::take(int width, int height) const {
  using hls::geometry::valid_side;
  return valid_side(width) && valid_side(height) && static_cast<std::uint32_t>(width) <= max_width &&
         static_cast<std::uint32_t>(height) <= max_height && static_cast<std::uint32_t>(width) % beat == 0;
}

SharedDevice::SharedDevice(std::unique_ptr<Device> device, std::chrono::milliseconds timeout,
                           int frames_in_flight)
    : device_(std::move(device)), timeout_(timeout) {
  for (const KernelInterface& interface : device_->kernels()) {
    kernels_.push_back({interface, frames_in_flight});
  }
  for (Kernel& kernel : kernels_) ask_for_report(kernel);
}

SharedDevice::~SharedDevice() {
  if (!abandoned_.empty()) bury(std::move(device_), std::move(abandoned_));
}

void SharedDevice::ask_for_report(Kernel& kernel) {
  const Call call{};
  std::unique_ptr<Slot> slot;
  try {
    slot = device_->make_slot(kernel.interface, buffer_sizes(kernel.interface, 0, 0));
    run(kernel.interface, *slot, call);
    const auto report = report_of(*slot);
    kernel.limits = {report[SAILMAP_REPORT_MAX_WIDTH], report[SAILMAP_REPORT_MAX_HEIGHT],
                     report[SAILMAP_REPORT_BEAT]};
    const Limits& limits = kernel.limits;
    if (!possible(limits)) {
      throw DeviceError(fmt::format("the kernel reports limits that cannot be, {}x{} with {} pixels a beat",
                                    limits.max_width, limits.max_height, limits.beat));
    }
  } catch (const DeviceError& fault) {
    const std::string why = device_->name() + ": " + fault.what();
    std::vector<std::unique_ptr<Slot>> slots;
    slots.push_back(std::move(slot));
    bury(std::move(device_), std::move(slots));
    throw DeviceError(why);
  }
}

bool SharedDevice::has(const KernelInterface& kernel) const {
  return std::ranges::find(kernels_, kernel, &Kernel::interface) != kernels_.end();
}

SharedDevice::Kernel& SharedDevice::demand(const KernelInterface& interface) {
  const auto found = std::ranges::find(kernels_, interface, &Kernel::interface);
  if (found != kernels_.end()) return *found;
  throw DeviceError(fmt::format("{}: it has no kernel {}, which hands out {}, but {}", device_->name(),
                                interface.name, interface.output_name, kernels_.front().interface.name));
}

std::unique_ptr<Slot> SharedDevice::acquire(Kernel& kernel) {
  std::unique_lock lock(mutex_);
  // Ends: every slot in use comes back, or fails, within the timeout.
  changed_.wait(lock, [&] { return !failure_.empty() || !kernel.free.empty() || kernel.to_make > 0; });
  if (!failure_.empty()) throw DeviceError(failure_);
  if (!kernel.free.empty()) {
    std::unique_ptr<Slot> slot = std::move(kernel.free.back());
    kernel.free.pop_back();
    return slot;
  }
  --kernel.to_make;
  lock.unlock();
  return device_->make_slot(
      kernel.interface, buffer_sizes(kernel.interface, kernel.limits.max_width, kernel.limits.max_height));
}

void SharedDevice::release(Kernel& kernel, std::unique_ptr<Slot> slot) {
  const std::lock_guard lock(mutex_);
  kernel.free.push_back(std::move(slot));
  changed_.notify_all();  // one of those who wait may be in want of another kernel
}

void SharedDevice::fail(const std::string& why, std::unique_ptr<Slot> slot) {
  const std::lock_guard lock(mutex_);
  if (failure_.empty()) failure_ = why;
  if (slot) abandoned_.push_back(std::move(slot));
  changed_.notify_all();
}

void SharedDevice::run(const KernelInterface& interface, Slot& slot, const Call& call) const {
  // A kernel that writes nothing must not pass for one that reported.
  const auto report = slot.words<std::uint32_t>(Buffer::report, std::size_t{4} * SAILMAP_REPORT_WORDS);
  std::ranges::fill(report, 0U);
  slot.start(call);
  if (slot.wait(timeout_) == Outcome::timeout) {
    throw DeviceError(fmt::format("the kernel did not finish a frame within {} ms", timeout_.count()));
  }
  check_report(interface, slot, call);
}

template <class Take>
void SharedDevice::work(Kernel& kernel, const ImageView& image, const ChipParameters& asked, Take take) {
  const Limits& limits = kernel.limits;
  if (!limits.take(image.width, image.height)) {
    throw Error(fmt::format(
        "image is {}x{} pixels; the kernel of {} takes up to {}x{}{}", image.width, image.height,
        device_->name(), limits.max_width, limits.max_height,
        limits.beat > 1 ? fmt::format(", widths that are multiples of {}", limits.beat) : std::string()));
  }
  const Call call{static_cast<std::uint32_t>(image.width),
                  static_cast<std::uint32_t>(image.height),
                  next_frame_++,
                  asked.max_regions,
                  asked.stop_ratio,
                  asked.box_side};
  std::unique_ptr<Slot> slot;
  try {
    slot = acquire(kernel);
    pack(image, slot->memory(Buffer::pixels));
    run(kernel.interface, *slot, call);
    take(*slot, call);
  } catch (const Error& fault) {
    fail(fault.what(), std::move(slot));
    device_->quiesce();
    throw DeviceError(device_->name() + ": " + fault.what());
  } catch (...) {
    fail("an earlier frame failed", std::move(slot));
    device_->quiesce();
    throw;
  }
  release(kernel, std::move(slot));
}

void SharedDevice::compute(const ImageView& image, Maps& maps) {
  work(demand(maps_kernel), image, {}, [&](Slot& slot, const Call& call) {
    unpack(packed_maps(slot, call), image.width, image.height, maps);
  });
}

void SharedDevice::describe(const ImageView& image, const ChipParameters& asked, Signature& signature) {
  work(demand(signature_kernel), image, asked, [&](Slot& slot, const Call& /*call*/) {
    const auto record = slot.words<std::uint32_t>(Buffer::record, std::size_t{4} * SAILMAP_RECORD_WORDS);
    signature = signature_of_record(record, image.width, image.height, asked);
  });
}

}  // namespace sailmap::fpga
