// Which kernel of a card does what is asked: maps, or signatures that come without.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

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
using ::testing::ElementsAre;

constexpr const char* no_maps =
    "simulated device: it has no kernel sailmap_memory, which hands out maps, but sailmap_signature_memory";

struct Choice : ::testing::Test {
  Simulation simulation;
  XrtSettings settings;
  std::vector<std::string> warnings;

  Choice() { settings.timeout = 60000ms; }
  std::shared_ptr<XrtService> service(std::vector<KernelInterface> kernels) {
    simulation.kernels = std::move(kernels);
    settings.warn = [this](const std::string& what) { warnings.push_back(what); };
    return make_service(settings, [this] { return open_simulated_device(simulation); });
  }
};

// An image described both ways; the maps that came along.
void describe_and_expect(Frontend& frontend, const Picture& image, const RegionConfig& regions, Maps& maps) {
  Signature signature;
  frontend.describe(image.view(), regions, maps, signature);
  Maps others;
  Signature want;
  make_frontend("fixed")->describe(image.view(), regions, others, want);
  EXPECT_TRUE(signature == want);
}

TEST_F(Choice, ACardOfSignaturesHandsOutNoMaps) {
  const auto frontend = make_frontend_on(service({signature_kernel}));
  Maps maps = expected_maps(picture(1));  // of another image: they must not stay
  RegionConfig other = on_chip();
  other.max_regions = 4;
  other.stop_ratio = 0.125;
  other.box_side = 7;
  describe_and_expect(*frontend, picture(2), on_chip(), maps);
  EXPECT_TRUE(maps.empty());
  describe_and_expect(*frontend, picture(2), other, maps);
  EXPECT_TRUE(maps.empty());
}

TEST_F(Choice, ACardOfMapsHasItsSignaturesMadeOfThem) {
  const auto frontend = make_frontend_on(service({maps_kernel}));
  for (const RegionConfig& regions : {RegionConfig(), on_chip()}) {
    Maps maps;
    describe_and_expect(*frontend, picture(3), regions, maps);
    expect_same(maps, expected_maps(picture(3)));
  }
}

TEST_F(Choice, ACardOfBothDoesWhatEachImageAsks) {
  const auto shared = service({maps_kernel, signature_kernel});
  std::vector<std::jthread> threads;
  for (unsigned thread = 0; thread < 4; ++thread) {
    threads.emplace_back([&, thread] {
      const auto frontend = make_frontend_on(shared);
      for (unsigned i = 0; i < 4; ++i) {
        const Picture image = picture(10 * thread + i);
        const bool chip = (thread + i) % 2 == 0;
        Maps maps;
        describe_and_expect(*frontend, image, chip ? on_chip() : RegionConfig(), maps);
        EXPECT_EQ(maps.empty(), chip);
        if (!chip) expect_same(maps, expected_maps(image));
      }
    });
  }
}

TEST_F(Choice, MapsOfACardOfSignatures) {
  const auto frontend = make_frontend_on(service({signature_kernel}));
  Maps maps;
  Signature signature;
  const auto fault_of = [](auto work) -> std::string {
    try {
      work();
    } catch (const DeviceError& fault) {
      return fault.what();
    }
    return "nothing";
  };
  EXPECT_EQ(fault_of([&] { frontend->compute(picture(4).view(), maps); }), no_maps);
  EXPECT_EQ(fault_of([&] { frontend->describe(picture(4).view(), {}, maps, signature); }), no_maps);
  // The card itself has not failed.
  describe_and_expect(*frontend, picture(4), on_chip(), maps);
  EXPECT_TRUE(maps.empty());
}

TEST_F(Choice, TheFallbackMakesTheMapsOfACardOfSignatures) {
  settings.fallback = "fixed";
  simulation.fault = Fault::lost;
  simulation.good_frames = 2;
  const auto frontend = make_frontend_on(service({signature_kernel}));
  const std::string takes_over = "; the front end fixed takes over, which computes the same";
  Maps maps;
  for (const unsigned seed : {1U, 2U}) {
    frontend->compute(picture(seed).view(), maps);
    expect_same(maps, expected_maps(picture(seed)));
    describe_and_expect(*frontend, picture(seed), on_chip(), maps);
    EXPECT_TRUE(maps.empty()) << "the card was not asked";
  }
  EXPECT_THAT(warnings, ElementsAre("xrt: " + std::string(no_maps) + takes_over));
  // That the card fails at last is another thing to tell.
  for (const unsigned seed : {3U, 4U}) describe_and_expect(*frontend, picture(seed), on_chip(), maps);
  EXPECT_THAT(warnings, ElementsAre("xrt: " + std::string(no_maps) + takes_over,
                                    "xrt: simulated device: the device is lost" + takes_over));
}

// A card that says it has one kernel where the other one works.
class Mistaken : public Device {
 public:
  explicit Mistaken(const KernelInterface& said)
      : said_(said), real_(said == maps_kernel ? signature_kernel : maps_kernel) {
    Simulation simulation;
    simulation.kernels = {real_};
    device_ = open_simulated_device(simulation);
  }
  [[nodiscard]] std::string name() const override { return "mistaken device"; }
  [[nodiscard]] std::vector<KernelInterface> kernels() const override { return {said_}; }
  [[nodiscard]] std::unique_ptr<Slot> make_slot(const KernelInterface& /*kernel*/,
                                                const BufferSizes& /*sizes*/) override {
    return device_->make_slot(real_, buffer_sizes(real_, 640, 480));
  }

 private:
  KernelInterface said_;
  KernelInterface real_;
  std::unique_ptr<Device> device_;
};

TEST_F(Choice, OneKernelDoesNotPassForTheOther) {
  const std::vector<std::pair<KernelInterface, const char*>> cases = {
      {maps_kernel, "mistaken device: the kernel reports version 0x53470001, this program is for 0x534d0001"},
      {signature_kernel,
       "mistaken device: the kernel reports version 0x534d0001, this program is for 0x53470001"}};
  for (const auto& [said, says] : cases) {
    try {
      make_service(settings, [kernel = said] { return std::make_unique<Mistaken>(kernel); });
      FAIL() << "passes for " << said.name;
    } catch (const DeviceError& fault) {
      EXPECT_STREQ(fault.what(), says);
    }
  }
}

}  // namespace
}  // namespace sailmap::testing
