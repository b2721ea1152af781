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

struct Faults : ::testing::TestWithParam<KernelInterface> {
  Simulation simulation;
  XrtSettings settings;
  std::vector<std::string> warnings;

  Faults() { simulation.kernels = {GetParam()}; }
  static bool maps() { return GetParam() == maps_kernel; }
  static Answer ask(Frontend& frontend, const Picture& picture) {
    return testing::ask(frontend, picture, GetParam());
  }
  static void expect_right(const Answer& got, const Picture& picture) {
    expect_same(got, expected_answer(picture, GetParam()));
  }
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

TEST_P(Faults, WhenOpening) {
  const std::vector<std::pair<Fault, const char*>> faults = {
      {Fault::no_device, "simulated device: there is none"},
      {Fault::wrong_xclbin, "simulated device: the xclbin is for another card"},
      {Fault::wrong_kernel,
       "simulated device: the xclbin has no kernel sailmap_memory or sailmap_signature_memory"},
      {Fault::other_version,
       maps() ? "simulated device: the kernel reports version 0x534d0002, this program is for 0x534d0001"
              : "simulated device: the kernel reports version 0x53470002, this program is for 0x53470001"}};
  for (const auto& [fault, says] : faults) {
    with(fault);
    settings.fallback.clear();
    EXPECT_EQ(fault_of([&] { service(); }), says);
    EXPECT_TRUE(warnings.empty());

    settings.fallback = "fixed";
    const auto frontend = make_frontend_on(service());
    for (const unsigned seed : {1U, 2U}) {
      expect_right(ask(*frontend, picture(seed)), picture(seed));
    }
    EXPECT_THAT(warnings, ElementsAre(std::string("xrt: ") + says +
                                      "; the front end fixed takes over, which computes the same"));
    warnings.clear();
  }
}

TEST_P(Faults, MidwayForEveryoneFromThenOn) {
  std::vector<std::pair<Fault, const char*>> faults = {
      {Fault::hang, "simulated device: the kernel did not finish a frame within 60000 ms"},
      {Fault::lost, "simulated device: the device is lost"},
      {Fault::wrong_length,
       maps()
           ? "simulated device: the kernel reports maps of 424 words where a frame of 96x72 has 432"
           : "simulated device: the kernel reports a signature of 240 words where a frame of 96x72 has 248"},
      {Fault::wrong_frame, "simulated device: the kernel reports frame 3 where frame 4 was asked for"}};
  if (!maps()) {
    faults.emplace_back(
        Fault::damaged_record,
        "simulated device: a signature from the hardware is damaged: its first word is 1397555202");
  }
  for (const auto& [fault, says] : faults) {
    with(fault, 3);
    const auto shared = service();
    const auto frontend = make_frontend_on(shared);
    for (const unsigned seed : {1U, 2U, 3U}) expect_right(ask(*frontend, picture(seed)), picture(seed));
    EXPECT_EQ(fault_of([&] { ask(*frontend, picture(4)); }), says);
    const auto another = make_frontend_on(shared);
    EXPECT_EQ(fault_of([&] { ask(*another, picture(5)); }), says);
  }
}

// More threads than buffer sets: those that wait for one must hear of the fault too.
TEST_P(Faults, NobodyWaitsForADeviceThatFailed) {
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
          const std::string what = fault_of([&] { ask(*make_frontend_on(shared), picture(i)); });
          const std::lock_guard lock(mutex);
          said.push_back(what);
        });
      }
    }
    EXPECT_THAT(said, ::testing::Each(StartsWith("simulated device: the ")));
    EXPECT_EQ(said.size(), 6U);
  }
}

TEST_P(Faults, TheFallbackTakesOverMidwayAndIsToldOfOnce) {
  for (const Fault fault : {Fault::lost, Fault::wrong_length, Fault::wrong_frame, Fault::damaged_record}) {
    if (maps() && fault == Fault::damaged_record) continue;
    with(fault, 2);
    settings.fallback = "fixed";
    settings.frames_in_flight = 2;
    warnings.clear();
    const auto shared = service();
    std::vector<std::vector<Answer>> got(4);
    {
      std::vector<std::jthread> threads;
      for (unsigned thread = 0; thread < 4; ++thread) {
        threads.emplace_back([&, thread] {
          const auto frontend = make_frontend_on(shared);
          for (unsigned i = 0; i < 3; ++i) {
            got[thread].push_back(ask(*frontend, picture(10 * thread + i)));
          }
        });
      }
    }
    for (unsigned thread = 0; thread < 4; ++thread) {
      for (unsigned i = 0; i < 3; ++i) expect_right(got[thread][i], picture(10 * thread + i));
    }
    ASSERT_EQ(warnings.size(), 1U);
    EXPECT_THAT(warnings[0], HasSubstr("the front end fixed takes over"));
  }
}

TEST_P(Faults, SizesThatTheKernelDoesNotTake) {
  simulation.limits = {128, 100, 4};
  const auto frontend = make_frontend_on(service());
  const std::string takes =
      " pixels; the kernel of simulated device takes up to 128x100, widths that are multiples of 4";
  for (const auto& [width, height, says] :
       {std::tuple{132, 72, "image is 132x72"}, {96, 101, "image is 96x101"}, {98, 72, "image is 98x72"}}) {
    EXPECT_EQ(fault_of<Error>([&, w = width, h = height] { ask(*frontend, picture(1, w, h)); }),
              says + takes);
  }
  // The spec's own limits, for every front end.
  EXPECT_THAT(fault_of<Error>([&] { ask(*frontend, picture(1, 60, 72)); }),
              HasSubstr("each side must be 64 to 4096"));
  // The device is not at fault.
  expect_right(ask(*frontend, picture(2, 128, 100)), picture(2, 128, 100));
}

TEST_P(Faults, TheFallbackTakesSizesThatTheKernelDoesNotTake) {
  simulation.limits = {128, 100, 4};
  settings.fallback = "fixed";
  const auto frontend = make_frontend_on(service());
  for (const int width : {98, 96, 132}) {
    expect_right(ask(*frontend, picture(3, width, 72)), picture(3, width, 72));
  }
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_THAT(warnings[0], StartsWith("xrt: image is 98x72 pixels; the kernel of"));
}

TEST_P(Faults, LimitsThatCannotBe) {
  for (const KernelLimits limits :
       {KernelLimits{0, 480, 4}, {640, 4100, 4}, {640, 480, 3}, {642, 480, 4}, {640, 480, 0}}) {
    simulation.limits = limits;
    EXPECT_THAT(fault_of([&] { service(); }), HasSubstr("the kernel reports limits that cannot be"));
  }
}

INSTANTIATE_TEST_SUITE_P(Xrt, Faults, ::testing::ValuesIn(known_kernels), kernel_word);

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
