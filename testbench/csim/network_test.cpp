// The front end as a network of FIFOs: it runs at depth 2, it needs its delay lines, and a double buffer
// takes in the next frame while the last one is replayed.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

#include "frames.hpp"
#include "sailmap/csim/front_end.hpp"
#include "sailmap/hls/throughput.hpp"

namespace sailmap::testing {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

using Small = hls::Config<320, 240, 1>;

TEST(CsimNetwork, NoFifoHoldsMoreThanTwo) {
  csim::Scheduler scheduler;
  const std::vector<csim::Frame> frames = {constant_frame(320, 240, 5, 5, 5),
                                           constant_frame(320, 240, 5, 5, 5)};
  csim::run_front_end<Small>(frames, scheduler);
  EXPECT_EQ(scheduler.depth(), 2U);
  EXPECT_GT(scheduler.high_water().size(), 60U);
  for (const auto& [fifo, words] : scheduler.high_water()) EXPECT_LE(words, 2U) << fifo;
}

// Whether the network stops depends on sizes alone, so frames of one colour show it for all frames of their
// size.
TEST(CsimNetwork, RunsAtDepthTwoForManyShapes) {
  for (int width = 64; width <= 320; width += 37) {
    for (int height = 64; height <= 240; height += 43) {
      csim::Scheduler scheduler;
      const std::vector<csim::Frame> frames(2, constant_frame(width, height, 1, 1, 1));
      EXPECT_NO_THROW(csim::run_front_end<Small>(frames, scheduler)) << width << "x" << height;
    }
  }
}

// Reads a map of the base level away. `Pair`: the stages of a region must differ.
template <int Pair>
void discard(hls::stream<std::uint64_t>& in, std::uint16_t width, std::uint16_t height) {
  const int pixels = hls::geometry::base_side(width) * hls::geometry::base_side(height);
  for (int i = 0; i < pixels; ++i) in.read();
}

// A delay line other than the formula's by so many rows and columns.
template <class Delay, int Rows, int Columns>
struct Changed {
  static constexpr int rows = Delay::rows + Rows;
  static constexpr int columns = Delay::columns + Columns;
};
struct Removed {
  static constexpr int rows = 0;
  static constexpr int columns = 0;
};

// The region's own part from the pyramid to the feature maps, but with these delay lines.
template <class Delay2, class Delay3, class Gabor>
struct Levels {
  template <int Level>
  struct BranchDelay : std::conditional_t<Level == 2, Delay2, Delay3> {};
  using GaborDelay = Gabor;
  using Config = Small;

  static void run(hls::stream<std::uint16_t>& base_intensity, hls::stream<std::uint64_t>& base_colours,
                  std::uint16_t width, std::uint16_t height) {
    using namespace hls;
#include "sailmap/hls/region/2_levels.inc"
    SAILMAP_STAGE((discard<on_off_pair>), sum_on_off, width, height);
    SAILMAP_STAGE((discard<green_blue_pair>), sum_green_blue, width, height);
    SAILMAP_STAGE((discard<red_yellow_pair>), sum_red_yellow, width, height);
    SAILMAP_STAGE((discard<ori_0_45_pair>), sum_ori_0_45, width, height);
    SAILMAP_STAGE((discard<ori_90_135_pair>), sum_ori_90_135, width, height);
  }

  // "ok", or the fault of a run over one frame.
  static std::string fault(int width, int height) {
    csim::Scheduler scheduler;
    csim::Stream<std::uint16_t> intensity("base_intensity");
    csim::Stream<std::uint64_t> colours("base_colours");
    const int pixels = hls::geometry::base_side(width) * hls::geometry::base_side(height);
    scheduler.launch("pyramid", {&intensity, &colours}, [&] {
      for (int i = 0; i < pixels; ++i) {
        intensity.write(1);
        colours.write(1);
      }
    });
    run(intensity, colours, static_cast<std::uint16_t>(width), static_cast<std::uint16_t>(height));
    try {
      scheduler.run();
    } catch (const csim::NetworkError& error) {
      return error.what();
    }
    return "ok";
  }
};

using Delay2 = hls::BranchDelay<2>;
using Delay3 = hls::BranchDelay<3>;
using Gabor = hls::GaborDelay;

TEST(CsimNetwork, RunsWithTheDelaysOfTheFormula) {
  EXPECT_EQ((Levels<Delay2, Delay3, Gabor>::fault(320, 240)), "ok");
}

TEST(CsimNetwork, WithoutADelayLineItDeadlocksAndTheFifoIsNamed) {
  EXPECT_THAT((Levels<Removed, Delay3, Gabor>::fault(320, 240)),
              AllOf(HasSubstr("deadlock"), HasSubstr("waits to write 'early_colours_2' (full"),
                    HasSubstr("across_scales<Config, 2"), HasSubstr("waits to read 'partial_")));
  EXPECT_THAT((Levels<Delay2, Removed, Gabor>::fault(320, 240)),
              AllOf(HasSubstr("deadlock"), HasSubstr("waits to write 'early_colours_3' (full"),
                    HasSubstr("across_scales<Config, 3"), HasSubstr("waits to read '")));
  EXPECT_THAT((Levels<Delay2, Delay3, Removed>::fault(320, 240)),
              AllOf(HasSubstr("deadlock"), HasSubstr("waits to write 'gabor_early_")));
}

// The formula is exact: a row more or less stops the network.
TEST(CsimNetwork, ARowMoreOrLessDeadlocks) {
  EXPECT_THAT((Levels<Changed<Delay2, 1, 0>, Delay3, Gabor>::fault(320, 240)), HasSubstr("deadlock"));
  EXPECT_THAT((Levels<Changed<Delay2, -1, 0>, Delay3, Gabor>::fault(320, 240)), HasSubstr("deadlock"));
  EXPECT_THAT((Levels<Delay2, Changed<Delay3, 1, 0>, Gabor>::fault(320, 240)), HasSubstr("deadlock"));
  EXPECT_THAT((Levels<Delay2, Changed<Delay3, -1, 0>, Gabor>::fault(320, 240)), HasSubstr("deadlock"));
}

// By hand, for VGA: 480 rows of 641 cycles and one of 320 fill the first reduction at one pixel a beat, and a
// single store counts and replays 160 x 120 pixels before it fills again; at eight pixels a beat two stores
// wait for the two passes over 160 x 120 pixels and for as many local maxima as there are at most.
TEST(Throughput, OfVgaIsWhatTheLoopsSay) {
  EXPECT_EQ(hls::throughput::frame(640, 480, 1, false), 480 * 641 + 320 + 2 * 160 * 120);
  EXPECT_EQ(hls::throughput::frame(640, 480, 1, true), 480 * 641 + 320);
  EXPECT_EQ(hls::throughput::frame(640, 480, 4, true), 481 * 160);
  EXPECT_EQ(hls::throughput::frame(640, 480, 8, true), 2 * 160 * 120 + 80 * 60);
}

// Nothing is read from the network before all of `frames` has gone in: "ok", or the fault.
template <class Config>
std::string swallow(std::span<const csim::Frame> frames) {
  csim::Scheduler scheduler;
  csim::Stream<std::uint8_t> red("red");
  csim::Stream<std::uint8_t> green("green");
  csim::Stream<std::uint8_t> blue("blue");
  csim::Stream<std::uint32_t> intensity_maps("intensity_maps");
  csim::Stream<std::uint64_t> colour_maps("colour_maps");
  csim::Stream<std::uint64_t> orientation_maps("orientation_maps");
  csim::Stream<std::uint64_t> conspicuity_maps("conspicuity_maps");
  csim::Stream<std::uint16_t> saliency("saliency");
  csim::Stream<std::uint32_t> statistics("statistics");
  std::vector<std::unique_ptr<csim::Stream<int>>> all_in;
  const auto drain = [&](auto& stream, std::size_t words) {
    all_in.push_back(std::make_unique<csim::Stream<int>>("all in"));
    csim::Stream<int>& go = *all_in.back();
    scheduler.launch("sink of " + stream.name(), {&stream, &go}, [&stream, &go, words] {
      go.read();
      for (std::size_t i = 0; i < words; ++i) stream.read();
    });
  };
  std::size_t pixels = 0;
  for (const csim::Frame& frame : frames) {
    pixels += static_cast<std::size_t>(hls::geometry::base_side(frame.width) *
                                       hls::geometry::base_side(frame.height));
    hls::FrontEnd<Config>::run(
        red, green, blue, intensity_maps, colour_maps, orientation_maps, conspicuity_maps, saliency,
        statistics, static_cast<std::uint16_t>(frame.width), static_cast<std::uint16_t>(frame.height));
  }
  drain(intensity_maps, pixels);
  drain(colour_maps, pixels);
  drain(orientation_maps, pixels);
  drain(conspicuity_maps, pixels);
  drain(saliency, pixels);
  drain(statistics, frames.size() * hls::statistics_words);
  scheduler.launch("source", {&red, &green, &blue}, [&] {
    for (const csim::Frame& frame : frames) {
      for (std::size_t i = 0; i < frame.rgb.size(); i += 3) {
        red.write(frame.rgb[i]);
        green.write(frame.rgb[i + 1]);
        blue.write(frame.rgb[i + 2]);
      }
    }
    for (const auto& go : all_in) go->write(1);
  });
  try {
    scheduler.run();
  } catch (const csim::NetworkError& error) {
    return error.what();
  }
  return "ok";
}

// The frames are higher than what the delay lines could hold of them.
TEST(CsimNetwork, ADoubleBufferTakesTheNextFrameInWhileTheLastIsHeld) {
  const std::vector<csim::Frame> frames(2, constant_frame(64, 240, 7, 7, 7));
  EXPECT_EQ((swallow<hls::Config<64, 240, 1, true>>(frames)), "ok");
  EXPECT_THAT((swallow<hls::Config<64, 240, 1, false>>(frames)),
              AllOf(HasSubstr("deadlock"), HasSubstr("'")));
}

}  // namespace
}  // namespace sailmap::testing
