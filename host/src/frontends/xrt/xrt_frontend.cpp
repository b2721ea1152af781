#include "xrt_frontend.hpp"

#include <algorithm>
#include <cstdlib>
#include <mutex>
#include <set>
#include <utility>

#include "frontends/frontends.hpp"
#include "frontends/signature_record.hpp"
#include "shared_device.hpp"
#include "simulated_device.hpp"

namespace sailmap {
namespace fpga {

class XrtService {
 public:
  XrtService(const XrtSettings& settings, const Opener& open) : settings_(settings) {
    try {
      device_ = std::make_unique<SharedDevice>(open(), settings.timeout, settings.frames_in_flight);
    } catch (const DeviceError& fault) {
      fall_back(fault, Cause::device);
    }
  }

  // False when the fallback is to compute the image instead.
  bool compute(const ImageView& image, Maps& maps) {
    return with_device([&] { device_->compute(image, maps); },
                       device_ && !device_->has(maps_kernel) ? Cause::no_maps : Cause::device);
  }

  // Whether signatures come from a kernel of the device rather than of its maps.
  [[nodiscard]] bool makes_signatures() const { return device_ && device_->has(signature_kernel); }
  // The same for one of them.
  bool describe(const ImageView& image, const ChipParameters& asked, Signature& signature) {
    return with_device([&] { device_->describe(image, asked, signature); }, Cause::device);
  }

  [[nodiscard]] const std::string& fallback() const { return settings_.fallback; }

 private:
  // Why the fallback takes over: each is another thing to tell.
  enum class Cause { device, image_size, no_maps };

  // Whether the device did the work; a fault of it has that cause.
  template <class Work>
  bool with_device(Work work, Cause cause) {
    if (!device_) return false;
    try {
      work();
      return true;
    } catch (const DeviceError& fault) {
      fall_back(fault, cause);
    } catch (const Error& fault) {
      fall_back(fault, Cause::image_size);
    }
    return false;
  }

  // Throws the fault where nothing is to take over; tells of the first one of its cause otherwise.
  template <class Fault>
  void fall_back(const Fault& fault, Cause cause) {
    if (settings_.fallback.empty()) throw fault;
    const std::lock_guard lock(mutex_);
    if (told_.insert(cause).second && settings_.warn) {
      settings_.warn(std::string("xrt: ") + fault.what() + "; the front end " + settings_.fallback +
                     " takes over, which computes the same");
    }
  }

  XrtSettings settings_;
  std::unique_ptr<SharedDevice> device_;
  std::mutex mutex_;
  std::set<Cause> told_;
};

namespace {

class Xrt : public Frontend {
 public:
  explicit Xrt(std::shared_ptr<XrtService> service) : service_(std::move(service)) {}

  [[nodiscard]] std::string_view name() const override { return "xrt"; }

  void compute(const ImageView& image, Maps& maps) override {
    check_image_size(image);
    if (!service_->compute(image, maps)) fallback().compute(image, maps);
  }

  // A signature of the card's own comes without maps.
  void describe(const ImageView& image, const RegionConfig& regions, Maps& maps,
                Signature& signature) override {
    if (regions.signature == SignatureMaker::host || !service_->makes_signatures()) {
      Frontend::describe(image, regions, maps, signature);
      return;
    }
    check_image_size(image);
    if (service_->describe(image, chip_parameters(regions), signature)) {
      maps = Maps();
    } else {
      fallback().describe(image, regions, maps, signature);
    }
  }

 private:
  Frontend& fallback() {
    if (!fallback_) fallback_ = make_frontend(service_->fallback());
    return *fallback_;
  }

  std::shared_ptr<XrtService> service_;
  std::unique_ptr<Frontend> fallback_;
};

// Settings, and the device while any front end uses it.
struct Process {
  std::mutex mutex;
  XrtSettings settings;
  std::weak_ptr<XrtService> service;
};
Process& process() {
  static Process process;
  return process;
}

// For tests: stands in for card and xclbin (docs/fpga.md).
constexpr const char* simulation_variable = "SAILMAP_SIMULATED_DEVICE";

std::unique_ptr<Device> open_device(const XrtSettings& settings) {
  const char* simulation = std::getenv(simulation_variable);
  if (simulation != nullptr) return open_simulated_device(simulation_from_text(simulation));
  return open_native_device(settings.xclbin, settings.device);
}

}  // namespace

std::shared_ptr<XrtService> make_service(const XrtSettings& settings, const Opener& open) {
  return std::make_shared<XrtService>(settings, open);
}

std::unique_ptr<Frontend> make_frontend_on(std::shared_ptr<XrtService> service) {
  return std::make_unique<Xrt>(std::move(service));
}

}  // namespace fpga

void set_xrt(const XrtSettings& settings) {
  const auto demand = [](bool holds, const char* fault) {
    if (!holds) throw Error(std::string("xrt: ") + fault);
  };
  demand(!settings.xclbin.empty(), "no xclbin is named");
  demand(settings.timeout.count() > 0, "the timeout must be above 0 ms");
  demand(settings.frames_in_flight >= 2 && settings.frames_in_flight <= 64,
         "2 to 64 frames may be in flight");
  demand(settings.fallback.empty() || settings.fallback == "fixed", "the fallback is 'fixed' or nothing");
  auto& process = fpga::process();
  const std::lock_guard lock(process.mutex);
  process.settings = settings;
  process.service.reset();
}

int waiting_threads(std::string_view frontend) {
  if (frontend != "xrt") return 0;
  auto& process = fpga::process();
  const std::lock_guard lock(process.mutex);
  return process.settings.frames_in_flight;
}

std::unique_ptr<Frontend> make_xrt() {
  auto& process = fpga::process();
  const std::lock_guard lock(process.mutex);
  std::shared_ptr<fpga::XrtService> service = process.service.lock();
  if (!service) {
    if (process.settings.xclbin.empty()) {
      throw Error("the front end xrt needs the xclbin of a kernel (--xclbin FILE)");
    }
    service = fpga::make_service(process.settings, [&] { return fpga::open_device(process.settings); });
    process.service = service;
  }
  return fpga::make_frontend_on(std::move(service));
}

}  // namespace sailmap
