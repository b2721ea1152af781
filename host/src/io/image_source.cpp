#include "sailmap/image_source.hpp"

#include <stdlib.h>  // NOLINT(modernize-deprecated-headers): setenv is POSIX

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

class ListedImages final : public ImageSource {
 public:
  explicit ListedImages(std::vector<std::filesystem::path> paths) : paths_(std::move(paths)) {}

  std::optional<Frame> next() override {
    if (next_ == paths_.size()) return std::nullopt;
    const std::filesystem::path& path = paths_[next_++];
    return Frame{path.string(), read_image(path)};
  }
  std::optional<PendingFrame> next_pending() override {
    if (next_ == paths_.size()) return std::nullopt;
    const std::filesystem::path& path = paths_[next_++];
    return PendingFrame{path.string(), [path] { return read_image(path); }};
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

// A video file or a camera. How long a video is cannot be known: the number in its header is a guess, and
// wrong when the file is cut short.
class Video final : public ImageSource {
 public:
  // Reads the first frame here, because FFmpeg opens much that is no video. Throws Error with `fault` when
  // there is none.
  Video(std::string name, const cv::VideoCapture& capture, const std::string& fault)
      : name_(std::move(name)), capture_(capture), first_(read()) {
    if (first_.empty()) throw Error(name_ + ": " + fault);
  }

  std::optional<Frame> next() override {
    cv::Mat image = first_.empty() ? read() : std::exchange(first_, {});
    if (image.empty()) return std::nullopt;
    return Frame{name_ + "#" + std::to_string(count_++), std::move(image)};
  }
  [[nodiscard]] std::optional<int> size() const override { return std::nullopt; }

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

std::unique_ptr<ImageSource> open_video(const std::string& file) {
  silence_video_libraries();
  // FFmpeg alone: OpenCV's other readers print what they think of a broken file.
  return std::make_unique<Video>(file, cv::VideoCapture(file, cv::CAP_FFMPEG),
                                 "neither an image source nor a video that can be read");
}

std::unique_ptr<ImageSource> open_camera(int index) {
  silence_video_libraries();
  return std::make_unique<Video>("camera " + std::to_string(index), cv::VideoCapture(index, cv::CAP_V4L2),
                                 "no such camera, or it gives no image");
}

}  // namespace

std::optional<PendingFrame> ImageSource::next_pending() {
  std::optional<Frame> frame = next();
  if (!frame) return std::nullopt;
  return PendingFrame{std::move(frame->name), [image = std::move(frame->image)] { return image; }};
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
