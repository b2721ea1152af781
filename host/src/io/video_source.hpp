// Videos and cameras, through OpenCV.
#pragma once

#include <memory>
#include <opencv2/videoio.hpp>
#include <string>

#include "sailmap/image_source.hpp"

namespace sailmap::io {

// Throw Error, naming the video or camera, when it gives no image.
std::unique_ptr<ImageSource> open_video(const std::string& file);
std::unique_ptr<ImageSource> open_camera(int index);

// What gives images without an end: when it gives no more, that is an error.
std::unique_ptr<ImageSource> camera(std::string name, cv::VideoCapture capture);

}  // namespace sailmap::io
