#include "video_source.hpp"

#include <stdlib.h>  // NOLINT(modernize-deprecated-headers): setenv is POSIX

#include <chrono>
#include <opencv2/core.hpp>
#include <opencv2/core/utils/logger.hpp>
#include <opencv2/imgproc.hpp>
#include <utility>

#include "sailmap/error.hpp"

namespace sailmap::io {
namespace {

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
  Camera(std::string name, cv::VideoCapture capture)
      : capture_(std::move(name), std::move(capture), "no such camera, or it gives no image") {}

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

}  // namespace

std::unique_ptr<ImageSource> open_video(const std::string& file) {
  silence_video_libraries();
  return std::make_unique<Video>(file);
}

std::unique_ptr<ImageSource> open_camera(int index) {
  silence_video_libraries();
  return camera("camera " + std::to_string(index), cv::VideoCapture(index, cv::CAP_V4L2));
}

std::unique_ptr<ImageSource> camera(std::string name, cv::VideoCapture capture) {
  return std::make_unique<Camera>(std::move(name), std::move(capture));
}

}  // namespace sailmap::io
