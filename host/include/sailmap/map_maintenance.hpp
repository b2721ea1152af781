// What becomes of map files over the years: checked, rescued when damaged, joined, made smaller. Every
// function throws Error, naming the file and the fault.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace sailmap {

struct MapCheck {
  std::vector<std::string> faults;  // one line each; at most 100
  int images = 0;                   // that could be read
  int nodes = 0;
};

// Reads all of a file: its structure, the checksum of every row, and whether the parts fit together. Damage
// is in the result; Error is for a file that cannot be opened at all.
MapCheck check_map(const std::filesystem::path& path);

struct MapRecovery {
  int images = 0;  // recovered
  int nodes = 0;
  int lost_rows = 0;  // found damaged, or not found between others
};

// Makes a new file `to` of all that can be read in `from`, which stays as it is: images and nodes are
// numbered anew, and what leads to lost ones is dropped. `to` must not exist.
MapRecovery recover_map(const std::filesystem::path& from, const std::filesystem::path& to);

struct MapMerge {
  int images = 0;        // added from `b`
  int left_out = 0;      // of `b`, whose signatures its file does not hold
  int loops_across = 0;  // images of `b` found at nodes of `a`
};

// Makes a new file `to`: the map `a`, and then the images of `b`, session by session, as if they had been run
// on it. Both must be made with the same parameters and front end. `to` must not exist.
MapMerge merge_maps(const std::filesystem::path& a, const std::filesystem::path& b,
                    const std::filesystem::path& to);

struct PruneOptions {
  // A node at least so similar to the kept node before it on the way is joined with it; infinity: none. In
  // the scale of the map's method.
  double similar;
  int unvisited = 0;  // drop nodes that no image of the last so many sessions came to; 0: none
};

struct MapPruning {
  int nodes = 0;  // kept
  int joined = 0;
  int dropped = 0;
};

// Makes a new file `to` of less of the map `from`; both may be the same.
MapPruning prune_map(const std::filesystem::path& from, const std::filesystem::path& to,
                     const PruneOptions& options);

// The threshold that new images are judged by; everything else in the file stays. A JSON map becomes a
// database.
void set_threshold(const std::filesystem::path& path, double threshold);

}  // namespace sailmap
