// Map files: what is saved comes back, what is appended is the same, and other files are refused.
#include "sailmap/map_store.hpp"

#include <gmock/gmock.h>
#include <sqlite3.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "host/map_builders.hpp"
#include "map/map_json.hpp"
#include "sailmap/error.hpp"
#include "sql.hpp"
#include "temporary_folder.hpp"

namespace sailmap {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

class MapStoreTest : public ::testing::Test {
 protected:
  std::string fault() const {
    try {
      static_cast<void>(MapStore(path_).load());
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  }
  std::vector<std::string> files() const {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder_.path())) names.push_back(entry.path().filename());
    return names;
  }

  testing::TemporaryFolder folder_{testing::memory_folder()};
  fs::path path_ = folder_.path() / "map.sailmap";
};

MapConfig unusual_config() {
  MapConfig config = testing::small_map_config();
  config.sparse = true;
  config.regions.inhibition = Inhibition::gaussian;
  config.regions.descriptor = DescriptorKind::background;
  config.match.method = Method::paper;
  config.detection.threshold = 12.5;
  return config;
}

TEST_F(MapStoreTest, WhatIsSavedComesBack) {
  const TopologicalMap map = testing::map_of({0, 1, 1, 2, 3, 0, 4}, unusual_config());
  const MapStore store(path_);
  EXPECT_FALSE(store.exists());
  store.save(map, "reference");
  EXPECT_TRUE(store.exists());
  const StoredMap loaded = store.load();
  EXPECT_EQ(loaded.frontend, "reference");
  EXPECT_EQ(to_json(loaded.map), to_json(map));
  EXPECT_EQ(loaded.map.sessions(), map.sessions());
  EXPECT_THAT(files(), ::testing::ElementsAre("map.sailmap"));
}

TEST_F(MapStoreTest, ASecondSaveReplacesTheFirst) {
  const MapStore store(path_);
  store.save(testing::map_of({0, 1, 2}), "reference");
  store.save(testing::map_of({3, 4}), "fixed");
  EXPECT_EQ(store.load().map.images(), 2);
  EXPECT_EQ(store.load().frontend, "fixed");
  EXPECT_THAT(files(), ::testing::ElementsAre("map.sailmap"));
}

TEST_F(MapStoreTest, AMapGoesOnAfterLoadingAsIfItHadNeverStopped) {
  const MapStore store(path_);
  store.save(testing::map_of({0, 1, 2, 3}), "reference");
  TopologicalMap loaded = store.load().map;
  loaded.add("image4", testing::image_of_place(1));
  EXPECT_EQ(loaded.edges(), testing::map_of({0, 1, 2, 3, 1}).edges());
}

TEST_F(MapStoreTest, PlacesOfTheMethodContextComeBack) {
  PlaceDescriptor place;
  place.layout.words[3] = {0x123456789ABCDEFU, 0xFEDCBA9876543210U};
  place.regions.push_back({65535, 7, 0x3FF, {}});
  place.regions.back().bits[9] = 0x8000000000000001U;
  Signature signature = testing::image_of_place(1);
  signature.place = place;
  TopologicalMap map(testing::small_map_config());
  map.add("one", signature);
  MapStore(path_).save(map, "fixed");
  const StoredMap loaded = MapStore(path_).load();
  EXPECT_EQ(loaded.map.nodes()[0].views[0].signature, signature);
}

TEST_F(MapStoreTest, NamesMayHoldAnyBytes) {
  const std::string name("a\nb'\xFF;\"\0c", 9);
  TopologicalMap map(testing::small_map_config());
  map.add(name, testing::image_of_place(1));
  MapStore(path_).save(map, "fixed");
  EXPECT_EQ(MapStore(path_).load().map.history()[0].name, name);
}

TEST_F(MapStoreTest, ForeignDatabasesAreRefused) {
  testing::run_sql(path_, "CREATE TABLE image (id INTEGER PRIMARY KEY)");
  EXPECT_THAT(fault(), HasSubstr("map.sailmap: not a sailmap map"));
  EXPECT_THROW(MapWriter writer(path_), Error);
}

TEST_F(MapStoreTest, NewerVersionsOtherTablesAndTriggersAreRefused) {
  MapStore(path_).save(testing::map_of({0, 1}), "fixed");
  testing::run_sql(path_, "PRAGMA user_version = 7");
  EXPECT_THAT(fault(), HasSubstr("map format version 7, this program reads versions 1 to 2"));
  testing::run_sql(
      path_, "PRAGMA user_version = 2; CREATE TRIGGER t AFTER INSERT ON image BEGIN DELETE FROM node; END");
  EXPECT_THAT(fault(), HasSubstr("its tables are others"));
}

// A change behind the program's back, and what is said of it.
struct Damage {
  const char* sql;
  const char* fault;
};

TEST_F(MapStoreTest, RowsThatWereChangedOrLostAreFound) {
  const Damage damages[] = {
      {"UPDATE image SET name = 'other' WHERE id = 2", "row 2 of table image is damaged"},
      {"UPDATE signature SET regions = zeroblob(48) WHERE id = 1", "row 1 of table signature is damaged"},
      {"UPDATE detection SET best_similarity = 99 WHERE id = 4", "row 4 of table detection is damaged"},
      {"UPDATE map SET frontend = 'reference'", "row 0 of table map is damaged"},
      {"DELETE FROM image WHERE id = 2", "table image lacks row 2"},
      {"DELETE FROM image WHERE id = 4", "a detection of an image that was never added"},
      {"DELETE FROM detection WHERE id = 4", "table detection lacks row 4"},
      {"DELETE FROM signature WHERE id = 1", "node 1 has no image"},
      {"DELETE FROM node WHERE id = 3", "belongs to no node"},
      {"DELETE FROM map", "its parameters are lost"},
  };
  for (const Damage& damage : damages) {
    MapStore(path_).save(testing::map_of({0, 1, 2, 3, 0}), "fixed");
    testing::run_sql(path_, damage.sql);
    EXPECT_THAT(fault(), HasSubstr(damage.fault)) << damage.sql;
    EXPECT_THAT(fault(), ::testing::StartsWith(path_.string() + ": ")) << damage.sql;
  }
}

TEST_F(MapStoreTest, APathThatNoFileCanHaveDoesNotExist) {
  const MapStore store(folder_.path() / std::string(300, 'x'));
  EXPECT_FALSE(store.exists());
  EXPECT_THROW((void)store.load(), Error);
}

TEST_F(MapStoreTest, AFolderThatCannotBeWrittenLeavesNothing) {
  const fs::path missing = folder_.path() / "missing" / "map.sailmap";
  EXPECT_THROW(MapStore(missing).save(testing::map_of({0}), "reference"), Error);
  EXPECT_THROW(MapWriter writer(missing), Error);
  EXPECT_FALSE(fs::exists(missing.parent_path()));
  EXPECT_THROW((void)MapStore(folder_.path()).load(), Error);
}

}  // namespace
}  // namespace sailmap
