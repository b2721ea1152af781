#include "lighting.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "random.hpp"

namespace sailmap::simulate {
namespace {

// In -1..1: the weather of the lap with the drift within it.
double change(std::uint64_t seed, Subject subject, double laps) {
  return 0.7 * smooth_noise(hash(seed, subject, 1), 0.9 * laps) +
         0.3 * smooth_noise(hash(seed, subject, 2), 5.3 * laps);
}

std::array<std::array<uchar, 256>, 3> exposure_tables(const Lighting& lighting) {
  std::array<std::array<uchar, 256>, 3> tables{};
  for (int c = 0; c < 3; ++c)
    for (int value = 0; value < 256; ++value) {
      const float exposed = static_cast<float>(value) * lighting.gain[c];
      const float out = 110 + (exposed - 110) * lighting.contrast;
      tables[static_cast<std::size_t>(c)][static_cast<std::size_t>(value)] = cv::saturate_cast<uchar>(out);
    }
  return tables;
}

}  // namespace

cv::Vec3f Lighting::on(const cv::Vec3d& normal) const {
  return ambient + sun * static_cast<float>(std::max(0.0, normal.dot(to_sun)));
}

Lighting make_lighting(std::uint64_t seed, double amount, double laps) {
  Random random(hash(seed, Subject::sun));
  const double azimuth = random.uniform(0, 6.28) + 0.5 * amount * change(seed, Subject::sun, laps);
  const double elevation = random.uniform(0.6, 0.95);
  const double cloudiness = random.uniform(0.25, 0.6) + 0.4 * amount * change(seed, Subject::clouds, laps);
  Lighting light;
  light.clouds = std::clamp(cloudiness, 0.0, 1.0);
  light.cloud_shift = amount * 3 * laps;
  light.to_sun = {std::cos(elevation) * std::cos(azimuth), std::cos(elevation) * std::sin(azimuth),
                  std::sin(elevation)};
  const auto strength = static_cast<float>(0.75 - 0.6 * light.clouds);
  const auto fill = static_cast<float>(0.76 + 0.1 * light.clouds);
  light.ambient = cv::Vec3f(1.06F, 1.0F, 0.97F) * fill;
  light.sun = cv::Vec3f(0.86F, 0.97F, 1.06F) * strength;
  light.shadow = 0.2F + 0.5F * strength;
  const auto grey = static_cast<float>(light.clouds);
  light.zenith = cv::Vec3f(214, 150, 92) * (1 - 0.5F * grey) + cv::Vec3f(196, 184, 172) * (0.5F * grey);
  light.horizon = cv::Vec3f(236, 222, 204) * (1 - 0.5F * grey) + cv::Vec3f(214, 208, 202) * (0.5F * grey);
  light.haze = {light.horizon, 260};
  const double warmth = std::clamp(0.1 * amount * change(seed, Subject::warmth, laps), -0.4, 0.4);
  const double gain = std::exp2(std::clamp(0.5 * amount * change(seed, Subject::gain, laps), -2.0, 2.0));
  light.gain = {static_cast<float>(gain * (1 - warmth)), static_cast<float>(gain),
                static_cast<float>(gain * (1 + warmth))};
  light.contrast =
      static_cast<float>(std::clamp(1.05 + 0.2 * amount * change(seed, Subject::contrast, laps), 0.4, 1.8));
  light.noise = static_cast<float>(std::min(2.5 * amount, 20.0));
  return light;
}

cv::Mat3b expose(const cv::Mat3b& scene, cv::Size size, const Lighting& lighting, std::uint64_t noise_seed) {
  cv::Mat3b image;
  cv::resize(scene, image, size, 0, 0, cv::INTER_AREA);
  const auto tables = exposure_tables(lighting);
  const float reach = 1 / std::hypot(static_cast<float>(size.width) / 2, static_cast<float>(size.height) / 2);
  const float spread = lighting.noise / 104.5F;  // of the sum of two bytes
  std::uint64_t state = noise_seed;
  for (int y = 0; y < size.height; ++y) {
    const float dy = (static_cast<float>(y) + 0.5F - static_cast<float>(size.height) / 2) * reach;
    for (int x = 0; x < size.width; ++x) {
      const float dx = (static_cast<float>(x) + 0.5F - static_cast<float>(size.width) / 2) * reach;
      const float vignette = 1 - 0.22F * (dx * dx + dy * dy);
      std::uint64_t bytes = mix(++state);
      cv::Vec3b& pixel = image(y, x);
      for (std::size_t c = 0; c < 3; ++c, bytes >>= 16U) {
        const auto sum = static_cast<float>((bytes & 255U) + ((bytes >> 8U) & 255U)) - 255;
        const float value =
            static_cast<float>(tables[c][pixel[static_cast<int>(c)]]) * vignette + spread * sum;
        pixel[static_cast<int>(c)] = static_cast<uchar>(std::clamp(value + 0.5F, 0.0F, 255.0F));
      }
    }
  }
  return image;
}

}  // namespace sailmap::simulate
