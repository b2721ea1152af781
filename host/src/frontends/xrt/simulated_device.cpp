#include "simulated_device.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <optional>
#include <sstream>
#include <thread>
#include <utility>
#include <vector>

namespace sailmap::fpga {
namespace {

constexpr std::array<std::pair<const char*, Fault>, 9> fault_names = {
    {{"no-device", Fault::no_device},
     {"wrong-xclbin", Fault::wrong_xclbin},
     {"wrong-kernel", Fault::wrong_kernel},
     {"other-version", Fault::other_version},
     {"hang", Fault::hang},
     {"lost", Fault::lost},
     {"wrong-length", Fault::wrong_length},
     {"wrong-frame", Fault::wrong_frame},
     {"damaged-record", Fault::damaged_record}}};

class SimulatedDevice;

class SimulatedSlot : public Slot {
 public:
  SimulatedSlot(SimulatedDevice& device, const KernelInterface& kernel, const BufferSizes& sizes)
      : device_(device), kernel_(kernel) {
    for (std::size_t i = 0; i < buffer_count; ++i) memory_[i].resize(sizes[i]);
  }
  [[nodiscard]] std::span<std::byte> memory(Buffer buffer) override { return memory_[index_of(buffer)]; }
  void start(const Call& call) override;
  [[nodiscard]] Outcome wait(std::chrono::milliseconds timeout) override;

 private:
  friend class SimulatedDevice;

  SimulatedDevice& device_;
  KernelInterface kernel_;
  std::array<std::vector<std::byte>, buffer_count> memory_;
  // Guarded by the device's mutex.
  Call call_;
  bool faulty_ = false;
  bool done_ = false;
};

class SimulatedDevice : public Device {
 public:
  explicit SimulatedDevice(Simulation simulation)
      : simulation_(std::move(simulation)), card_([this](const std::stop_token& stop) { work(stop); }) {}

  [[nodiscard]] std::string name() const override { return "simulated device"; }
  [[nodiscard]] std::vector<KernelInterface> kernels() const override { return simulation_.kernels; }
  [[nodiscard]] std::unique_ptr<Slot> make_slot(const KernelInterface& kernel,
                                                const BufferSizes& sizes) override {
    return std::make_unique<SimulatedSlot>(*this, kernel, sizes);
  }

  [[nodiscard]] bool closes_after_fault() const override { return true; }
  // A simulation that went on would outlive what it works with when the program ends.
  void quiesce() override {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return !working_ && !ready(); });
  }

  void start(SimulatedSlot& slot, const Call& call) {
    const std::lock_guard lock(mutex_);
    if (lost_) throw DeviceError("the device is lost");
    slot.call_ = call;
    slot.done_ = false;
    const bool asks = call.width == 0;  // for the report alone
    slot.faulty_ = !asks && frames_++ >= simulation_.good_frames;
    lost_ = slot.faulty_ && simulation_.fault == Fault::lost;
    started_.push_back(&slot);
    ++in_flight_;
    if (simulation_.on_start && !asks) simulation_.on_start(in_flight_);
    changed_.notify_all();
  }

  Outcome wait(const SimulatedSlot& slot, std::chrono::milliseconds timeout) {
    std::unique_lock lock(mutex_);
    // The time of a simulation passes at once: what will never be done need not be waited for.
    if (slot.faulty_ && simulation_.fault == Fault::hang) return Outcome::timeout;
    changed_.wait_for(lock, timeout, [&] { return slot.done_ || lost_; });
    if (slot.done_) return Outcome::done;
    if (lost_) throw DeviceError("the device is lost");
    return Outcome::timeout;
  }

 private:
  // Whether the frame in front asks for the report alone.
  [[nodiscard]] bool asks() const { return started_.front()->call_.width == 0; }
  // Whether there is a frame to work on.
  [[nodiscard]] bool ready() const {
    return !started_.empty() &&
           (gathered_ || asks() || static_cast<int>(started_.size()) >= simulation_.gather);
  }

  // The next frame to work on; null when the device is closed.
  SimulatedSlot* next(const std::stop_token& stop) {
    std::unique_lock lock(mutex_);
    working_ = false;
    changed_.notify_all();
    if (!changed_.wait(lock, stop, [this] { return ready(); })) return nullptr;
    working_ = true;
    if (!gathered_ && !asks()) {
      gathered_ = true;
      std::ranges::reverse(started_);
    }
    SimulatedSlot* slot = started_.front();
    started_.pop_front();
    return slot;
  }

  void spoil(SimulatedSlot& slot) const {
    const auto report = slot.words<std::uint32_t>(Buffer::report, std::size_t{4} * SAILMAP_REPORT_WORDS);
    if (simulation_.fault == Fault::other_version) report[SAILMAP_REPORT_VERSION] += 1;
    if (!slot.faulty_) return;
    if (simulation_.fault == Fault::wrong_length) report[SAILMAP_REPORT_OUTPUT_WORDS] -= 8;
    if (simulation_.fault == Fault::wrong_frame) report[SAILMAP_REPORT_FRAME] -= 1;
    const auto record = slot.words<std::uint32_t>(Buffer::record, slot.memory(Buffer::record).size());
    if (simulation_.fault == Fault::damaged_record && !record.empty()) record.front() += 1;
  }

  void work(const std::stop_token& stop) {
    while (SimulatedSlot* slot = next(stop)) {
      const bool never_done =
          slot->faulty_ && (simulation_.fault == Fault::hang || simulation_.fault == Fault::lost);
      if (never_done) continue;
      run_kernel(slot->kernel_, *slot, slot->call_, simulation_.limits);
      spoil(*slot);
      const std::lock_guard lock(mutex_);
      slot->done_ = true;
      --in_flight_;
      changed_.notify_all();
    }
  }

  Simulation simulation_;
  std::mutex mutex_;
  std::condition_variable_any changed_;
  std::deque<SimulatedSlot*> started_;
  int in_flight_ = 0;
  int frames_ = 0;
  bool gathered_ = false;
  bool working_ = false;
  bool lost_ = false;
  std::jthread card_;  // last: it uses the others
};

void SimulatedSlot::start(const Call& call) { device_.start(*this, call); }
Outcome SimulatedSlot::wait(std::chrono::milliseconds timeout) { return device_.wait(*this, timeout); }

// What a word of simulation_from_text says of the kernels; nothing when it does not.
std::optional<std::vector<KernelInterface>> kernels_from_word(const std::string& word) {
  if (word == "maps") return std::vector{maps_kernel};
  if (word == "signature") return std::vector{signature_kernel};
  if (word == "both") return std::vector{maps_kernel, signature_kernel};
  return std::nullopt;
}

}  // namespace

Simulation simulation_from_text(const std::string& text) {
  Simulation simulation;
  std::istringstream words(text);
  char x = 0;
  char y = 0;
  words >> simulation.limits.max_width >> x >> simulation.limits.max_height >> y >> simulation.limits.beat;
  const bool good = words && x == 'x' && y == 'x';
  std::string fault;
  words >> fault;
  if (const auto kernels = kernels_from_word(fault)) {
    simulation.kernels = *kernels;
    fault.clear();
    words >> fault;
  }
  int count = 0;
  if (!fault.empty() && !(words >> count)) count = 0;
  if (good && fault == "gather" && count > 0) {
    simulation.gather = count;
    return simulation;
  }
  const auto* const found =
      std::ranges::find_if(fault_names, [&](const auto& entry) { return fault == entry.first; });
  if (!good || (!fault.empty() && found == fault_names.end())) {
    throw Error("no simulated device '" + text +
                "': WIDTHxHEIGHTxBEAT [maps | signature | both] [FAULT [GOOD-FRAMES] | gather FRAMES]");
  }
  if (!fault.empty()) simulation.fault = found->second;
  simulation.good_frames = count;
  return simulation;
}

std::unique_ptr<Device> open_simulated_device(const Simulation& simulation) {
  switch (simulation.fault) {
    case Fault::no_device:
      throw DeviceError("simulated device: there is none");
    case Fault::wrong_xclbin:
      throw DeviceError("simulated device: the xclbin is for another card");
    case Fault::wrong_kernel:
      throw DeviceError("simulated device: the xclbin has no kernel " SAILMAP_MEMORY_KERNEL
                        " or " SAILMAP_SIGNATURE_KERNEL);
    default:
      return std::make_unique<SimulatedDevice>(simulation);
  }
}

}  // namespace sailmap::fpga
