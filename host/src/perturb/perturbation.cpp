#include "sailmap/perturbation.hpp"

#include <array>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <string>

#include "sailmap/error.hpp"

namespace sailmap {
namespace {

struct Entry {
  PerturbationKind kind;
  std::string_view name;
  std::string_view strength;
  double least, most;
};
constexpr std::array<Entry, 10> entries = {{
    {PerturbationKind::shift, "shift", "part of the width to the right, -0.9 .. 0.9", -0.9, 0.9},
    {PerturbationKind::crop, "crop", "part of each side's length cut away, the rest enlarged, 0 .. 0.9", 0,
     0.9},
    {PerturbationKind::rotate, "rotate", "degrees anticlockwise, -180 .. 180", -180, 180},
    {PerturbationKind::scale, "scale", "factor about the centre, 0.1 .. 10", 0.1, 10},
    {PerturbationKind::brightness, "brightness", "factor, 0 .. 10", 0, 10},
    {PerturbationKind::gamma, "gamma", "exponent, 0.1 .. 10; above 1 darkens", 0.1, 10},
    {PerturbationKind::noise, "noise", "standard deviation in grey levels, 0 .. 255", 0, 255},
    {PerturbationKind::blur, "blur", "standard deviation in parts of the width, 0 .. 0.1", 0, 0.1},
    {PerturbationKind::occlusion, "occlusion", "part of the area behind a grey box, 0 .. 1", 0, 1},
    {PerturbationKind::grey, "grey", "part of the colour taken away, 0 .. 1", 0, 1},
}};

const Entry& entry_of(PerturbationKind kind) {
  for (const Entry& entry : entries) {
    if (entry.kind == kind) return entry;
  }
  throw Error("unknown perturbation number " + std::to_string(static_cast<int>(kind)));
}

// The image seen through a turn and a scale about its centre, then moved to the right.
cv::Mat moved(const cv::Mat& image, double degrees, double scale, double right) {
  const double angle = degrees * CV_PI / 180;
  const double a = scale * std::cos(angle);
  const double b = scale * std::sin(angle);
  const double cx = (image.cols - 1) / 2.0;
  const double cy = (image.rows - 1) / 2.0;
  const cv::Matx23d affine(a, b, (1 - a) * cx - b * cy + right, -b, a, b * cx + (1 - a) * cy);
  cv::Mat out;
  cv::warpAffine(image, out, cv::Mat(affine), image.size(), cv::INTER_LINEAR, cv::BORDER_REPLICATE);
  return out;
}

// Each of the 256 values by a function of parts of full scale.
template <class Function>
cv::Mat toned(const cv::Mat& image, Function function) {
  cv::Mat table(1, 256, CV_8U);
  for (int v = 0; v < 256; ++v)
    table.at<std::uint8_t>(v) = cv::saturate_cast<std::uint8_t>(255 * function(v / 255.0));
  cv::Mat out;
  cv::LUT(image, table, out);
  return out;
}

cv::Mat noisy(const cv::Mat& image, double deviation, std::uint64_t seed) {
  cv::RNG random(seed);
  cv::Mat noise(image.size(), CV_16SC3);
  random.fill(noise, cv::RNG::NORMAL, 0, deviation);
  cv::Mat out;
  cv::add(image, noise, out, cv::noArray(), CV_8U);
  return out;
}

cv::Mat blurred(const cv::Mat& image, double deviation) {
  cv::Mat out;
  if (deviation <= 0) return image.clone();
  cv::GaussianBlur(image, out, {}, deviation, 0, cv::BORDER_REPLICATE);
  return out;
}

cv::Mat occluded(const cv::Mat& image, double part, std::uint64_t seed) {
  cv::RNG random(seed);
  const int width = cvRound(image.cols * std::sqrt(part));
  const int height = cvRound(image.rows * std::sqrt(part));
  const int x = random.uniform(0, image.cols - width + 1);
  const int y = random.uniform(0, image.rows - height + 1);
  cv::Mat out = image.clone();
  if (width > 0 && height > 0) out(cv::Rect(x, y, width, height)).setTo(cv::Scalar(128, 128, 128));
  return out;
}

cv::Mat greyed(const cv::Mat& image, double part) {
  cv::Mat grey;
  cv::cvtColor(image, grey, cv::COLOR_BGR2GRAY);
  cv::cvtColor(grey, grey, cv::COLOR_GRAY2BGR);
  cv::Mat out;
  cv::addWeighted(grey, part, image, 1 - part, 0, out);
  return out;
}

}  // namespace

std::string_view name(PerturbationKind kind) { return entry_of(kind).name; }
std::string_view strength_of(PerturbationKind kind) { return entry_of(kind).strength; }

std::vector<std::string_view> perturbation_names() {
  std::vector<std::string_view> names;
  for (const Entry& entry : entries) names.push_back(entry.name);
  return names;
}

PerturbationKind perturbation_from_name(std::string_view text) {
  for (const Entry& entry : entries) {
    if (entry.name == text) return entry.kind;
  }
  throw Error("no perturbation '" + std::string(text) + "'");
}

cv::Mat perturb(const cv::Mat& image, PerturbationKind kind, double strength, std::uint64_t seed) {
  const Entry& entry = entry_of(kind);
  if (!(strength >= entry.least && strength <= entry.most)) {
    throw Error(std::string(entry.name) + ": the strength is " + std::string(entry.strength));
  }
  if (image.empty() || image.type() != CV_8UC3) throw Error("perturb: not an 8-bit BGR image");
  switch (kind) {
    case PerturbationKind::shift:
      return moved(image, 0, 1, strength * image.cols);
    case PerturbationKind::crop:
      return moved(image, 0, 1 / (1 - strength), 0);
    case PerturbationKind::rotate:
      return moved(image, strength, 1, 0);
    case PerturbationKind::scale:
      return moved(image, 0, strength, 0);
    case PerturbationKind::brightness:
      return toned(image, [&](double v) { return v * strength; });
    case PerturbationKind::gamma:
      return toned(image, [&](double v) { return std::pow(v, strength); });
    case PerturbationKind::noise:
      return noisy(image, strength, seed);
    case PerturbationKind::blur:
      return blurred(image, strength * image.cols);
    case PerturbationKind::occlusion:
      return occluded(image, strength, seed);
    case PerturbationKind::grey:
      return greyed(image, strength);
  }
  throw Error("unknown perturbation number " + std::to_string(static_cast<int>(kind)));
}

}  // namespace sailmap
