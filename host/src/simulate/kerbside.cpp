#include "kerbside.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "random.hpp"

namespace sailmap::simulate {
namespace {

// People or vehicles that go round together at one speed, as if painted on a ring.
struct Stream {
  double speed;    // metres a second along the route
  double lateral;  // left positive; people: part of the pavement from the kerb, vehicles: part of the
                   // carriageway
  bool vehicles;
  double share;  // of all
};

constexpr std::array<Stream, 6> streams = {{{1.3, 0.55, false, 0.2},
                                            {-1.1, 0.25, false, 0.2},
                                            {1.0, -0.35, false, 0.2},
                                            {-1.4, -0.65, false, 0.2},
                                            {-7.0, 0.3, true, 0.15},
                                            {-5.5, 0.32, true, 0.05}}};
constexpr double ring_cell = 25;  // metres

int wrap(int number, int count) { return ((number % count) + count) % count; }

// Calls visit(number) for whole numbers n with first <= n * pitch < last, at most `count` of them.
template <class Visit>
void for_each_slot(double first, double last, double pitch, int count, const Visit& visit) {
  const int from = static_cast<int>(std::ceil(first / pitch));
  for (int n = from; n * pitch < last && n < from + count; ++n) visit(n);
}

}  // namespace

Kerbside::Kerbside(std::uint64_t seed, const StreetPlan& plan, int moving_objects)
    : seed_(seed), plan_(plan), moving_objects_(moving_objects), cars_(make_cars(12)) {}

void Kerbside::place(double first, double last, const Moment& moment, const Sprites& sprites,
                     Scene& scene) const {
  place_furniture(first, last, moment, sprites, scene);
  if (plan_.wide) place_parked_cars(first, last, moment, sprites, scene);
  if (moving_objects_ > 0) place_traffic(first, last, moment, sprites, scene);
}

void Kerbside::place_furniture(double first, double last, const Moment& moment, const Sprites& sprites,
                               Scene& scene) const {
  const double length = plan_.route->length();
  const int count = std::max(4, static_cast<int>(length / 5));
  const double pitch = length / count;
  for (const int side : {1, -1}) {
    for_each_slot(first, last, pitch, count, [&](int n) {
      const int slot = wrap(n, count);
      Random random(hash(seed_, Subject::furniture, side, slot));
      const RoutePoint here = plan_.route->at(n * pitch);
      const cv::Vec3d kerb = here.beside(side * (plan_.kerb + 0.45));
      const bool avenue = unit(hash(seed_, Subject::tree, side, slot / 9)) < 0.35;
      const bool mirrored = random.chance(0.5);
      const auto pick = [&](const std::vector<Sprite>& from) -> const Sprite& {
        return from[static_cast<std::size_t>(random.index(static_cast<int>(from.size())))];
      };
      if (slot % 6 == (side > 0 ? 0 : 3)) {
        place_sprite(scene, sprites.lamp, kerb, moment, false, sprites.soft_shadow);
      } else if (avenue && slot % 2 == 1) {
        place_sprite(scene, pick(sprites.trees), kerb, moment, mirrored, sprites.soft_shadow);
      } else if (random.chance(0.2)) {
        place_sprite(scene, pick(sprites.furniture), kerb, moment, false, sprites.soft_shadow);
      } else if (random.chance(0.08)) {
        const cv::Vec3d wall = here.beside(side * (plan_.front - 0.5));
        place_sprite(scene, pick(sprites.bushes), wall, moment, mirrored, sprites.soft_shadow);
      }
    });
  }
}

void Kerbside::place_car(std::uint64_t which, double along, double lateral, bool oncoming,
                         const Moment& moment, const Sprites& sprites, Scene& scene) const {
  const CarModel& car = cars_[which % cars_.size()];
  const RoutePoint here = plan_.route->at(along);
  const cv::Vec3d middle = here.beside(lateral);
  const double distance = cv::norm(middle - moment.camera);
  if (distance > 120 || distance < 2.6 || (moment.behind(middle) && distance > 5)) return;
  const cv::Vec2d forward = oncoming ? -here.forward() : here.forward();
  car.place(middle, forward, {moment.lighting.to_sun, moment.lighting.ambient, moment.lighting.sun},
            scene.solid);
  const cv::Vec3d ahead = 1.25 * car.length() * cv::Vec3d(forward[0], forward[1], 0);
  const cv::Vec3d right = 1.35 * car.width() * cv::Vec3d(forward[1], -forward[0], 0);
  Surface shadow = make_panel(middle - 0.5 * ahead - 0.5 * right + cv::Vec3d(0, 0, 0.02), right, ahead,
                              sprites.soft_shadow.texture);
  shadow.tint = {0, 0, 0};
  shadow.opacity = 0.7F;
  scene.blended.push_back(shadow);
}

void Kerbside::place_parked_cars(double first, double last, const Moment& moment, const Sprites& sprites,
                                 Scene& scene) const {
  const double length = plan_.route->length();
  const int count = std::max(2, static_cast<int>(length / 6.3));
  const double pitch = length / count;
  // With more life in the street, more parking places have another car on another lap.
  const double changing = std::min(0.6, 0.06 * moving_objects_);
  for (const int side : {1, -1}) {
    for_each_slot(first, last, pitch, count, [&](int n) {
      const int slot = wrap(n, count);
      const auto lap = moment.lap + static_cast<std::int64_t>(std::floor(n * pitch / length));
      const bool changes = unit(hash(seed_, Subject::parking, side, slot)) < changing;
      Random random(hash(seed_, Subject::parking, side, slot, changes ? 1 + lap : 0));
      const bool zone = unit(hash(seed_, Subject::parking, side, slot / 7, -1)) < 0.5;
      if (!zone || !random.chance(0.6)) return;
      const double along = n * pitch + random.uniform(-0.4, 0.4);
      place_car(random.next(), along, side * (plan_.kerb - 1.0), side > 0, moment, sprites, scene);
    });
  }
}

void Kerbside::place_traffic(double first, double last, const Moment& moment, const Sprites& sprites,
                             Scene& scene) const {
  const double length = plan_.route->length();
  const int cells = std::max(1, static_cast<int>(length / ring_cell));
  const double cell = length / cells;
  for (std::size_t i = 0; i < streams.size(); ++i) {
    const Stream& stream = streams[i];
    if (stream.vehicles && !plan_.wide) continue;
    const double expected = moving_objects_ * stream.share * cell / 100;
    const double ahead = std::fmod(stream.speed * moment.time, length);  // of the ring against the street
    const int from = static_cast<int>(std::floor((first - ahead) / cell));
    const int to = static_cast<int>(std::ceil((last - ahead) / cell));
    for (int n = from; n < to && n < from + cells; ++n) {
      Random random(hash(seed_, Subject::traffic, i, wrap(n, cells)));
      const int count = static_cast<int>(expected + random.uniform());
      for (int k = 0; k < count; ++k) {
        const double along = (n + random.uniform()) * cell + ahead;
        const double aside = random.uniform(-0.3, 0.3);
        const std::uint64_t which = random.next();
        if (stream.vehicles) {
          place_car(which, along, stream.lateral * plan_.kerb, stream.speed < 0, moment, sprites, scene);
          continue;
        }
        const double pavement = plan_.front - plan_.kerb;
        const double lateral =
            std::copysign(plan_.kerb + (std::abs(stream.lateral) + aside) * pavement, stream.lateral);
        place_sprite(scene, sprites.people[which % sprites.people.size()],
                     plan_.route->at(along).beside(lateral), moment, stream.speed < 0, sprites.soft_shadow);
      }
    }
  }
}

}  // namespace sailmap::simulate
