#include "sailmap/image_source.hpp"

#include <sys/stat.h>

#include <system_error>
#include <utility>

#include "sailmap/error.hpp"
#include "text_lines.hpp"
#include "video_source.hpp"

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
  if (std::filesystem::exists(source, unknown)) return io::open_video(source);
  const std::optional<int> index = io::parse_integer(source);
  if (index && *index >= 0) return io::open_camera(*index);
  throw Error(source + ": no such folder, glob, list file, image, video or camera");
}

std::unique_ptr<ImageSource> open_images(std::vector<std::filesystem::path> paths) {
  return std::make_unique<ListedImages>(std::move(paths));
}

}  // namespace sailmap
