// Adding to a map's file image by image: the same map as saving it whole, for one writer at a time, and
// readers beside it.
#include <gmock/gmock.h>

#include <cstdio>
#include <nlohmann/json.hpp>

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

// A run over images of these places.
void add(MapWriter& writer, StoredMap& stored, const std::vector<int>& places, const ImageNote& note = {}) {
  for (const int place : places) {
    const Signature signature = testing::image_of_place(place);
    stored.map.add("image" + std::to_string(stored.map.images()), signature);
    writer.append(stored.map, signature, note);
  }
}

class MapWriterTest : public ::testing::Test {
 protected:
  StoredMap new_map(MapConfig config = testing::small_map_config()) const {
    return {TopologicalMap(config), "fixed"};
  }
  // A new map, and the session that begins it.
  StoredMap begin(MapWriter& writer, const MapConfig& config = testing::small_map_config()) const {
    StoredMap stored = new_map(config);
    writer.begin_session(stored, "source");
    return stored;
  }
  void run(const std::vector<int>& places) const {
    MapWriter writer(path_);
    StoredMap stored = writer.load().value_or(new_map());
    stored.map.begin_session();
    writer.begin_session(stored, "source");
    add(writer, stored, places);
    writer.finish();
  }

  testing::TemporaryFolder folder_{testing::memory_folder()};
  fs::path path_ = folder_.path() / "map.sailmap";
};

TEST_F(MapWriterTest, AppendedIsAsSaved) {
  for (const bool sparse : {false, true}) {
    MapConfig config = testing::small_map_config();
    config.sparse = sparse;
    const std::vector<int> places = {0, 1, 1, 2, 3, 0, 4, 4, 2};
    fs::remove(path_);
    MapWriter writer(path_);
    StoredMap stored = begin(writer, config);
    add(writer, stored, places);
    writer.finish();
    const StoredMap loaded = MapStore(path_).load();
    EXPECT_EQ(loaded.frontend, "fixed");
    EXPECT_EQ(to_json(loaded.map), to_json(testing::map_of(places, config))) << sparse;
  }
}

TEST_F(MapWriterTest, ReadersSeeWhatWasCommittedAndNoMore) {
  MapWriter writer(path_);
  StoredMap stored = begin(writer);
  add(writer, stored, {0, 1});
  writer.commit();
  add(writer, stored, {2});
  EXPECT_EQ(MapStore(path_).load().map.images(), 2);
  writer.commit();
  EXPECT_EQ(MapStore(path_).load().map.images(), 3);
}

TEST_F(MapWriterTest, ASecondWriterIsRefusedUntilTheFirstIsGone) {
  {
    const MapWriter first(path_);
    EXPECT_THAT(
        [&] { MapWriter second(path_); },
        ::testing::ThrowsMessage<Error>(HasSubstr("map.sailmap: this program is writing this map already")));
    EXPECT_THROW(MapStore(path_).save(testing::map_of({0}), "fixed"), Error);
  }
  EXPECT_NO_THROW(MapWriter third(path_));
}

// What a program of its own says that tries to end the log, as the last connection to a file does.
std::string end_log(const fs::path& path) {
  const std::string command = "sqlite3 '" + path.string() + "' 'PRAGMA journal_mode = DELETE' 2>&1";
  FILE* program = ::popen(command.c_str(), "r");
  std::string said;
  for (int c = std::fgetc(program); c != EOF; c = std::fgetc(program)) said += static_cast<char>(c);
  ::pclose(program);
  return said;
}

// POSIX drops a process's locks on a file when it closes any descriptor of it: neither a look at the map nor
// a second writer may leave the first one's log to others.
TEST_F(MapWriterTest, NothingInThisProcessTakesTheWritersLocksAway) {
  MapWriter writer(path_);
  StoredMap stored = begin(writer);
  add(writer, stored, {0, 1});
  writer.commit();
  EXPECT_THAT(end_log(path_), HasSubstr("locked"));
  EXPECT_EQ(MapStore(path_).load().map.images(), 2);
  EXPECT_TRUE(MapStore(path_).exists());
  EXPECT_THAT(end_log(path_), HasSubstr("locked")) << "after reading";
  EXPECT_THROW(MapWriter second(path_), Error);
  EXPECT_THROW(MapStore(path_).save(testing::map_of({0}), "fixed"), Error);
  EXPECT_THROW(set_threshold(path_, 3), Error);
  EXPECT_THAT(end_log(path_), HasSubstr("locked")) << "after others tried to write";
  add(writer, stored, {2});
  writer.finish();
  EXPECT_EQ(MapStore(path_).load().map.images(), 3);
}

TEST_F(MapWriterTest, ANewFileWithoutAnImageIsRemoved) {
  { const MapWriter writer(path_); }
  EXPECT_TRUE(fs::is_empty(folder_.path()));
  {
    MapWriter writer(path_);
    StoredMap stored = begin(writer);
    add(writer, stored, {0});  // never committed
  }
  EXPECT_FALSE(MapStore(path_).exists()) << "not even a blank database";
}

TEST_F(MapWriterTest, FinishLeavesOneFile) {
  run({0, 1, 2});
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_.path()), {}), 1);
}

TEST_F(MapWriterTest, ANewSessionMayStartAnywhere) {
  run({0, 1, 2, 3});
  run({3, 4, 0});
  const StoredMap stored = MapStore(path_).load();
  EXPECT_THAT(stored.map.sessions(), ::testing::ElementsAre(0, 4));
  const auto& history = stored.map.history();
  // Recent, but of another session.
  EXPECT_TRUE(history[4].detection.accepted());
  EXPECT_EQ(history[4].node, 3);
  EXPECT_TRUE(history[6].detection.accepted());
  const std::vector<Edge> edges = {{0, 1}, {1, 2}, {2, 3}, {3, 4}, {4, 0, EdgeKind::loop}};
  EXPECT_EQ(stored.map.edges(), edges);
  const std::vector<Session> sessions = MapStore(path_).sessions();
  ASSERT_EQ(sessions.size(), 2U);
  EXPECT_EQ(sessions[1].source, "source");
  EXPECT_EQ(sessions[1].first_image, 4);
  EXPECT_EQ(sessions[1].images, 3);
}

TEST_F(MapWriterTest, ASessionThatBeginsAtAnUnknownPlaceHasNoEdgeToTheOneBefore) {
  run({0, 1});
  run({5, 6});
  const std::vector<Edge> edges = {{0, 1}, {2, 3}};
  EXPECT_EQ(MapStore(path_).load().map.edges(), edges);
}

TEST_F(MapWriterTest, AResumedSessionGoesOnAsIfItHadNeverStopped) {
  run({0, 1, 2});
  {
    MapWriter writer(path_);
    StoredMap stored = *writer.load();
    writer.resume_session(stored);
    add(writer, stored, {3, 0});
    writer.finish();
  }
  const StoredMap stored = MapStore(path_).load();
  EXPECT_EQ(to_json(stored.map), to_json(testing::map_of({0, 1, 2, 3, 0})));
  ASSERT_EQ(MapStore(path_).sessions().size(), 1U);
  EXPECT_EQ(MapStore(path_).sessions()[0].images, 5);
}

TEST_F(MapWriterTest, TimesThumbnailsAndEverySignatureAreKept) {
  {
    MapWriter writer(path_);
    StoredMap stored = begin(writer);
    add(writer, stored, {0, 1, 2, 3}, {1234.5, {0xFF, 0xD8}});
    add(writer, stored, {0});
    writer.finish();
  }
  std::vector<StoredImage> images;
  MapStore(path_).for_each_image([&](StoredImage image) { images.push_back(std::move(image)); });
  ASSERT_EQ(images.size(), 5U);
  EXPECT_EQ(images[0].time, 1234.5);
  EXPECT_FALSE(images[4].time);
  // It closed a loop, and so stands for no node of a dense map.
  EXPECT_EQ(images[4].signature, testing::image_of_place(0));
  EXPECT_THAT(MapStore(path_).thumbnail(2), ::testing::ElementsAre(0xFF, 0xD8));
  EXPECT_TRUE(MapStore(path_).thumbnail(4).empty());
}

TEST_F(MapWriterTest, TheTablesSayWhatTheirNamesSay) {
  run({0, 1, 2, 3, 1});
  EXPECT_EQ(testing::run_sql(path_, "SELECT count(*) FROM node"), "4");
  EXPECT_EQ(testing::run_sql(path_, "SELECT name FROM image WHERE id = 4"), "image4");
  EXPECT_EQ(testing::run_sql(path_, "SELECT reason || best_node FROM detection WHERE id = 4"), "accepted1");
  EXPECT_EQ(testing::run_sql(path_, "SELECT from_node || kind || to_node FROM edge ORDER BY id"), "3loop1");
  EXPECT_EQ(testing::run_sql(path_, "SELECT json_extract(parameters, '$.exclude_recent') FROM map"), "2");
  EXPECT_EQ(testing::run_sql(path_, "SELECT length(regions) FROM signature WHERE id = 0"), "144");
}

}  // namespace
}  // namespace sailmap
