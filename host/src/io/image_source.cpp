#include "sailmap/image_source.hpp"

#include <stdlib.h>  // NOLINT(modernize-deprecated-headers): setenv is POSIX
#include <sys/stat.h>

#include <chrono>
#include <opencv2/core.hpp>
#include <opencv2/core/utils/logger.hpp>
#include <opencv2/imgproc.hpp>
#include <opencv2/videoio.hpp>
#include <system_error>
#include <utility>

#include "sailmap/error.hpp"
#include "text_lines.hpp"

namespace sailmap {

namespace {

std::optional<double> modification_time(const std::filesystem::path& path) {
  struct stat status {};
  if (::stat(path.c_str(), &status) != 0) return std::nullopt;
  return static_cast<double>(status.st_mtim.tv_sec) + 1e-9 * static_cast<double>(status.st_mtim.tv_nsec);
}

class ListedImages final : public ImageSource {
 public:
  explicit ListedImages(std::vector<std::filesystem::path> paths) : paths_(std::move(paths)) {}

  std::optional<Frame> next() override {
    if (next_ == paths_.size()) return std::nullopt;
    const std::filesystem::path& path = paths_[next_++];
    return Frame{path.string(), read_image(path), modification_time(path)};
  }
  std::optional<PendingFrame> next_pending() override {
    if (next_ == paths_.size()) return std::nullopt;
    const std::filesystem::path& path = paths_[next_++];
    return PendingFrame{path.string(), [path] { return read_image(path); }, modification_time(path)};
  }
  [[nodiscard]] std::optional<int> size() const override { return static_cast<int>(paths_.size()); }

 private:
  std::vector<std::filesystem::path> paths_;
  std::size_t next_ = 0;
};

// OpenCV and FFmpeg report broken videos on stderr, which belongs to the program. FFmpeg's level can be set
// through OpenCV by the environment alone; whoever sets it themselves, to look for a fault, has their way.
void silence_video_libraries() {
  static const bool done = [] {
    cv::utils::logging::setLogLevel(cv::utils::logging::LOG_LEVEL_SILENT);
    ::setenv("OPENCV_FFMPEG_LOGLEVEL", "-8", 0);
    return true;
  }();
  static_cast<void>(done);
}

cv::Mat to_bgr(const cv::Mat& image) {
  if (image.type() == CV_8UC3) return image.clone();  // the capture reuses its buffer
  cv::Mat bgr;
  if (image.type() == CV_8UC1) cv::cvtColor(image, bgr, cv::COLOR_GRAY2BGR);
  if (image.type() == CV_8UC4) cv::cvtColor(image, bgr, cv::COLOR_BGRA2BGR);
  return bgr;
}

// What FFmpeg or a camera driver gives, frame by frame.
class Capture {
 public:
  // Reads the first frame here, because FFmpeg opens much that is no video. Throws Error with `fault` when
  // there is none.
  Capture(std::string name, cv::VideoCapture capture, const std::string& fault)
      : name_(std::move(name)), capture_(std::move(capture)), first_(read()) {
    if (first_.empty()) throw Error(name_ + ": " + fault);
  }

  std::optional<Frame> next() {
    cv::Mat image = first_.empty() ? read() : std::exchange(first_, {});
    if (image.empty()) return std::nullopt;
    return Frame{name_ + "#" + std::to_string(count_++), std::move(image), {}};
  }
  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] int count() const { return count_; }
  // By the header of a video.
  [[nodiscard]] double claimed() const { return capture_.get(cv::CAP_PROP_FRAME_COUNT); }

 private:
  // Empty at the end; a frame that cannot be decoded is the end too.
  cv::Mat read() {
    try {
      cv::Mat frame;
      return capture_.isOpened() && capture_.read(frame) ? to_bgr(frame) : cv::Mat();
    } catch (const cv::Exception&) {
      return {};
    }
  }

  std::string name_;
  cv::VideoCapture capture_;
  cv::Mat first_;
  int count_ = 0;
};

// How long a video is cannot be known: the number in its header is a guess, and wrong when the file is cut
// short.
class Video final : public ImageSource {
 public:
  // FFmpeg alone: OpenCV's other readers print what they think of a broken file.
  explicit Video(const std::string& file)
      : capture_(file, cv::VideoCapture(file, cv::CAP_FFMPEG),
                 "neither an image source nor a video that can be read") {}

  std::optional<Frame> next() override { return capture_.next(); }
  [[nodiscard]] std::optional<int> size() const override { return std::nullopt; }
  [[nodiscard]] std::optional<std::string> early_end() const override {
    const double claimed = capture_.claimed();
    // FFmpeg reckons the number from length and rate in some formats, and is one off then.
    if (claimed - capture_.count() < 2) return std::nullopt;
    return capture_.name() + ": ends after " + std::to_string(capture_.count()) +
           " frames, its header says " + std::to_string(static_cast<long long>(claimed));
  }

 private:
  Capture capture_;
};

class Camera final : public ImageSource {
 public:
  explicit Camera(int index)
      : capture_("camera " + std::to_string(index), cv::VideoCapture(index, cv::CAP_V4L2),
                 "no such camera, or it gives no image") {}

  // A camera has no end: one that gives nothing was unplugged, or its driver failed.
  std::optional<Frame> next() override {
    std::optional<Frame> frame = capture_.next();
    if (!frame) {
      throw Error(capture_.name() + ": gives no more images after " + std::to_string(capture_.count()));
    }
    frame->time = std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch()).count();
    return frame;
  }
  [[nodiscard]] std::optional<int> size() const override { return std::nullopt; }

 private:
  Capture capture_;
};

std::unique_ptr<ImageSource> open_video(const std::string& file) {
  silence_video_libraries();
  return std::make_unique<Video>(file);
}

std::unique_ptr<ImageSource> open_camera(int index) {
  silence_video_libraries();
  return std::make_unique<Camera>(index);
}

}  // namespace

std::optional<PendingFrame> ImageSource::next_pending() {
  std::optional<Frame> frame = next();
  if (!frame) return std::nullopt;
  return PendingFrame{std::move(frame->name), [image = std::move(frame->image)] { return image; },
                      frame->time};
}

std::unique_ptr<ImageSource> open_source(const std::string& source) {
  if (is_image_list(source)) return open_images(list_images(source));
  std::error_code unknown;
  if (std::filesystem::exists(source, unknown)) return open_video(source);
  const std::optional<int> index = io::parse_integer(source);
  if (index && *index >= 0) return open_camera(*index);
  throw Error(source + ": no such folder, glob, list file, image, video or camera");
}

std::unique_ptr<ImageSource> open_images(std::vector<std::filesystem::path> paths) {
  return std::make_unique<ListedImages>(std::move(paths));
}

}  // namespace sailmap
