// Maps on disk: one SQLite file a map (docs/map_file.md). A map is read and written whole, or grows by one
// image after the other while the robot is under way.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "sailmap/topological_map.hpp"

namespace sailmap {

// A map and what it was made with.
struct StoredMap {
  TopologicalMap map;
  std::string frontend;
};

// What is kept of an image beside what the map knows of it.
struct ImageNote {
  std::optional<double> time;            // when it was taken, seconds since 1970
  std::vector<unsigned char> thumbnail;  // a JPEG; empty: none
};

// An image of the file as it was added.
struct StoredImage {
  int image = 0;
  std::string name;
  std::optional<double> time;
  // Of every image that was added one by one, of others where the image stands for a node.
  std::optional<Signature> signature;
  std::vector<unsigned char> thumbnail;  // a JPEG; empty: none
};

// What a map was made with.
struct Making {
  MapConfig config;
  std::string frontend;
};

// One run over one source.
struct Session {
  std::string source;
  double started = 0;   // seconds since 1970
  int first_image = 0;  // number of its first image in the map
  int images = 0;
  int skipped = 0;     // images that could not be read
  double seconds = 0;  // how long it took
};

// All of it may run while another program writes; it then sees what was committed. Every function throws
// Error, naming the file and the fault.
class MapStore {
 public:
  explicit MapStore(std::filesystem::path path) : path_(std::move(path)) {}

  [[nodiscard]] bool exists() const;  // an empty file does not count
  [[nodiscard]] StoredMap load() const;
  // Without reading the rest.
  [[nodiscard]] Making made_with() const;
  // Replaces the file whole or not at all; refused while another program writes to it.
  void save(const TopologicalMap& map, const std::string& frontend) const;
  // Of one image; empty when there is none.
  [[nodiscard]] std::vector<unsigned char> thumbnail(int image) const;
  [[nodiscard]] std::vector<Session> sessions() const;
  // In the order of the map.
  void for_each_image(const std::function<void(StoredImage)>& use) const;

 private:
  std::filesystem::path path_;
};

// Adds images to the file of a map: the only one that may, as long as it lives. What was committed stays,
// whatever becomes of program and machine.
class MapWriter {
 public:
  // The file is made when there is none. Throws Error, as all functions here, naming the file and the fault.
  explicit MapWriter(const std::filesystem::path& path);
  MapWriter(const MapWriter&) = delete;
  MapWriter& operator=(const MapWriter&) = delete;
  MapWriter(MapWriter&&) = delete;
  MapWriter& operator=(MapWriter&&) = delete;
  // What was not committed is lost. A file to which nothing was ever committed is removed.
  ~MapWriter();

  // The map as it is in the file; nothing in a new one.
  [[nodiscard]] std::optional<StoredMap> load() const;
  // Before the first image: `stored` is the map as it is before it, with its session begun, if it is to be a
  // new one.
  void begin_session(const StoredMap& stored, const std::string& source);
  // Goes on with the last session of a map that was not new.
  void resume_session(const StoredMap& stored);
  // The last image of `map`, just added to it.
  void append(const TopologicalMap& map, const Signature& signature, const ImageNote& note);
  // Images that could not be read, and the time taken, for the session's row.
  void note_session(int skipped, double seconds);
  // Returns when all that was appended is on the disk. After a failure, here or in append(), the file stays
  // as it was at the last commit, and nothing more is written.
  void commit();
  // Images of the map that are in the file.
  [[nodiscard]] int committed() const;
  // Commits, and leaves one plain file without a log beside it.
  void finish();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace sailmap
