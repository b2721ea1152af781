// A card through XRT's native C++ API.
#include <experimental/xrt_ini.h>
#include <experimental/xrt_xclbin.h>
#include <xrt/xrt_bo.h>
#include <xrt/xrt_device.h>
#include <xrt/xrt_kernel.h>

#include <algorithm>
#include <cstdlib>
#include <exception>
#include <utility>
#include <vector>

#include "device.hpp"
#include "xclbin_file.hpp"

namespace sailmap {

bool has_xrt() { return true; }

namespace fpga {
namespace {

// Whole pages, one at least: XRT asks aligned_alloc for the host's side, which is for multiples of the
// alignment.
constexpr std::size_t page = 4096;
constexpr std::size_t in_pages(std::size_t bytes) {
  return std::max<std::size_t>(1, (bytes + page - 1) / page) * page;
}

// Runs `work`; what XRT throws becomes a DeviceError that says what was being done.
template <class Work>
auto with_xrt(const std::string& doing, Work work) {
  try {
    return work();
  } catch (const DeviceError&) {
    throw;
  } catch (const std::exception& fault) {
    throw DeviceError(doing + ": " + fault.what());
  }
}

// XRT would print its own lines besides our one. Those who set up its log keep it.
void silence_log() {
  if (std::getenv("XRT_INI_PATH") != nullptr) return;
  try {
    ::xrt::ini::set("Runtime.runtime_log", "null");
  } catch (const std::exception&) {
    // Someone has used XRT before: its log is as they set it.
    return;
  }
}

const char* name_of(ert_cmd_state state) {
  switch (state) {
    case ERT_CMD_STATE_ERROR:
      return "error";
    case ERT_CMD_STATE_ABORT:
      return "aborted";
    case ERT_CMD_STATE_TIMEOUT:
      return "timeout";
    case ERT_CMD_STATE_NORESPONSE:
      return "no response";
    default:
      return "not completed";
  }
}

class NativeSlot : public Slot {
 public:
  NativeSlot(const ::xrt::device& device, const ::xrt::kernel& kernel, const KernelInterface& interface,
             const BufferSizes& sizes)
      : interface_(interface), run_(kernel) {
    int argument = 0;
    for (const Buffer buffer : interface.buffers) {
      const std::size_t i = index_of(buffer);
      buffers_[i] =
          ::xrt::bo(device, in_pages(sizes[i]), static_cast<::xrt::memory_group>(kernel.group_id(argument)));
      mapped_[i] = {buffers_[i].map<std::byte*>(), buffers_[i].size()};
      run_.set_arg(argument++, buffers_[i]);
    }
  }

  [[nodiscard]] std::span<std::byte> memory(Buffer buffer) override { return mapped_[index_of(buffer)]; }

  void start(const Call& call) override {
    with_xrt("starting the kernel", [&] {
      used_ = buffer_sizes(interface_, call.width, call.height);
      sync(Buffer::pixels, XCL_BO_SYNC_BO_TO_DEVICE);
      sync(Buffer::report, XCL_BO_SYNC_BO_TO_DEVICE);
      const auto scalars = scalars_of(call);
      auto argument = static_cast<int>(interface_.buffers.size());
      for (std::size_t i = 0; i < interface_.scalars; ++i) run_.set_arg(argument++, scalars[i]);
      run_.start();
    });
  }

  // XRT's own timeout starts again when another run ends meanwhile, so it may be late by the frames before.
  [[nodiscard]] Outcome wait(std::chrono::milliseconds timeout) override {
    return with_xrt("waiting for the kernel", [&] {
      const ert_cmd_state state = run_.wait(timeout);
      // Not aborted: that waits for the kernel, which may hang for good.
      if (state == ERT_CMD_STATE_TIMEOUT) return Outcome::timeout;
      if (state != ERT_CMD_STATE_COMPLETED) {
        throw DeviceError(std::string("the kernel ended with: ") + name_of(state));
      }
      // Pixels, the first of them, only go there.
      for (const Buffer buffer : interface_.buffers.subspan(1)) sync(buffer, XCL_BO_SYNC_BO_FROM_DEVICE);
      return Outcome::done;
    });
  }

 private:
  void sync(Buffer buffer, xclBOSyncDirection direction) {
    const std::size_t bytes = used_[index_of(buffer)];
    if (bytes > 0) buffers_[index_of(buffer)].sync(direction, bytes, 0);
  }

  KernelInterface interface_;
  ::xrt::run run_;
  std::array<::xrt::bo, buffer_count> buffers_;
  std::array<std::span<std::byte>, buffer_count> mapped_;
  BufferSizes used_{};
};

// A kernel of the card.
struct NativeKernel {
  KernelInterface interface;
  ::xrt::kernel kernel;
};

class NativeDevice : public Device {
 public:
  NativeDevice(std::string name, ::xrt::device device, std::vector<NativeKernel> kernels)
      : name_(std::move(name)), device_(std::move(device)), kernels_(std::move(kernels)) {}

  [[nodiscard]] std::string name() const override { return name_; }
  [[nodiscard]] std::vector<KernelInterface> kernels() const override {
    std::vector<KernelInterface> interfaces;
    for (const NativeKernel& kernel : kernels_) interfaces.push_back(kernel.interface);
    return interfaces;
  }
  [[nodiscard]] std::unique_ptr<Slot> make_slot(const KernelInterface& kernel,
                                                const BufferSizes& sizes) override {
    const auto found = std::ranges::find(kernels_, kernel, &NativeKernel::interface);
    return with_xrt("making buffers", [&] {
      return std::make_unique<NativeSlot>(device_, found->kernel, found->interface, sizes);
    });
  }

 private:
  std::string name_;
  ::xrt::device device_;
  std::vector<NativeKernel> kernels_;
};

// The known kernels of a file; throws DeviceError when there is none, or one has other arguments.
std::vector<KernelInterface> kernels_of(const ::xrt::xclbin& file, const std::string& path) {
  std::vector<KernelInterface> found;
  const auto kernels = file.get_kernels();
  for (const KernelInterface& known : known_kernels) {
    const auto kernel = std::ranges::find_if(
        kernels, [&](const auto& candidate) { return candidate.get_name() == known.name; });
    if (kernel == kernels.end()) continue;
    const bool equal = std::ranges::equal(
        kernel->get_args(), argument_names(known),
        [](const auto& argument, const std::string& name) { return argument.get_name() == name; });
    if (!equal) throw DeviceError(path + ": its kernel " + known.name + " has other arguments");
    found.push_back(known);
  }
  if (found.empty()) {
    throw DeviceError(path + ": has no kernel " SAILMAP_MEMORY_KERNEL " or " SAILMAP_SIGNATURE_KERNEL);
  }
  return found;
}

}  // namespace

std::unique_ptr<Device> open_native_device(const std::string& xclbin, unsigned index) {
  check_xclbin(xclbin);
  silence_log();
  const ::xrt::xclbin file = with_xrt(xclbin, [&] { return ::xrt::xclbin(xclbin); });
  const auto interfaces = with_xrt(xclbin, [&] { return kernels_of(file, xclbin); });
  const std::string name = "device " + std::to_string(index);
  auto device = with_xrt(name + " cannot be opened", [&] { return ::xrt::device(index); });
  return with_xrt(name + " does not take " + xclbin, [&] {
    const ::xrt::uuid uuid = device.load_xclbin(file);
    std::vector<NativeKernel> kernels;
    kernels.reserve(interfaces.size());
    for (const KernelInterface& interface : interfaces) {
      kernels.push_back({interface, ::xrt::kernel(device, uuid, interface.name)});
    }
    return std::make_unique<NativeDevice>(name, device, std::move(kernels));
  });
}

}  // namespace fpga
}  // namespace sailmap
