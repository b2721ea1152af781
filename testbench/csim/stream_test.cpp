// The C simulation's FIFOs and scheduler: bounded, ordered, one writer and one reader, and every fault an
// error.
#include "sailmap/hls/stream.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <numeric>
#include <string>
#include <vector>

#include "sailmap/csim/scheduler.hpp"

namespace sailmap::csim {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

void send(Stream<int>& out, int count) {
  for (int i = 0; i < count; ++i) out.write(i);
}

void pass(Stream<int>& in, Stream<int>& out, int count) {
  for (int i = 0; i < count; ++i) out.write(in.read());
}

void receive(Stream<int>& in, std::vector<int>& got, int count) {
  for (int i = 0; i < count; ++i) got.push_back(in.read());
}

// Message of the NetworkError that a run ends with.
std::string fault(Scheduler& scheduler) {
  try {
    scheduler.run();
  } catch (const NetworkError& error) {
    return error.what();
  }
  return "no fault";
}

TEST(Stream, PassesWordsInOrderAtAnyDepth) {
  for (const std::size_t depth : {1, 2, 3, 16}) {
    Scheduler scheduler(depth);
    Stream<int> a("a");
    Stream<int> b("b");
    std::vector<int> got;
    scheduler.launch("receive", {&b}, [&] { receive(b, got, 100); });
    scheduler.launch("send", {&a}, [&] { send(a, 100); });
    scheduler.launch("pass", {&a, &b}, [&] { pass(a, b, 100); });
    scheduler.run();
    std::vector<int> want(100);
    std::iota(want.begin(), want.end(), 0);
    EXPECT_EQ(got, want);
    EXPECT_EQ(scheduler.high_water().at("a"), depth);
  }
}

TEST(Stream, HighWaterMarkIsWhatWasHeld) {
  Scheduler scheduler(16);
  Stream<int> a("a");
  std::vector<int> got;
  scheduler.launch("send", {&a}, [&] { send(a, 5); });
  scheduler.launch("receive", {&a}, [&] { receive(a, got, 5); });
  scheduler.run();
  EXPECT_THAT(scheduler.high_water(), ElementsAre(std::pair<const std::string, std::size_t>("a", 5)));
}

TEST(Stream, WritesTooManyWordsAreADeadlockThatNamesTheFifo) {
  Scheduler scheduler;
  Stream<int> a("a");
  std::vector<int> got;
  scheduler.launch("send", {&a}, [&] { send(a, 10); });
  scheduler.launch("receive", {&a}, [&] { receive(a, got, 3); });
  EXPECT_THAT(fault(scheduler),
              AllOf(HasSubstr("deadlock"), HasSubstr("send waits to write 'a' (full, 2 of 2"),
                    HasSubstr("receive has ended")));
}

TEST(Stream, ReadingNothingIsADeadlockThatNamesTheFifo) {
  Scheduler scheduler;
  Stream<int> a("a");
  std::vector<int> got;
  scheduler.launch("send", {&a}, [&] { send(a, 3); });
  scheduler.launch("receive", {&a}, [&] { receive(a, got, 4); });
  EXPECT_THAT(fault(scheduler),
              AllOf(HasSubstr("receive waits to read 'a' (empty, 0 of 2"), HasSubstr("send has ended")));
}

TEST(Stream, LeftoversAreAnError) {
  Scheduler scheduler;
  Stream<int> a("a");
  std::vector<int> got;
  scheduler.launch("send", {&a}, [&] { send(a, 3); });
  scheduler.launch("receive", {&a}, [&] { receive(a, got, 2); });
  EXPECT_THAT(fault(scheduler), AllOf(HasSubstr("left at the end"), HasSubstr("'a'"), HasSubstr("1 of 2")));
}

TEST(Stream, ACircleOfWaitsIsNamedAndNothingElse) {
  Scheduler scheduler;
  Stream<int> short_way("short_way");
  Stream<int> long_way("long_way");
  Stream<int> unrelated("unrelated");
  std::vector<int> got;
  scheduler.launch("bystander", {&unrelated}, [&] { receive(unrelated, got, 1); });
  scheduler.launch("fork", {&short_way, &long_way, &unrelated}, [&] {
    for (int i = 0; i < 8; ++i) {
      short_way.write(i);
      long_way.write(i);
    }
    unrelated.write(0);
  });
  scheduler.launch("join", {&short_way, &long_way}, [&] {
    for (int i = 0; i < 4; ++i) long_way.read();  // needs four words before it takes one of the other
    receive(short_way, got, 8);
  });
  const std::string message = fault(scheduler);
  EXPECT_THAT(message, AllOf(HasSubstr("fork waits to write 'short_way' (full"),
                             HasSubstr("join waits to read 'long_way' (empty")));
  EXPECT_EQ(message.find("bystander"), std::string::npos) << message;
}

TEST(Stream, SecondWriterAndThirdEndAreErrors) {
  {
    Scheduler scheduler;
    Stream<int> a("a");
    scheduler.launch("one", {}, [&] { a.write(1); });
    scheduler.launch("two", {}, [&] { a.write(2); });
    EXPECT_THAT(fault(scheduler), AllOf(HasSubstr("'a' has a second writer"), HasSubstr("one and two")));
  }
  Scheduler scheduler;
  Stream<int> a("a");
  scheduler.launch("one", {&a}, [] {});
  scheduler.launch("two", {&a}, [] {});
  EXPECT_THROW(scheduler.launch("three", {&a}, [] {}), NetworkError);
}

TEST(Stream, UseOutsideAStageIsAnError) {
  Stream<int> a("a");
  EXPECT_THROW(a.write(1), std::logic_error);
  Scheduler scheduler;
  EXPECT_THROW(a.write(1), std::logic_error);
}

TEST(Stream, AFaultOfAStageComesOutAndTheFifosAreGivenBack) {
  Stream<int> a("a");
  {
    Scheduler scheduler;
    scheduler.launch("send", {&a}, [&] { send(a, 10); });
    scheduler.launch("fails", {&a}, [&] {
      a.read();
      throw std::range_error("too much");
    });
    EXPECT_THROW(scheduler.run(), std::range_error);
  }
  Scheduler scheduler(4);
  std::vector<int> got;
  scheduler.launch("send", {&a}, [&] { send(a, 3); });
  scheduler.launch("receive", {&a}, [&] { receive(a, got, 3); });
  scheduler.run();
  EXPECT_THAT(got, ElementsAre(0, 1, 2));
}

// A region as in the kernels: a stage function called for two frames works on them one after the other.
void twice(Stream<int>& in, Stream<int>& out, int count) {
  for (int i = 0; i < count; ++i) out.write(2 * in.read());
}

void region(Stream<int>& in, Stream<int>& out, int count) {
  SAILMAP_STREAM(int, between);
  SAILMAP_STAGE((twice), in, between, count);
  SAILMAP_STAGE((pass), between, out, count);
}

TEST(Stream, StagesOfARegionTakeFrameAfterFrame) {
  Scheduler scheduler;
  Stream<int> a("a");
  Stream<int> b("b");
  std::vector<int> got;
  scheduler.launch("send", {&a}, [&] { send(a, 5); });
  region(a, b, 2);
  region(a, b, 3);
  scheduler.launch("receive", {&b}, [&] { receive(b, got, 5); });
  scheduler.run();
  EXPECT_THAT(got, ElementsAre(0, 2, 4, 6, 8));
  EXPECT_EQ(scheduler.high_water().count("between"), 1U);
}

}  // namespace
}  // namespace sailmap::csim
