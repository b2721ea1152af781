// The front end through the real XRT, in its emulation mode `noop`: a device opens, an xclbin is read,
// buffers are mapped and sent, runs start and end, but no kernel works.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <memory>
#include <thread>

#include "frontends/xrt/simulated_device.hpp"
#include "frontends/xrt/xrt_frontend.hpp"
#include "needs.hpp"
#include "pictures.hpp"
#include "temporary_folder.hpp"

#ifdef SAILMAP_XRT_LIBRARIES
#include "xclbin_writer.hpp"
#endif

namespace sailmap::testing {
namespace {

using namespace fpga;
using namespace std::chrono_literals;
using ::testing::HasSubstr;

#ifndef SAILMAP_XRT_LIBRARIES

TEST(Noop, NeedsXrt) {
  EXPECT_FALSE(has_xrt());
  XrtSettings settings;
  settings.xclbin = "kernel.xclbin";
  set_xrt(settings);
  EXPECT_THROW(make_frontend("xrt"), DeviceError);
  SAILMAP_NEEDS_TOOL(false, "XRT in this build (libxrt-dev)");
}

#else

// A known kernel as the xclbin writer takes it.
XclbinKernel described(const KernelInterface& kernel) {
  return {kernel.name, argument_names(kernel), kernel.buffers.size()};
}

std::string xclbin_with(const std::vector<KernelInterface>& kernels) {
  std::vector<XclbinKernel> all;
  for (const KernelInterface& kernel : kernels) all.push_back(described(kernel));
  return xclbin_of(all);
}

struct Noop : ::testing::Test {
  TemporaryFolder folder;
  std::string xclbin;

  void SetUp() override {
    // XRT asks once a process: where its libraries are, and what to emulate.
    std::filesystem::create_directory_symlink(SAILMAP_XRT_LIBRARIES, folder.path() / "lib");
    setenv("XILINX_XRT", folder.path().c_str(), 1);
    setenv("XCL_EMULATION_MODE", "noop", 1);
    xclbin = folder.file("kernel.xclbin", xclbin_with({maps_kernel})).string();
  }
  [[nodiscard]] static std::string fault_of(const std::string& path, unsigned device = 0) {
    try {
      open_native_device(path, device);
    } catch (const DeviceError& fault) {
      return fault.what();
    }
    return "nothing";
  }
};

// The real device, with kernels where `noop` has none: once XRT says that a run has ended, the simulated
// kernel works on the buffers that XRT mapped.
class WithKernel : public Device {
 public:
  WithKernel(std::unique_ptr<Device> device, std::atomic<int>& slots, std::atomic<int>& runs)
      : device_(std::move(device)), slots_(slots), runs_(runs) {}
  [[nodiscard]] std::string name() const override { return device_->name(); }
  [[nodiscard]] std::vector<KernelInterface> kernels() const override { return device_->kernels(); }
  [[nodiscard]] std::unique_ptr<Slot> make_slot(const KernelInterface& kernel,
                                                const BufferSizes& sizes) override {
    ++slots_;
    return std::make_unique<KernelSlot>(device_->make_slot(kernel, sizes), kernel, runs_);
  }

 private:
  class KernelSlot : public Slot {
   public:
    KernelSlot(std::unique_ptr<Slot> slot, const KernelInterface& kernel, std::atomic<int>& runs)
        : slot_(std::move(slot)), kernel_(kernel), runs_(runs) {}
    [[nodiscard]] std::span<std::byte> memory(Buffer buffer) override { return slot_->memory(buffer); }
    void start(const Call& call) override {
      call_ = call;
      slot_->start(call);
    }
    [[nodiscard]] Outcome wait(std::chrono::milliseconds timeout) override {
      const Outcome outcome = slot_->wait(timeout);
      ++runs_;
      run_kernel(kernel_, *slot_, call_, {160, 120, 8});
      return outcome;
    }

   private:
    std::unique_ptr<Slot> slot_;
    KernelInterface kernel_;
    std::atomic<int>& runs_;
    Call call_;
  };

  std::unique_ptr<Device> device_;
  std::atomic<int>& slots_;
  std::atomic<int>& runs_;
};

// For each of the kernels.
struct NoopKernel : Noop, ::testing::WithParamInterface<KernelInterface> {
  void SetUp() override {
    Noop::SetUp();
    xclbin = folder.file("kernel.xclbin", xclbin_with({GetParam()})).string();
  }
};

TEST_P(NoopKernel, AKernelThatReportsNothingIsNotOurs) {
  XrtSettings settings;
  settings.xclbin = xclbin;
  set_xrt(settings);
  EXPECT_TRUE(has_xrt());
  try {
    make_frontend("xrt");
    FAIL() << "noop passes for a kernel";
  } catch (const DeviceError& fault) {
    const std::string version = GetParam() == maps_kernel ? "0x534d0001" : "0x53470001";
    EXPECT_EQ(fault.what(),
              "device 0: the kernel reports version 0x00000000, this program is for " + version);
  }
}

TEST_P(NoopKernel, FramesGoThroughBuffersThatXrtMapsAndThatAreUsedAgain) {
  std::atomic<int> slots = 0;
  std::atomic<int> runs = 0;
  XrtSettings settings;
  settings.timeout = 60s;
  settings.frames_in_flight = 2;
  const auto service = make_service(
      settings, [&] { return std::make_unique<WithKernel>(open_native_device(xclbin, 0), slots, runs); });
  std::vector<std::vector<Answer> > got(3);
  {
    std::vector<std::jthread> threads;
    for (unsigned thread = 0; thread < 3; ++thread) {
      threads.emplace_back([&, thread] {
        const auto frontend = make_frontend_on(service);
        for (unsigned i = 0; i < 4; ++i) {
          got[thread].push_back(ask(*frontend, picture(10 * thread + i), GetParam()));
        }
      });
    }
  }
  for (unsigned thread = 0; thread < 3; ++thread) {
    for (unsigned i = 0; i < 4; ++i) {
      expect_same(got[thread][i], expected_answer(picture(10 * thread + i), GetParam()));
    }
  }
  EXPECT_EQ(runs, 1 + 12);
  EXPECT_LE(slots, 1 + 2);
}

TEST_P(NoopKernel, TheSameMemoryFromFrameToFrame) {
  const auto device = open_native_device(xclbin, 0);
  EXPECT_THAT(device->kernels(), ::testing::ElementsAre(GetParam()));
  const auto slot = device->make_slot(GetParam(), buffer_sizes(GetParam(), 160, 120));
  const auto* const before = slot->memory(Buffer::pixels).data();
  EXPECT_GE(slot->memory(Buffer::pixels).size(), 4U * 160 * 120);
  for (std::uint32_t frame = 0; frame < 3; ++frame) {
    slot->start({160, 120, frame, 20, 0, 10});
    EXPECT_EQ(slot->wait(60s), Outcome::done);
    EXPECT_EQ(slot->memory(Buffer::pixels).data(), before);
  }
}

TEST_P(NoopKernel, OtherArguments) {
  const XclbinKernel good = described(GetParam());
  const std::string bad = (folder.path() / "bad.xclbin").string();
  const std::string says = bad + ": its kernel " + good.name + " has other arguments";
  XclbinKernel other = good;
  std::swap(other.arguments[1], other.arguments[2]);
  EXPECT_EQ(fault_of(folder.file("bad.xclbin", xclbin_of({other})).string()), says);
  other = good;
  other.arguments.emplace_back("more");
  EXPECT_EQ(fault_of(folder.file("bad.xclbin", xclbin_of({other})).string()), says);
  other = good;
  other.arguments.pop_back();
  EXPECT_EQ(fault_of(folder.file("bad.xclbin", xclbin_of({other})).string()), says);
}

INSTANTIATE_TEST_SUITE_P(Xrt, NoopKernel, ::testing::ValuesIn(known_kernels), kernel_word);

// Both kernels of one xclbin, by turns and at once.
TEST_F(Noop, BothKernels) {
  xclbin = folder.file("kernel.xclbin", xclbin_with({maps_kernel, signature_kernel})).string();
  std::atomic<int> slots = 0;
  std::atomic<int> runs = 0;
  XrtSettings settings;
  settings.timeout = 60s;
  const auto service = make_service(
      settings, [&] { return std::make_unique<WithKernel>(open_native_device(xclbin, 0), slots, runs); });
  std::vector<std::jthread> threads;
  for (const KernelInterface& kernel : known_kernels) {
    threads.emplace_back([&] {
      const auto frontend = make_frontend_on(service);
      for (unsigned i = 0; i < 6; ++i) {
        const KernelInterface& now = known_kernels[(i + (kernel == maps_kernel ? 0 : 1)) % 2];
        expect_same(ask(*frontend, picture(i), now), expected_answer(picture(i), now));
      }
    });
  }
  threads.clear();
  EXPECT_EQ(runs, 2 + 12);
}

TEST_F(Noop, WrongFilesAndDevices) {
  const std::string missing = (folder.path() / "missing.xclbin").string();
  EXPECT_EQ(fault_of(missing), missing + ": cannot be read");
  EXPECT_EQ(fault_of(folder.path().string()), folder.path().string() + ": cannot be read");
  const std::string good = xclbin_with({maps_kernel});
  const std::string bad = (folder.path() / "bad.xclbin").string();
  const auto fault_of_bytes = [&](const std::string& bytes) {
    return fault_of(folder.file("bad.xclbin", bytes).string());
  };
  EXPECT_EQ(fault_of_bytes(""), bad + ": is no xclbin");
  EXPECT_EQ(fault_of_bytes("xclbin1" + good.substr(7)), bad + ": is no xclbin");
  for (const std::size_t bytes : {std::size_t{8}, std::size_t{400}, std::size_t{500}, good.size() - 1}) {
    EXPECT_EQ(fault_of_bytes(good.substr(0, bytes)), bad + ": the xclbin is cut off") << bytes;
  }
  XclbinKernel foreign = described(maps_kernel);
  foreign.name = "vadd";
  EXPECT_EQ(fault_of_bytes(xclbin_of({foreign})),
            bad + ": has no kernel sailmap_memory or sailmap_signature_memory");
}

// Without emulation: this machine has no card, or at least not so many. In processes of their own, for XRT
// asks what to emulate once.
TEST_F(Noop, NoSuchCard) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  const auto say = [this] {
    unsetenv("XCL_EMULATION_MODE");
    std::cerr << fault_of(xclbin, 900) << '\n';
    std::exit(0);
  };
  EXPECT_EXIT(say(), ::testing::ExitedWithCode(0), "^device 900 cannot be opened: [^\n]+\n$");
}

TEST_F(Noop, XrtWithoutItsLibraries) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  const auto say = [this] {
    setenv("XILINX_XRT", "/nonexistent", 1);
    std::cerr << fault_of(xclbin) << '\n';
    std::exit(0);
  };
  EXPECT_EXIT(say(), ::testing::ExitedWithCode(0), "^device 0 cannot be opened: [^\n]+\n$");
}

TEST_F(Noop, SectionsOutsideTheFile) {
  const std::string bytes = xclbin_with({maps_kernel});
  // The offset and the size of the first section, as xclbin.h lays them out.
  for (const std::size_t at : {std::size_t{456 + 24}, std::size_t{456 + 32}}) {
    std::string broken = bytes;
    broken[at + 5] = '\x7f';
    const std::string path = folder.file("broken.xclbin", broken).string();
    EXPECT_EQ(fault_of(path), path + ": a section of the xclbin lies outside the file") << at;
  }
}

#endif

}  // namespace
}  // namespace sailmap::testing
