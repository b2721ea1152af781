// Images from a folder, glob, list file, video or camera, one after the other.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <opencv2/core/mat.hpp>
#include <optional>
#include <string>
#include <vector>

#include "sailmap/ref/plane.hpp"

namespace sailmap {

struct Frame {
  std::string name;  // path of the image, or "video.mp4#17", or "camera 0#17"
  cv::Mat image;     // 8-bit BGR
  // When it was taken, seconds since 1970: the file's modification time, a camera's clock; of videos unknown.
  std::optional<double> time;
};

// An image not decoded yet.
struct PendingFrame {
  std::string name;
  std::function<cv::Mat()> read;  // 8-bit BGR; safe on any thread. Throws Error, naming the image.
  std::optional<double> time;     // as in Frame
};

class ImageSource {
 public:
  ImageSource() = default;
  ImageSource(const ImageSource&) = delete;
  ImageSource& operator=(const ImageSource&) = delete;
  ImageSource(ImageSource&&) = delete;
  ImageSource& operator=(ImageSource&&) = delete;
  virtual ~ImageSource() = default;
  // The next frame, or nothing at the end. Throws Error, naming the image, when one cannot be read, and when
  // a camera gives no more.
  virtual std::optional<Frame> next() = 0;
  // As next(), but the decoding is left to the caller where the source allows that, so that threads can share
  // it.
  virtual std::optional<PendingFrame> next_pending();
  // How many images there are in all, when known beforehand.
  [[nodiscard]] virtual std::optional<int> size() const = 0;
  // After the end: why it may have come too early, one line that names the source, or nothing. A video that
  // was cut off ends before the number of frames in its header, which is not always right.
  [[nodiscard]] virtual std::optional<std::string> early_end() const { return std::nullopt; }
};

// "2" before "10": digits compare as numbers, the rest as text.
bool natural_less(const std::string& a, const std::string& b);

// True when the extension is one of an image format that is read here.
bool is_image_path(const std::filesystem::path& path);

// The images of a folder (its image files, natural order), glob (natural order) or list file (.txt: one path
// a line, relative to the list's folder; blank lines and # comments skipped). Throws Error when there is no
// image, or a listed one does not exist.
std::vector<std::filesystem::path> list_images(const std::string& source);

// True when `source` is a folder, glob, list file or image, so that list_images takes it; false for a video
// or camera.
bool is_image_list(const std::string& source);

// Folder, glob, list file, one image, video file, or camera index ("0"). Throws Error when it is none of
// these.
std::unique_ptr<ImageSource> open_source(const std::string& source);

// The same, for images already listed.
std::unique_ptr<ImageSource> open_images(std::vector<std::filesystem::path> paths);

// An 8-bit BGR image; 16-bit, grey and alpha are converted. Throws Error naming the file when it is missing,
// empty, truncated, or no image.
cv::Mat read_image(const std::filesystem::path& path);

// The pixels of an 8-bit BGR image, which must outlive the view.
ImageView view_of(const cv::Mat& bgr);

}  // namespace sailmap
