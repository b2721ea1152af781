#include <unistd.h>

#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <opencv2/imgcodecs.hpp>
#include <string>
#include <system_error>
#include <vector>

#include "sailmap/error.hpp"
#include "sailmap/file.hpp"
#include "world.hpp"

namespace sailmap {
namespace {

namespace fs = std::filesystem;

constexpr std::array<const char*, 5> entries = {"images", "ground_truth.txt", "poses.txt", "poses.csv",
                                                "simulation.json"};

void check_free(const fs::path& folder) {
  std::error_code ignored;
  for (const char* entry : entries)
    if (fs::exists(fs::symlink_status(folder / entry, ignored)))
      throw Error(folder.string() + ": holds a sequence already (" + entry + ")");
}

// Everything is written to a hidden folder inside `folder` and moved up when it is complete; if it never is,
// both are removed again as far as they were made here.
class Workshop {
 public:
  explicit Workshop(fs::path folder) : folder_(std::move(folder)) {
    std::error_code ignored;
    for (fs::path path = folder_; !path.empty() && !fs::exists(path, ignored); path = path.parent_path())
      made_.push_back(path);
    try {
      fs::remove_all(path(), ignored);  // of a run that was killed
      make_folder(path() / "images");
    } catch (...) {
      clean();
      throw;
    }
  }
  Workshop(const Workshop&) = delete;
  Workshop& operator=(const Workshop&) = delete;
  Workshop(Workshop&&) = delete;
  Workshop& operator=(Workshop&&) = delete;
  ~Workshop() { clean(); }

  [[nodiscard]] fs::path path() const { return folder_ / (".simulation.part" + std::to_string(::getpid())); }

  void deliver() {
    std::error_code failed;
    for (std::size_t i = 0; i < entries.size() && !failed; ++i) {
      fs::rename(path() / entries[i], folder_ / entries[i], failed);
      if (failed) {
        std::error_code ignored;
        for (std::size_t moved = 0; moved < i; ++moved) fs::remove_all(folder_ / entries[moved], ignored);
      }
    }
    if (failed) throw Error(folder_.string() + ": cannot be written: " + failed.message());
    made_.clear();
  }

 private:
  void clean() const {
    std::error_code ignored;
    fs::remove_all(path(), ignored);
    for (const fs::path& folder : made_) fs::remove(folder, ignored);  // only when empty
  }

  fs::path folder_;
  std::vector<fs::path> made_;  // the innermost first
};

// The shortest decimal that reads back as the same number.
std::string exact(double value) {
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
  return {text.data(), end};
}

void write_image(const fs::path& path, const cv::Mat& image) {
  std::vector<uchar> bytes;
  if (!cv::imencode(".png", image, bytes)) throw Error(path.string() + ": cannot be encoded as PNG");
  write_file(path, [&](std::ostream& out) { out << std::string(bytes.begin(), bytes.end()); });
}

std::string image_name(int index) {
  std::array<char, 24> name{};
  std::snprintf(name.data(), name.size(), "%06d.png", index);
  return name.data();
}

// Of the axes x forward, y left, z up: heading about z, then pitch (up) about y, then roll (clockwise) about
// x.
std::string quaternion(const simulate::CameraPose& pose) {
  const double cy = std::cos(pose.heading / 2);
  const double sy = std::sin(pose.heading / 2);
  const double cp = std::cos(-pose.pitch / 2);
  const double sp = std::sin(-pose.pitch / 2);
  const double cr = std::cos(pose.roll / 2);
  const double sr = std::sin(pose.roll / 2);
  return exact(sr * cp * cy - cr * sp * sy) + ' ' + exact(cr * sp * cy + sr * cp * sy) + ' ' +
         exact(cr * cp * sy - sr * sp * cy) + ' ' + exact(cr * cp * cy + sr * sp * sy);
}

void write_poses(const fs::path& folder, const simulate::Drive& drive, int images) {
  write_file(folder / "poses.txt", [&](std::ostream& out) {
    out << "# time x y z qx qy qz qw: seconds, metres; camera axes x forward, y left, z up\n";
    for (int i = 0; i < images; ++i) {
      const simulate::CameraPose p = drive.pose(i);
      out << exact(simulate::seconds_per_image * i) << ' ' << exact(p.x) << ' ' << exact(p.y) << ' '
          << exact(p.z) << ' ' << quaternion(p) << '\n';
    }
  });
  write_file(folder / "poses.csv", [&](std::ostream& out) {
    out << "x,y,heading\n";
    for (int i = 0; i < images; ++i) {
      const simulate::CameraPose p = drive.pose(i);
      out << exact(p.x) << ',' << exact(p.y) << ',' << exact(p.heading) << '\n';
    }
  });
}

void write_ground_truth(const fs::path& path, const GroundTruth& truth) {
  write_file(path, [&](std::ostream& out) {
    for (std::size_t query = 0; query < truth.matches.size(); ++query) {
      out << std::to_string(query) << ':';
      for (const int match : truth.matches[query]) out << ' ' << std::to_string(match);
      out << '\n';
    }
  });
}

void write_parameters(const fs::path& path, const SimulationConfig& config, const simulate::Drive& drive) {
  nlohmann::ordered_json json;
  json["images"] = config.images;
  json["seed"] = config.seed;
  json["width"] = config.width;
  json["height"] = config.height;
  json["images_per_lap"] = config.images_per_lap;
  json["jitter"] = config.jitter;
  json["lighting"] = config.lighting;
  json["moving_objects"] = config.moving_objects;
  json["match_radius"] = config.match_radius;
  json["textures"] = config.textures.string();
  json["circuit_metres"] = drive.route().length();
  json["spacing_metres"] = drive.spacing();
  json["seconds_per_image"] = simulate::seconds_per_image;
  json["focal_length_pixels"] = focal_length(config);
  write_file(path, [&](std::ostream& out) {
    out << json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) << '\n';
  });
}

}  // namespace

void write_simulation(const fs::path& folder, const SimulationConfig& config,
                      const std::function<void(int done)>& progress) {
  const Simulator simulator(config);
  const simulate::Drive drive(config);
  check_free(folder);
  Workshop workshop(folder);
  for (int i = 0; i < config.images; ++i) {
    write_image(workshop.path() / "images" / image_name(i), simulator.render(i));
    if (progress) progress(i + 1);
  }
  write_ground_truth(workshop.path() / "ground_truth.txt", simulator.ground_truth());
  write_poses(workshop.path(), drive, config.images);
  write_parameters(workshop.path() / "simulation.json", config, drive);
  workshop.deliver();
}

}  // namespace sailmap
