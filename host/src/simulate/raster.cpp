#include "raster.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace sailmap::simulate {
namespace {

constexpr double near_plane = 0.15;    // metres
constexpr int chunk = 16;              // pixels for which level and haze are taken as constant
constexpr float coplanar = 1 - 1e-3F;  // blended: surfaces of one plane (shadows) are painted once

// (u w, v w, w) of the picture coordinates as an affine function of the pixel; depth is 1 / w.
struct Mapping {
  cv::Vec3d base, per_x, per_y;
};

bool find_mapping(const View& view, const Surface& s, Mapping& mapping) {
  const cv::Vec3d right = view.world_to_camera * s.right;
  const cv::Vec3d up = view.world_to_camera * s.up;
  const cv::Vec3d origin = view.world_to_camera * (s.origin - view.position);
  const cv::Vec3d normal = right.cross(up);
  const double volume = normal.dot(origin);
  if (std::abs(volume) < 1e-9) return false;  // seen edge on
  // Rows of the inverse of [right up origin].
  const cv::Vec3d rows[3] = {up.cross(origin) / volume, origin.cross(right) / volume, normal / volume};
  for (int i = 0; i < 3; ++i) {
    mapping.per_x[i] = rows[i][0] / view.focal;
    mapping.per_y[i] = rows[i][1] / view.focal;
    mapping.base[i] = rows[i][2] - view.centre_x * mapping.per_x[i] - view.centre_y * mapping.per_y[i];
  }
  return true;
}

// The level of the texture whose texels are about as large as a pixel: the geometric mean of the footprint's
// sides, but not more than 1.5 levels sharper than its longer side asks for.
int choose_level(const Texture& texture, const Mapping& m, double uw, double vw, double w) {
  const cv::Mat4b& top = texture.levels.front();
  const double u = uw / w;
  const double v = vw / w;
  const auto side = [&](const cv::Vec3d& step) {
    const double du = (step[0] - u * step[2]) / w * top.cols;
    const double dv = (step[1] - v * step[2]) / w * top.rows;
    return du * du + dv * dv;
  };
  const double x = std::max(side(m.per_x), 1e-12);
  const double y = std::max(side(m.per_y), 1e-12);
  const double mean = 0.25 * std::log2(x * y);
  const double level = std::max(mean, 0.5 * std::log2(std::max(x, y)) - 1.5);
  return std::clamp(static_cast<int>(std::floor(level + 0.4)), 0,
                    static_cast<int>(texture.levels.size()) - 1);
}

// Bilinear; u, v in texels from the upper left corner, outside replicated. B, G, R, A scaled by 256.
struct Sampler {
  const cv::Mat4b& level;
  float columns = static_cast<float>(level.cols);
  float rows = static_cast<float>(level.rows);

  [[nodiscard]] cv::Vec4i operator()(float u, float v) const {
    const int x = static_cast<int>(std::clamp(u * columns - 0.5F, 0.0F, columns - 1) * 16);
    const int y = static_cast<int>(std::clamp((1 - v) * rows - 0.5F, 0.0F, rows - 1) * 16);
    const int x0 = x / 16;
    const int y0 = y / 16;
    const int x1 = std::min(x0 + 1, level.cols - 1);
    const int y1 = std::min(y0 + 1, level.rows - 1);
    const int fx = x % 16;
    const int fy = y % 16;
    const cv::Vec4b* upper = level[y0];
    const cv::Vec4b* lower = level[y1];
    cv::Vec4i out;
    for (int c = 0; c < 4; ++c)
      out[c] = (upper[x0][c] * (16 - fx) + upper[x1][c] * fx) * (16 - fy) +
               (lower[x0][c] * (16 - fx) + lower[x1][c] * fx) * fy;
    return out;
  }
};

uchar to_byte(float value) { return static_cast<uchar>(std::clamp(value + 0.5F, 0.0F, 255.0F)); }

// Part of a row: columns first .. last-1.
struct Chunk {
  int first, last, y;
};

template <bool blended>
void paint_chunk(const Surface& surface, const Mapping& m, const Haze& haze, const Chunk& part,
                 cv::Vec3b* colours, float* depths) {
  const cv::Vec3d start = m.base + (part.first + 0.5) * m.per_x + (part.y + 0.5) * m.per_y;
  const cv::Vec3d middle = start + 0.5 * (part.last - 1 - part.first) * m.per_x;
  const int level = choose_level(*surface.texture, m, middle[0], middle[1], middle[2]);
  const Sampler sample{surface.texture->levels[static_cast<std::size_t>(level)]};
  const float clear_air = std::exp(-1 / (static_cast<float>(middle[2]) * haze.range));
  const cv::Vec3f gain = surface.tint * (clear_air / 256);
  const cv::Vec3f air = haze.colour * (1 - clear_air);
  auto uw = static_cast<float>(start[0]);
  auto vw = static_cast<float>(start[1]);
  auto w = static_cast<float>(start[2]);
  const cv::Vec3f step = m.per_x;
  for (int x = part.first; x < part.last; ++x, uw += step[0], vw += step[1], w += step[2]) {
    const float z = 1 / w;
    if (z >= (blended ? depths[x] * coplanar : depths[x])) continue;
    const cv::Vec4i texel = sample(uw * z, vw * z);
    const bool solid = texel[3] >= 128 * 256;
    if (!blended && !solid) continue;
    const float alpha = static_cast<float>(texel[3]) / (255 * 256);
    // Solid surfaces ignore partial alpha, so its factor is taken out of the colour.
    const float weight = blended ? surface.opacity : 1 / alpha;
    const float air_weight = blended ? alpha * surface.opacity : 1;
    const float rest = blended ? 1 - air_weight : 0;
    for (int c = 0; c < 3; ++c)
      colours[x][c] = to_byte(static_cast<float>(texel[c]) * gain[c] * weight + air[c] * air_weight +
                              rest * static_cast<float>(colours[x][c]));
    if (solid) depths[x] = z;
  }
}

}  // namespace

Surface make_panel(const cv::Vec3d& origin, const cv::Vec3d& right, const cv::Vec3d& up, TexturePtr texture) {
  Surface s;
  s.corners = {origin, origin + right, origin + right + up, origin + up};
  s.corner_count = 4;
  s.origin = origin;
  s.right = right;
  s.up = up;
  s.texture = std::move(texture);
  return s;
}

cv::Matx33d View::rotation(double heading, double pitch, double roll) {
  const double ch = std::cos(heading);
  const double sh = std::sin(heading);
  const double cp = std::cos(pitch);
  const double sp = std::sin(pitch);
  const double cr = std::cos(roll);
  const double sr = std::sin(roll);
  const cv::Vec3d right(sh, -ch, 0);
  const cv::Vec3d forward(cp * ch, cp * sh, sp);
  const cv::Vec3d down = forward.cross(right);
  const cv::Vec3d x = cr * right + sr * down;
  const cv::Vec3d y = cr * down - sr * right;
  return {x[0], x[1], x[2], y[0], y[1], y[2], forward[0], forward[1], forward[2]};
}

Raster::Raster(int width, int height, const View& view, const Haze& haze)
    : view_(view),
      haze_(haze),
      colour_(height, width, cv::Vec3b(0, 0, 0)),
      depth_(height, width, std::numeric_limits<float>::infinity()),
      left_(static_cast<std::size_t>(height)),
      right_(static_cast<std::size_t>(height)) {}

double Raster::distance(const Surface& surface) const {
  cv::Vec3d middle;
  for (int i = 0; i < surface.corner_count; ++i) middle += surface.corners[static_cast<std::size_t>(i)];
  return cv::norm(middle / surface.corner_count - view_.position);
}

void Raster::paint_solid(std::vector<Surface> surfaces) {
  std::stable_sort(surfaces.begin(), surfaces.end(),
                   [&](const Surface& a, const Surface& b) { return distance(a) < distance(b); });
  for (const Surface& surface : surfaces) paint<false>(surface);
}

void Raster::paint_blended(std::vector<Surface> surfaces) {
  std::stable_sort(surfaces.begin(), surfaces.end(),
                   [&](const Surface& a, const Surface& b) { return distance(a) > distance(b); });
  for (const Surface& surface : surfaces) paint<true>(surface);
}

bool Raster::find_spans(const Surface& surface) {
  // Cut at the near plane: at most one corner more.
  std::array<cv::Vec3d, Surface::max_corners + 1> cut;
  std::size_t count = 0;
  const auto corner = [&](int i) -> cv::Vec3d {
    return view_.world_to_camera *
           (surface.corners[static_cast<std::size_t>(i % surface.corner_count)] - view_.position);
  };
  for (int i = 0; i < surface.corner_count; ++i) {
    const cv::Vec3d a = corner(i);
    const cv::Vec3d b = corner(i + 1);
    const bool a_inside = a[2] >= near_plane;
    if (a_inside) cut[count++] = a;
    if (a_inside != (b[2] >= near_plane)) cut[count++] = a + (near_plane - a[2]) / (b[2] - a[2]) * (b - a);
  }
  if (count < 3) return false;
  double top = std::numeric_limits<double>::max();
  double bottom = -top;
  for (std::size_t i = 0; i < count; ++i) {
    cv::Vec3d& p = cut[i];
    p[0] = view_.focal * p[0] / p[2] + view_.centre_x;
    p[1] = view_.focal * p[1] / p[2] + view_.centre_y;
    top = std::min(top, p[1]);
    bottom = std::max(bottom, p[1]);
  }
  const double rows = colour_.rows;
  first_row_ = static_cast<int>(std::clamp(std::ceil(top - 0.5), 0.0, rows));
  last_row_ = static_cast<int>(std::clamp(std::ceil(bottom - 0.5), 0.0, rows)) - 1;
  if (first_row_ > last_row_) return false;
  std::fill(left_.begin() + first_row_, left_.begin() + last_row_ + 1, std::numeric_limits<double>::max());
  std::fill(right_.begin() + first_row_, right_.begin() + last_row_ + 1, -std::numeric_limits<double>::max());
  for (std::size_t i = 0; i < count; ++i) {
    const cv::Vec3d& a = cut[i];
    const cv::Vec3d& b = cut[(i + 1) % count];
    const double low = std::min(a[1], b[1]);
    const double high = std::max(a[1], b[1]);
    const int from = static_cast<int>(std::clamp(std::ceil(low - 0.5), 0.0, rows));
    const int to = static_cast<int>(std::clamp(std::ceil(high - 0.5), 0.0, rows));
    for (int y = from; y < to; ++y) {
      const double x = a[0] + (y + 0.5 - a[1]) / (b[1] - a[1]) * (b[0] - a[0]);
      left_[static_cast<std::size_t>(y)] = std::min(left_[static_cast<std::size_t>(y)], x);
      right_[static_cast<std::size_t>(y)] = std::max(right_[static_cast<std::size_t>(y)], x);
    }
  }
  return true;
}

template <bool blended>
void Raster::paint(const Surface& surface) {
  Mapping mapping;
  if (!find_spans(surface) || !find_mapping(view_, surface, mapping)) return;
  const double columns = colour_.cols;
  for (int y = first_row_; y <= last_row_; ++y) {
    const auto row = static_cast<std::size_t>(y);
    const int begin = static_cast<int>(std::clamp(std::ceil(left_[row] - 0.5), 0.0, columns));
    const int end = static_cast<int>(std::clamp(std::ceil(right_[row] - 0.5), 0.0, columns));
    for (int x = begin; x < end; x += chunk)
      paint_chunk<blended>(surface, mapping, haze_, {x, std::min(x + chunk, end), y}, colour_[y], depth_[y]);
  }
}

}  // namespace sailmap::simulate
