// Several frames really are on the device at once, and each caller gets his own.
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <memory>
#include <thread>
#include <vector>

#include "frontends/xrt/simulated_device.hpp"
#include "frontends/xrt/xrt_frontend.hpp"
#include "pictures.hpp"

namespace sailmap::testing {
namespace {

using namespace fpga;
using namespace std::chrono_literals;

// Long enough for any machine: a frame that waits for another one in vain fails the test.
constexpr auto patience = 60s;

struct InFlight : ::testing::TestWithParam<KernelInterface> {
  std::atomic<int> most = 0;

  std::shared_ptr<XrtService> service(int frames_in_flight, int gather) {
    Simulation simulation;
    simulation.kernels = {GetParam()};
    simulation.gather = gather;
    simulation.on_start = [this](int now) { most = std::max(most.load(), now); };
    XrtSettings settings;
    settings.timeout = patience;
    settings.frames_in_flight = frames_in_flight;
    return make_service(settings, [simulation] { return open_simulated_device(simulation); });
  }
};

// Each thread sends its own pictures, one after the other, of two sizes in turn.
void send_from_threads(const std::shared_ptr<XrtService>& service, const KernelInterface& kernel,
                       unsigned threads, unsigned pictures) {
  std::vector<std::vector<Answer>> got(threads);
  const auto shown = [](unsigned thread, unsigned i) {
    return i % 2 == 0 ? picture(100 * thread + i) : picture(100 * thread + i, 72, 88);
  };
  {
    std::vector<std::jthread> senders;
    for (unsigned thread = 0; thread < threads; ++thread) {
      senders.emplace_back([&, thread] {
        const auto frontend = make_frontend_on(service);
        for (unsigned i = 0; i < pictures; ++i) {
          got[thread].push_back(ask(*frontend, shown(thread, i), kernel));
        }
      });
    }
  }
  for (unsigned thread = 0; thread < threads; ++thread) {
    for (unsigned i = 0; i < pictures; ++i)
      expect_same(got[thread][i], expected_answer(shown(thread, i), kernel));
  }
}

// The device does not begin before both frames have arrived, and does the second one first: with one frame at
// a time nobody would ever get an answer.
TEST_P(InFlight, TwoFramesAtOnceAndEachCallerGetsHisOwn) {
  send_from_threads(service(2, 2), GetParam(), 2, 3);
  EXPECT_EQ(most, 2);
}

TEST_P(InFlight, ThreeOfFiveThreadsAtATime) {
  send_from_threads(service(3, 3), GetParam(), 5, 4);
  EXPECT_EQ(most, 3);
}

TEST_P(InFlight, OneThreadAloneHasOneFrameOnTheDevice) {
  send_from_threads(service(3, 1), GetParam(), 1, 4);
  EXPECT_EQ(most, 1);
}

INSTANTIATE_TEST_SUITE_P(Xrt, InFlight, ::testing::ValuesIn(known_kernels), kernel_word);

}  // namespace
}  // namespace sailmap::testing
