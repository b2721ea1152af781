// Every fault of a device: one line that says what, for everyone who uses it, or the fallback in its place.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>
#include <mutex>
#include <thread>
#include <vector>

#include "frontends/xrt/simulated_device.hpp"
#include "frontends/xrt/xrt_frontend.hpp"
#include "pictures.hpp"

namespace sailmap::testing {
namespace {

using namespace fpga;
using namespace std::chrono_literals;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::StartsWith;

struct Faults : ::testing::Test {
  Simulation simulation;
  XrtSettings settings;
  std::vector<std::string> warnings;

  std::shared_ptr<XrtService> service() {
    settings.warn = [this](const std::string& what) { warnings.push_back(what); };
    return make_service(settings, [this] { return open_simulated_device(simulation); });
  }
  void with(Fault fault, int good_frames = 0) {
    simulation.fault = fault;
    simulation.good_frames = good_frames;
    // Long enough for any machine; the simulation does not wait for what never comes.
    settings.timeout = 60000ms;
  }
};

template <class Fault = DeviceError, class Work>
std::string fault_of(Work work) {
  try {
    work();
  } catch (const Fault& fault) {
    return fault.what();
  }
  return "nothing";
}

TEST_F(Faults, WhenOpening) {
  const std::vector<std::pair<Fault, const char*>> faults = {
      {Fault::no_device, "simulated device: there is none"},
      {Fault::wrong_xclbin, "simulated device: the xclbin is for another card"},
      {Fault::wrong_kernel, "simulated device: the xclbin has no kernel sailmap_memory"},
      {Fault::other_version,
       "simulated device: the kernel reports version 0x534d0002, this program is for 0x534d0001"}};
  for (const auto& [fault, says] : faults) {
    with(fault);
    settings.fallback.clear();
    EXPECT_EQ(fault_of([&] { service(); }), says);
    EXPECT_TRUE(warnings.empty());

    settings.fallback = "fixed";
    const auto frontend = make_frontend_on(service());
    for (const unsigned seed : {1U, 2U}) {
      Maps maps;
      frontend->compute(picture(seed).view(), maps);
      expect_same(maps, expected_maps(picture(seed)));
    }
    EXPECT_THAT(warnings, ElementsAre(std::string("xrt: ") + says +
                                      "; the front end fixed takes over, which computes the same"));
    warnings.clear();
  }
}

TEST_F(Faults, MidwayForEveryoneFromThenOn) {
  const std::vector<std::pair<Fault, const char*>> faults = {
      {Fault::hang, "simulated device: the kernel did not finish a frame within 60000 ms"},
      {Fault::lost, "simulated device: the device is lost"},
      {Fault::wrong_length,
       "simulated device: the kernel reports maps of 424 words where a frame of 96x72 has 432"},
      {Fault::wrong_frame, "simulated device: the kernel reports frame 3 where frame 4 was asked for"}};
  for (const auto& [fault, says] : faults) {
    with(fault, 3);
    const auto shared = service();
    const auto frontend = make_frontend_on(shared);
    Maps maps;
    for (const unsigned seed : {1U, 2U, 3U}) {
      frontend->compute(picture(seed).view(), maps);
      expect_same(maps, expected_maps(picture(seed)));
    }
    EXPECT_EQ(fault_of([&] { frontend->compute(picture(4).view(), maps); }), says);
    const auto another = make_frontend_on(shared);
    EXPECT_EQ(fault_of([&] { another->compute(picture(5).view(), maps); }), says);
  }
}

// More threads than buffer sets: those that wait for one must hear of the fault too.
TEST_F(Faults, NobodyWaitsForADeviceThatFailed) {
  for (const Fault fault : {Fault::hang, Fault::lost}) {
    with(fault);
    settings.frames_in_flight = 2;
    const auto shared = service();
    std::mutex mutex;
    std::vector<std::string> said;
    {
      std::vector<std::jthread> threads;
      for (unsigned i = 0; i < 6; ++i) {
        threads.emplace_back([&, i] {
          Maps maps;
          const std::string what =
              fault_of([&] { make_frontend_on(shared)->compute(picture(i).view(), maps); });
          const std::lock_guard lock(mutex);
          said.push_back(what);
        });
      }
    }
    EXPECT_THAT(said, ::testing::Each(StartsWith("simulated device: the ")));
    EXPECT_EQ(said.size(), 6U);
  }
}

TEST_F(Faults, TheFallbackTakesOverMidwayAndIsToldOfOnce) {
  for (const Fault fault : {Fault::lost, Fault::wrong_length, Fault::wrong_frame}) {
    with(fault, 2);
    settings.fallback = "fixed";
    settings.frames_in_flight = 2;
    warnings.clear();
    const auto shared = service();
    std::vector<std::vector<Maps>> got(4);
    {
      std::vector<std::jthread> threads;
      for (unsigned thread = 0; thread < 4; ++thread) {
        threads.emplace_back([&, thread] {
          const auto frontend = make_frontend_on(shared);
          for (unsigned i = 0; i < 3; ++i) {
            frontend->compute(picture(10 * thread + i).view(), got[thread].emplace_back());
          }
        });
      }
    }
    for (unsigned thread = 0; thread < 4; ++thread) {
      for (unsigned i = 0; i < 3; ++i) expect_same(got[thread][i], expected_maps(picture(10 * thread + i)));
    }
    ASSERT_EQ(warnings.size(), 1U);
    EXPECT_THAT(warnings[0], HasSubstr("the front end fixed takes over"));
  }
}

TEST_F(Faults, SizesThatTheKernelDoesNotTake) {
  simulation.limits = {128, 100, 4};
  const auto frontend = make_frontend_on(service());
  Maps maps;
  const std::string takes =
      " pixels; the kernel of simulated device takes up to 128x100, widths that are multiples of 4";
  for (const auto& [width, height, says] :
       {std::tuple{132, 72, "image is 132x72"}, {96, 101, "image is 96x101"}, {98, 72, "image is 98x72"}}) {
    EXPECT_EQ(
        fault_of<Error>([&, w = width, h = height] { frontend->compute(picture(1, w, h).view(), maps); }),
        says + takes);
  }
  // The spec's own limits, for every front end.
  EXPECT_THAT(fault_of<Error>([&] { frontend->compute(picture(1, 60, 72).view(), maps); }),
              HasSubstr("each side must be 64 to 4096"));
  // The device is not at fault.
  frontend->compute(picture(2, 128, 100).view(), maps);
  expect_same(maps, expected_maps(picture(2, 128, 100)));
}

TEST_F(Faults, TheFallbackTakesSizesThatTheKernelDoesNotTake) {
  simulation.limits = {128, 100, 4};
  settings.fallback = "fixed";
  const auto frontend = make_frontend_on(service());
  Maps maps;
  for (const int width : {98, 96, 132}) {
    frontend->compute(picture(3, width, 72).view(), maps);
    expect_same(maps, expected_maps(picture(3, width, 72)));
  }
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_THAT(warnings[0], StartsWith("xrt: image is 98x72 pixels; the kernel of"));
}

TEST_F(Faults, LimitsThatCannotBe) {
  for (const KernelLimits limits :
       {KernelLimits{0, 480, 4}, {640, 4100, 4}, {640, 480, 3}, {642, 480, 4}, {640, 480, 0}}) {
    simulation.limits = limits;
    EXPECT_THAT(fault_of([&] { service(); }), HasSubstr("the kernel reports limits that cannot be"));
  }
}

TEST(Settings, AreChecked) {
  XrtSettings good;
  good.xclbin = "kernel.xclbin";
  const auto refused = [&](auto change) {
    XrtSettings settings = good;
    change(settings);
    return fault_of<Error>([&] { set_xrt(settings); });
  };
  EXPECT_EQ(refused([](XrtSettings& s) { s.xclbin.clear(); }), "xrt: no xclbin is named");
  EXPECT_THAT(refused([](XrtSettings& s) { s.timeout = 0ms; }), HasSubstr("timeout"));
  EXPECT_THAT(refused([](XrtSettings& s) { s.frames_in_flight = 1; }), HasSubstr("2 to 64"));
  EXPECT_THAT(refused([](XrtSettings& s) { s.fallback = "reference"; }), HasSubstr("'fixed' or nothing"));
  EXPECT_THAT(fault_of<Error>([] { make_frontend("xrt"); }), HasSubstr("--xclbin FILE"));
  EXPECT_EQ(waiting_threads("fixed"), 0);
  EXPECT_EQ(waiting_threads("xrt"), 3);
}

}  // namespace
}  // namespace sailmap::testing
