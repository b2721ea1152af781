// Nothing that was committed is ever lost: a process that writes a map file is killed, at every system call
// that changes a file and at random moments, and the file is opened, checked and continued.
#include <gmock/gmock.h>
#include <sqlite3.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <fstream>
#include <functional>
#include <limits>
#include <nlohmann/json.hpp>
#include <random>
#include <thread>

#include "host/map_builders.hpp"
#include "map/map_json.hpp"
#include "sailmap/error.hpp"
#include "sailmap/map_maintenance.hpp"
#include "sailmap/map_store.hpp"
#include "temporary_folder.hpp"

namespace sailmap {
namespace {

namespace fs = std::filesystem;

// The images of a way on which every third is a place seen before.
int place_of(int image) { return image % 3 == 2 ? image / 6 : 1000 + image; }

// What the child has told so far, in memory that both see.
class Told {
 public:
  Told() {
    if (::pipe(ends_) != 0) throw std::runtime_error("no pipe");
  }
  void say(int images) const { EXPECT_EQ(::write(ends_[1], &images, sizeof images), sizeof images); }
  // In the parent, after the child's end: the last number told, 0 when there was none.
  int last() {
    ::close(ends_[1]);
    int images = 0;
    int next = 0;
    while (::read(ends_[0], &next, sizeof next) == sizeof next) images = next;
    ::close(ends_[0]);
    return images;
  }

 private:
  int ends_[2] = {};
};

// Extends the map by `images`, telling how many images it has after each commit.
void write_images(const fs::path& path, int images, const Told& told) {
  MapWriter writer(path);
  StoredMap stored = writer.load().value_or(StoredMap{TopologicalMap(testing::small_map_config()), "fixed"});
  stored.map.begin_session();
  writer.begin_session(stored, "source");
  for (int i = 0; i < images; ++i) {
    const Signature signature = testing::image_of_place(place_of(stored.map.images()));
    stored.map.add("image" + std::to_string(stored.map.images()), signature);
    writer.append(stored.map, signature, {1.5, std::vector<unsigned char>(3000, 7)});
    if (i % 2 == 0) continue;
    writer.commit();
    told.say(stored.map.images());
  }
  writer.finish();
  told.say(stored.map.images());
}

// SQLite's own calls, counted; the process kills itself in the `fatal`-th.
int fatal = std::numeric_limits<int>::max();
int calls = 0;
bool is_fatal() { return ++calls == fatal; }
[[noreturn]] void die() {
  ::raise(SIGKILL);
  std::abort();
}

ssize_t write_or_die(int file, const void* bytes, size_t size, off_t at) {
  if (is_fatal()) {
    // Half of it is written.
    static_cast<void>(!::pwrite(file, bytes, size / 2, at));
    die();
  }
  return ::pwrite(file, bytes, size, at);
}
int truncate_or_die(int file, off_t size) {
  if (is_fatal()) die();
  return ::ftruncate(file, size);
}
int unlink_or_die(const char* path) {
  if (is_fatal()) die();
  return ::unlink(path);
}

void replace_system_calls() {
  sqlite3_vfs* vfs = ::sqlite3_vfs_find(nullptr);
  const auto replace = [&](const char* name, auto* function) {
    return vfs->xSetSystemCall(vfs, name, reinterpret_cast<sqlite3_syscall_ptr>(function));
  };
  if (replace("pwrite", &write_or_die) != SQLITE_OK || replace("ftruncate", &truncate_or_die) != SQLITE_OK ||
      replace("unlink", &unlink_or_die) != SQLITE_OK) {
    std::abort();
  }
  replace("pwrite64", &write_or_die);  // where there is one
}

// In a child, which the work ends or the `at`-th system call. Returns true when it was killed.
bool killed_at(int at, const std::function<void()>& work) {
  const pid_t child = ::fork();
  if (child == 0) {
    fatal = at;
    replace_system_calls();
    try {
      work();
    } catch (const Error& fault) {
      std::fprintf(stderr, "%s\n", fault.what());
      ::_exit(1);
    }
    ::_exit(0);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  EXPECT_TRUE(WIFSIGNALED(status) || WEXITSTATUS(status) == 0);
  return WIFSIGNALED(status);
}

class KillTest : public ::testing::Test {
 protected:
  // Sound, with at least so many images, and able to go on.
  void check(int least, const std::string& when) const {
    const MapStore store(path_);
    const auto images = [&] { return store.exists() ? check_map(path_).images : 0; };
    if (least > 0) {
      const MapCheck check = check_map(path_);
      ASSERT_THAT(check.faults, ::testing::IsEmpty()) << when;
      ASSERT_GE(check.images, least) << when;
    }
    const int before = least > 0 ? images() : 0;
    Told told;
    write_images(path_, 3, told);
    const MapCheck after = check_map(path_);
    ASSERT_THAT(after.faults, ::testing::IsEmpty()) << when;
    ASSERT_GE(after.images, before + 3) << when;
    ASSERT_EQ(told.last(), after.images) << when;
  }

  testing::TemporaryFolder folder_{testing::memory_folder()};
  fs::path path_ = folder_.path() / "map.sailmap";
};

// Making a file, appending with new nodes, loops and thumbnails, committing, and turning the log into one
// file.
TEST_F(KillTest, AtEveryWriteOfANewMap) {
  bool killed = true;
  int at = 0;
  for (at = 1; killed; ++at) {
    fs::remove_all(folder_.path());
    fs::create_directory(folder_.path());
    Told told;
    killed = killed_at(at, [&] { write_images(path_, 12, told); });
    check(told.last(), "killed at write " + std::to_string(at));
    if (HasFatalFailure()) return;
  }
  EXPECT_GT(at, 40) << "so many writes there are";
}

TEST_F(KillTest, AtEveryWriteOfALaterSession) {
  {
    Told told;
    write_images(path_, 20, told);
    EXPECT_EQ(told.last(), 20);
  }
  const std::string first = testing::content_of(path_);
  bool killed = true;
  for (int at = 1; killed; ++at) {
    std::ofstream(path_, std::ios::binary) << first;
    for (const char* ending : {"-wal", "-shm"}) fs::remove(path_.string() + ending);
    Told told;
    killed = killed_at(at, [&] { write_images(path_, 6, told); });
    check(std::max(20, told.last()), "killed at write " + std::to_string(at));
    if (HasFatalFailure()) return;
  }
}

// What replaces a file leaves the old or the new one.
void replace(const fs::path& path, const std::string& how) {
  if (how == "prune") {
    prune_map(path, path, {std::numeric_limits<double>::infinity(), 1});
  } else if (how == "save") {
    const StoredMap stored = MapStore(path).load();
    MapStore(path).save(stored.map, stored.frontend);
  } else {
    const MapWriter migrated(path);
  }
}

TEST_F(KillTest, AtEveryWriteOfAFileThatReplacesAnother) {
  const TopologicalMap map = testing::map_of({0, 1, 2, 3, 0, 4, 5, 6});
  const nlohmann::ordered_json json = {
      {"format", "sailmap map"}, {"version", 1}, {"frontend", "fixed"}, {"map", to_json(map)}};
  for (const std::string how : {"prune", "save", "migrate"}) {
    bool killed = true;
    for (int at = 1; killed; ++at) {
      fs::remove_all(folder_.path());
      fs::create_directory(folder_.path());
      if (how == "migrate") {
        std::ofstream(path_) << json.dump();
      } else {
        MapStore(path_).save(map, "fixed");
      }
      killed = killed_at(at, [&] { replace(path_, how); });
      check(8, how + " killed at write " + std::to_string(at));
      if (HasFatalFailure()) return;
    }
  }
}

TEST_F(KillTest, At200RandomMoments) {
  std::mt19937 random(7);
  for (int kill = 0; kill < 200; ++kill) {
    if (kill % 20 == 0) fs::remove(path_);  // from the beginning now and then
    const int before = MapStore(path_).exists() ? check_map(path_).images : 0;
    Told told;
    const pid_t child = ::fork();
    if (child == 0) {
      write_images(path_, 1 << 20, told);
      ::_exit(0);
    }
    std::this_thread::sleep_for(std::chrono::microseconds(random() % 30000));
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);
    check(std::max(before, told.last()), "kill " + std::to_string(kill));
    if (HasFatalFailure()) return;
  }
}

}  // namespace
}  // namespace sailmap
