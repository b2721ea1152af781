#include "sky.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "random.hpp"

namespace sailmap::simulate {
namespace {

constexpr double turn = 2 * std::numbers::pi;
constexpr int cloud_columns = 1024;
constexpr int cloud_rows = 192;
constexpr double cloud_slope = 1.6;  // of the uppermost row
constexpr int skyline_columns = 2048;

// Fractal noise, 0..1, that closes round the horizon.
float cloud_density(std::uint64_t seed, int column, int row) {
  double sum = 0;
  double weight = 1;
  for (int cells = 8; cells <= 128; cells *= 2, weight *= 0.55) {
    const double u = static_cast<double>(column) * cells / cloud_columns;
    const double v = static_cast<double>(row) * cells / cloud_columns * 2.2;
    const int x = static_cast<int>(u);
    const int y = static_cast<int>(v);
    const auto corner = [&](int cx, int cy) { return unit(hash(seed, Subject::sky, cells, cx % cells, cy)); };
    const double fx = (u - x) * (u - x) * (3 - 2 * (u - x));
    const double fy = (v - y) * (v - y) * (3 - 2 * (v - y));
    const double upper = corner(x, y) * (1 - fx) + corner(x + 1, y) * fx;
    const double lower = corner(x, y + 1) * (1 - fx) + corner(x + 1, y + 1) * fx;
    sum += weight * (upper * (1 - fy) + lower * fy);
  }
  return static_cast<float>(sum / 2.1);
}

}  // namespace

Sky::Sky(std::uint64_t seed) : clouds_(cloud_rows, cloud_columns), skyline_(skyline_columns) {
  for (int row = 0; row < cloud_rows; ++row)
    for (int column = 0; column < cloud_columns; ++column)
      clouds_(row, column) = cloud_density(seed, column, row);
  const std::uint64_t hills = hash(seed, Subject::sky, 0);
  for (int i = 0; i < skyline_columns; ++i) {
    const double angle = turn * i / skyline_columns;
    // Hills from a few harmonics, so that they close.
    skyline_[static_cast<std::size_t>(i)] = 0.05 + 0.02 * std::sin(2 * angle + turn * unit(hills)) +
                                            0.015 * std::sin(5 * angle + turn * unit(mix(hills))) +
                                            0.008 * std::sin(11 * angle + turn * unit(mix(hills + 1)));
  }
  Random random(hash(seed, Subject::sky, 1));
  for (int tower = 0; tower < 40; ++tower) {
    const int width = 4 + random.index(14);
    const int start = random.index(skyline_columns);
    const double slope = random.uniform(0.06, 0.16);
    const bool spire = random.chance(0.25);
    for (int i = 0; i < width; ++i) {
      const double middle = 1 - std::abs(2.0 * i / width - 1);
      double& here = skyline_[static_cast<std::size_t>((start + i) % skyline_columns)];
      here = std::max(here, spire ? slope * (0.5 + 0.9 * middle * middle) : slope);
    }
  }
}

cv::Vec3f Sky::colour(double azimuth, double slope, const Lighting& lighting) const {
  const double round = azimuth / turn - std::floor(azimuth / turn);
  if (slope < 0) {
    const cv::Vec3f earth = cv::Vec3f(96, 112, 112).mul(lighting.ambient);
    const auto near = static_cast<float>(std::min(1.0, -8 * slope));
    return lighting.haze.colour * (1 - near) + earth * near;
  }
  if (slope < skyline_[static_cast<std::size_t>(round * skyline_columns) % skyline_columns])
    return lighting.haze.colour * 0.72F + cv::Vec3f(110, 96, 84) * 0.28F;
  const double drifted = azimuth / turn + lighting.cloud_shift / turn;
  const double column = (drifted - std::floor(drifted)) * cloud_columns;
  const int row = static_cast<int>(std::min(slope / cloud_slope, 0.999) * cloud_rows);
  const int x = static_cast<int>(column) % cloud_columns;
  const auto part = static_cast<float>(column - std::floor(column));
  const float density = clouds_(row, x) * (1 - part) + clouds_(row, (x + 1) % cloud_columns) * part;
  const float cover =
      std::clamp((density - 0.78F + 0.6F * static_cast<float>(lighting.clouds)) * 4, 0.0F, 0.95F);
  const auto height = static_cast<float>(std::min(1.0, 1.3 * slope));
  const cv::Vec3f clear = lighting.horizon * (1 - height) + lighting.zenith * height;
  const float grey = 250 - 62 * static_cast<float>(lighting.clouds) * density;
  return clear * (1 - cover) + cv::Vec3f(grey + 3, grey, grey - 3) * cover;
}

void Sky::paint(Raster& raster, const Lighting& lighting) const {
  const View& view = raster.view();
  const cv::Matx33d to_world = view.world_to_camera.t();
  cv::Mat3b& picture = raster.colour();
  const auto direction = [&](int x, int y) -> cv::Vec3d {
    return to_world *
           cv::Vec3d((x + 0.5 - view.centre_x) / view.focal, (y + 0.5 - view.centre_y) / view.focal, 1);
  };
  constexpr int chunk = 8;  // pixels over which the azimuth is taken as linear
  for (int y = 0; y < picture.rows; ++y) {
    const float* depth = raster.depth()[y];
    for (int x0 = 0; x0 < picture.cols; x0 += chunk) {
      const int x1 = std::min(x0 + chunk, picture.cols);
      if (std::none_of(depth + x0, depth + x1, [](float z) { return std::isinf(z); })) continue;
      const cv::Vec3d first = direction(x0, y);
      const cv::Vec3d last = direction(x0 + chunk, y);
      const double azimuth = std::atan2(first[1], first[0]);
      const double azimuth_step = std::remainder(std::atan2(last[1], last[0]) - azimuth, turn) / chunk;
      const double slope = first[2] / std::hypot(first[0], first[1]);
      const double slope_step = (last[2] / std::hypot(last[0], last[1]) - slope) / chunk;
      for (int x = x0; x < x1; ++x) {
        if (!std::isinf(depth[x])) continue;
        const cv::Vec3f c =
            colour(azimuth + (x - x0) * azimuth_step, slope + (x - x0) * slope_step, lighting);
        picture(y, x) =
            cv::Vec3b(static_cast<uchar>(c[0]), static_cast<uchar>(c[1]), static_cast<uchar>(c[2]));
      }
    }
  }
}

}  // namespace sailmap::simulate
