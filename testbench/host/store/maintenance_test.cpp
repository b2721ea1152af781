// Damaged map files: what is wrong with one is found, and what can be read is rescued.
#include <gmock/gmock.h>

#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <random>

#include "host/map_builders.hpp"
#include "map/map_json.hpp"
#include "sailmap/error.hpp"
#include "sailmap/map_maintenance.hpp"
#include "sailmap/map_store.hpp"
#include "sql.hpp"
#include "temporary_folder.hpp"

namespace sailmap {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
constexpr double no_joining = std::numeric_limits<double>::infinity();

class MaintenanceTest : public ::testing::Test {
 protected:
  // A session over images of these places.
  static void run(const fs::path& path, const std::vector<int>& places) {
    MapWriter writer(path);
    StoredMap stored =
        writer.load().value_or(StoredMap{TopologicalMap(testing::small_map_config()), "fixed"});
    stored.map.begin_session();
    writer.begin_session(stored, "source");
    for (const int place : places) {
      const Signature signature = testing::image_of_place(place);
      stored.map.add("image" + std::to_string(stored.map.images()), signature);
      writer.append(stored.map, signature, {1.5, {1, 2, 3}});
    }
    writer.finish();
  }
  // Large enough for tables of several pages: 600 new places, and 60 of them again.
  void make_large_map() const {
    std::vector<int> places;
    for (int i = 0; i < 600; ++i) places.push_back(i);
    for (int i = 0; i < 600; i += 10) places.push_back(i);
    run(path_, places);
  }

  testing::TemporaryFolder folder_{testing::memory_folder()};
  fs::path path_ = folder_.path() / "map.sailmap";
  fs::path out_ = folder_.path() / "out.sailmap";
};

TEST_F(MaintenanceTest, ASoundMapHasNoFaultAndIsRecoveredWhole) {
  run(path_, {0, 1, 2, 3, 0, 1});
  run(path_, {2, 7});
  const MapCheck check = check_map(path_);
  EXPECT_TRUE(check.faults.empty());
  EXPECT_EQ(check.images, 8);
  EXPECT_EQ(check.nodes, 5);
  const MapRecovery recovery = recover_map(path_, out_);
  EXPECT_EQ(recovery.lost_rows, 0);
  EXPECT_EQ(to_json(MapStore(out_).load().map), to_json(MapStore(path_).load().map));
  EXPECT_EQ(MapStore(out_).load().map.sessions(), MapStore(path_).load().map.sessions());
  EXPECT_EQ(MapStore(out_).thumbnail(7).size(), 3U);
}

TEST_F(MaintenanceTest, EveryDamagedRowIsNamed) {
  run(path_, {0, 1, 2, 3, 0});
  testing::run_sql(path_,
                   "UPDATE image SET name = 'x' WHERE id = 1; UPDATE edge SET to_node = 3 WHERE id = 0;"
                   "UPDATE signature SET width = 7 WHERE id = 2");
  EXPECT_THAT(
      check_map(path_).faults,
      ::testing::UnorderedElementsAre("row 1 of table image is damaged", "row 0 of table edge is damaged",
                                      "row 2 of table signature is damaged"));
}

TEST_F(MaintenanceTest, ContradictionsWithRightChecksumsAreFound) {
  run(path_, {0, 1, 2});
  testing::run_sql(path_, "DELETE FROM node WHERE id = 2");
  EXPECT_THAT(check_map(path_).faults, ::testing::ElementsAre(HasSubstr("belongs to no node")));
}

TEST_F(MaintenanceTest, RecoveryGoesRoundLostRows) {
  run(path_, {0, 1, 2, 3, 4, 1});
  testing::run_sql(path_, "DELETE FROM image WHERE id = 2; UPDATE signature SET width = 1 WHERE id = 1");
  const MapRecovery recovery = recover_map(path_, out_);
  EXPECT_EQ(recovery.lost_rows, 2);
  EXPECT_TRUE(check_map(out_).faults.empty());
  const TopologicalMap map = MapStore(out_).load().map;
  // Image 1 has lost its signature; image 5, which closed a loop with its node, stands for it now.
  std::vector<std::string> names;
  for (const Update& update : map.history()) names.push_back(update.name);
  EXPECT_THAT(names, ::testing::ElementsAre("image0", "image1", "image3", "image4", "image5"));
  ASSERT_EQ(map.nodes().size(), 4U);
  EXPECT_EQ(map.nodes()[3].views[0].name, "image5");
  EXPECT_EQ(map.history()[4].node, 3);
  EXPECT_TRUE(map.history()[4].detection.accepted());
}

// What the file says may not change without a word, and what is recovered is sound.
TEST_F(MaintenanceTest, FlippedBytesAreFoundAndTheRestIsRecovered) {
  make_large_map();
  const std::string good = testing::content_of(path_);
  const auto whole = to_json(MapStore(path_).load().map);
  std::mt19937 random(5);
  int found = 0;
  for (int flip = 0; flip < 60; ++flip) {
    std::string bytes = good;
    // The first of them in the header.
    const std::size_t at = flip < 20 ? random() % 100 : random() % bytes.size();
    bytes[at] = static_cast<char>(bytes[at] ^ (1 + random() % 255));
    std::ofstream(path_, std::ios::binary) << bytes;
    const MapCheck check = check_map(path_);
    if (check.faults.empty()) {
      EXPECT_EQ(to_json(MapStore(path_).load().map), whole) << "byte " << at;
      continue;
    }
    ++found;
    fs::remove(out_);
    const MapRecovery recovery = recover_map(path_, out_);
    EXPECT_TRUE(check_map(out_).faults.empty()) << "byte " << at;
    // A damaged row or page, not the map.
    EXPECT_GE(recovery.images, 400) << "byte " << at << ": " << check.faults.front();
  }
  EXPECT_GE(found, 20);
}

TEST_F(MaintenanceTest, OfATruncatedFileTheBeginningIsRecovered) {
  make_large_map();
  const std::string good = testing::content_of(path_);
  int before = -1;
  for (const int percent : {30, 70, 95}) {
    std::ofstream(path_, std::ios::binary)
        << good.substr(0, good.size() * static_cast<std::size_t>(percent) / 100);
    EXPECT_THROW((void)MapStore(path_).load(), Error);
    EXPECT_FALSE(check_map(path_).faults.empty());
    fs::remove(out_);
    const MapRecovery recovery = recover_map(path_, out_);
    EXPECT_TRUE(check_map(out_).faults.empty());
    EXPECT_GE(recovery.nodes, before);
    before = recovery.nodes;
  }
  EXPECT_GT(before, 300);
}

TEST_F(MaintenanceTest, WhatIsNoMapCannotBeRecoveredAndNothingIsOverwritten) {
  std::ofstream(path_) << std::string(50000, 'x');
  EXPECT_THAT([&] { recover_map(path_, out_); },
              ::testing::ThrowsMessage<Error>(HasSubstr("map.sailmap: the parameters of the map are lost")));
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_.path()), {}), 1) << "no working copies stay";
  EXPECT_THROW(recover_map(folder_.path() / "gone", out_), Error);
  run(out_, {0});
  EXPECT_THAT([&] { recover_map(path_, out_); },
              ::testing::ThrowsMessage<Error>(HasSubstr("exists already")));
}

TEST_F(MaintenanceTest, MergingFindsThePlacesOfTheOneInTheOther) {
  run(path_, {0, 1, 2, 3});
  const fs::path other = folder_.path() / "other.sailmap";
  run(other, {8, 9, 10, 2, 3, 8});
  const MapMerge merge = merge_maps(path_, other, out_);
  EXPECT_EQ(merge.images, 6);
  EXPECT_EQ(merge.loops_across, 2);
  EXPECT_EQ(merge.left_out, 0);
  EXPECT_TRUE(check_map(out_).faults.empty());
  // As if the images had been run on the first map.
  run(path_, {8, 9, 10, 2, 3, 8});
  const TopologicalMap merged = MapStore(out_).load().map;
  EXPECT_EQ(merged.edges(), MapStore(path_).load().map.edges());
  EXPECT_EQ(merged.sessions(), MapStore(path_).load().map.sessions());
}

TEST_F(MaintenanceTest, MapsOfOtherParametersAreNotMerged) {
  run(path_, {0, 1});
  MapConfig config = testing::small_map_config();
  config.detection.threshold = 7;
  const fs::path other = folder_.path() / "other.sailmap";
  MapStore(other).save(testing::map_of({0, 1}, config), "csim");
  EXPECT_THAT([&] { merge_maps(path_, other, out_); },
              ::testing::ThrowsMessage<Error>(
                  HasSubstr("made with different parameters: detection.threshold (20.0 and 7.0), frontend "
                            "(\"fixed\" and \"csim\")")));
  EXPECT_FALSE(fs::exists(out_));
}

TEST_F(MaintenanceTest, PruningJoinsSimilarNeighbours) {
  // Places 1 and 2 look alike: the first of recent images, which are not compared.
  run(path_, {0, 1, 1, 2, 3});
  ASSERT_EQ(MapStore(path_).load().map.nodes().size(), 5U);
  const MapPruning pruning = prune_map(path_, out_, {1000, 0});
  EXPECT_EQ(pruning.joined, 1);
  EXPECT_EQ(pruning.nodes, 4);
  EXPECT_TRUE(check_map(out_).faults.empty());
  const TopologicalMap map = MapStore(out_).load().map;
  EXPECT_EQ(map.images(), 5);
  EXPECT_EQ(map.history()[2].node, 1);
  const std::vector<Edge> edges = {{0, 1}, {1, 2}, {2, 3}};
  EXPECT_EQ(map.edges(), edges);
}

TEST_F(MaintenanceTest, PruningDropsWhatWasNotVisitedLately) {
  run(path_, {0, 1, 2, 3});
  run(path_, {2, 3, 4});
  const MapPruning pruning = prune_map(path_, path_, {no_joining, 1});
  EXPECT_EQ(pruning.dropped, 2);
  EXPECT_EQ(pruning.nodes, 3);
  EXPECT_TRUE(check_map(path_).faults.empty());
  const TopologicalMap map = MapStore(path_).load().map;
  EXPECT_THAT(map.sessions(), ::testing::ElementsAre(0, 2));
  EXPECT_EQ(map.history()[2].node, 0) << "the place 2 of before is still known";
  EXPECT_TRUE(map.history()[2].detection.accepted());
}

}  // namespace
}  // namespace sailmap
