#include "scene.hpp"

#include <cmath>

namespace sailmap::simulate {
namespace {

constexpr double shadow_height = 0.02;  // metres above the ground, to be in front of it

Surface make_shadow(const cv::Vec3d& origin, const cv::Vec3d& right, const cv::Vec3d& up,
                    const TexturePtr& texture, const Lighting& lighting) {
  Surface s = make_panel(origin + cv::Vec3d(0, 0, shadow_height), right, up, texture);
  s.tint = {0, 0, 0};
  s.opacity = lighting.shadow;
  return s;
}

}  // namespace

void place_sprite(Scene& scene, const Sprite& sprite, const cv::Vec3d& position, const Moment& moment,
                  bool mirrored, const Sprite& soft_shadow) {
  if (moment.behind(position)) return;
  const cv::Vec3d away = position - moment.camera;
  const double distance = std::hypot(away[0], away[1]);
  if (distance < 0.8) return;  // it would fill the picture
  cv::Vec3d across = cv::Vec3d(away[1], -away[0], 0) * (sprite.width / distance);
  if (mirrored) across = -across;
  Surface s = make_panel(position - 0.5 * across, across, {0, 0, sprite.height}, sprite.texture);
  s.tint = moment.lighting.ambient + moment.lighting.sun * 0.6F;
  scene.blended.push_back(s);

  const cv::Vec3d& sun = moment.lighting.to_sun;
  const cv::Vec3d fall = cv::Vec3d(-sun[0], -sun[1], 0) * (sprite.height / sun[2]);
  const cv::Vec3d wide = cv::Vec3d(fall[1], -fall[0], 0) * (sprite.width / cv::norm(fall));
  scene.blended.push_back(make_shadow(position - 0.5 * wide, wide, fall, sprite.texture, moment.lighting));
  const double foot = 0.3 * sprite.width;
  scene.blended.push_back(make_shadow(position - cv::Vec3d(foot, foot, 0), {2 * foot, 0, 0}, {0, 2 * foot, 0},
                                      soft_shadow.texture, moment.lighting));
}

}  // namespace sailmap::simulate
