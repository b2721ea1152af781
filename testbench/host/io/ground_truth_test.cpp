#include "sailmap/ground_truth.hpp"

#include <gmock/gmock.h>

#include <string>

#include "error_matchers.hpp"
#include "sailmap_data.hpp"
#include "temporary_folder.hpp"

namespace sailmap {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using testing::throws_naming;

class TextGroundTruth : public ::testing::Test {
 protected:
  [[nodiscard]] std::filesystem::path file(const std::string& content) const {
    return folder_.file("gt.txt", content);
  }

  testing::TemporaryFolder folder_;
};

TEST_F(TextGroundTruth, ReadsLinesInAnyOrder) {
  const auto truth = read_text_ground_truth(file("# truth\r\n3: 1 0\r\n\n2:0\n 0 :\n1:\t2 2 1\n"), 5, 3);
  EXPECT_THAT(truth.matches,
              ElementsAre(IsEmpty(), ElementsAre(1, 2), ElementsAre(0), ElementsAre(0, 1), IsEmpty()));
}

TEST_F(TextGroundTruth, NamesFileLineAndFault) {
  struct Case {
    const char *content, *line, *fault;
  };
  for (const Case& c :
       {Case{"0: 1\n5: 1\n", ":2", "query 5 does not exist: there are 5 images"},
        Case{"# x\n\n1: 0 3\n", ":3", "candidate 3 does not exist: there are 3 images"},
        Case{"1: 0\n1: 2\n", ":2", "query 1 a second time"}, Case{"1: 0\n2 0\n", ":2", "no colon"},
        Case{"1: 0 x\n", ":1", "not an image index: 'x'"},
        Case{"1: 0 1.5\n", ":1", "not an image index: '1.5'"},
        Case{"-1: 0\n", ":1", "not an image index: '-1'"}, Case{": 0\n", ":1", "not an image index: ''"},
        Case{"1: 99999999999999999999\n", ":1", "not an image index"},
        Case{"1: 2147483647\n", ":1", "not an image index"},
        Case{"1: a\rb\x1B\n", ":1", "not an image index: 'a'"},
        Case{"1: a\x1B\n", ":1", "not an image index: 'a?'"},
        Case{"1: 0: 2\n", ":1", "not an image index: '0:'"},
        Case{"# only a comment\n", "", "no ground truth"}}) {
    const auto path = file(c.content);
    EXPECT_THAT([&] { read_text_ground_truth(path, 5, 3); }, throws_naming(path.string() + c.line, c.fault));
  }
  const auto missing = folder_.path() / "missing.txt";
  EXPECT_THAT([&] { read_text_ground_truth(missing, 5, 3); }, throws_naming(missing, "no such file"));
}

TEST_F(TextGroundTruth, DropsTheDiagonalOfOneSequenceOnly) {
  const auto path = file("0: 0\n1: 0 1\n2: 2\n");
  GroundTruthOptions options{.queries = 3, .candidates = 3};
  EXPECT_THAT(read_ground_truth(path, options).matches, ElementsAre(IsEmpty(), ElementsAre(0), IsEmpty()));
  options.same_sequence = false;
  EXPECT_THAT(read_ground_truth(path, options).matches,
              ElementsAre(ElementsAre(0), ElementsAre(0, 1), ElementsAre(2)));
}

TEST_F(TextGroundTruth, OfBothCamerasIsTakenApart) {
  // Images 2k are left, 2k + 1 right.
  const auto path = file("4: 0 1 2\n5: 0 1 3\n");
  GroundTruthOptions options{.queries = 3, .candidates = 3, .oxford = true};
  EXPECT_THAT(read_ground_truth(path, options).matches, ElementsAre(IsEmpty(), IsEmpty(), ElementsAre(0, 1)));
  options.side = Side::right;
  EXPECT_THAT(read_ground_truth(path, options).matches, ElementsAre(IsEmpty(), IsEmpty(), ElementsAre(0, 1)));
  const auto one_sided = file("4: 0\n5: 0 2\n");
  EXPECT_THAT(read_ground_truth(one_sided, options).matches, ElementsAre(IsEmpty(), IsEmpty(), IsEmpty()));
  options.side = Side::left;
  EXPECT_THAT(read_ground_truth(one_sided, options).matches,
              ElementsAre(IsEmpty(), IsEmpty(), ElementsAre(0)));
}

TEST_F(TextGroundTruth, OfPairsIsTakenAsItIs) {
  const auto path = file("2: 0 1\n");
  const GroundTruthOptions options{.queries = 3, .candidates = 3, .oxford = true, .side = Side::right};
  EXPECT_THAT(read_ground_truth(path, options).matches, ElementsAre(IsEmpty(), IsEmpty(), ElementsAre(0, 1)));
}

TEST_F(TextGroundTruth, LargerThanBothCamerasIsAnError) {
  const auto path = file("6: 0\n");
  const GroundTruthOptions options{.queries = 3, .candidates = 3, .oxford = true};
  EXPECT_THAT([&] { read_ground_truth(path, options); },
              throws_naming(path.string() + ":1", "query 6 does not exist"));
}

TEST_F(TextGroundTruth, IsToldFromPoses) {
  EXPECT_FALSE(holds_poses(file("# poses?\n3: 1 2\n")));
  EXPECT_FALSE(holds_poses(file("0:\n")));
  EXPECT_TRUE(holds_poses(file("x,y\n1,2\n")));
  EXPECT_TRUE(holds_poses(file("time:ns,x,y\n0,1,2\n")));
  EXPECT_TRUE(holds_poses(file("# TUM\n1 2 3 4 0 0 0 1\n")));
  const auto empty = file("\n");
  EXPECT_THAT([&] { holds_poses(empty); }, throws_naming(empty, "neither matches nor poses"));
}

TEST(RealGroundTruth, OfTheCorridorIsTheLoop) {
  SAILMAP_NEEDS_DATA("rtabmap_corridor/ground_truth.txt");
  const auto truth = read_ground_truth(testing::data_folder() / "rtabmap_corridor/ground_truth.txt",
                                       {.queries = 84, .candidates = 84});
  // 228 pairs, 44 queries with a loop: the data set's own description.
  std::size_t pairs = 0;
  std::size_t loops = 0;
  for (const auto& matches : truth.matches) {
    pairs += matches.size();
    loops += matches.empty() ? 0 : 1;
  }
  EXPECT_EQ(pairs, 228U);
  EXPECT_EQ(loops, 44U);
  EXPECT_THAT(truth.matches[83], ElementsAre(2, 3, 4, 41, 42, 43, 44, 45));
}

TEST(RealGroundTruth, OfGardensPointIsTheSecondWalk) {
  SAILMAP_NEEDS_DATA("gardens_point/ground_truth.txt");
  const auto truth = read_ground_truth(testing::data_folder() / "gardens_point/ground_truth.txt",
                                       {.queries = 400, .candidates = 400});
  EXPECT_THAT(truth.matches[199], IsEmpty());
  EXPECT_THAT(truth.matches[200], ElementsAre(0, 1, 2));
  EXPECT_THAT(truth.matches[300], ElementsAre(98, 99, 100, 101, 102));
}

}  // namespace
}  // namespace sailmap
