// Randomness from hashes: every value is a function of a seed and keys, so any part of the world and any
// image can be made alone, in any order, on any machine (std:: distributions differ between standard
// libraries).
#pragma once

#include <cmath>
#include <cstdint>

namespace sailmap::simulate {

// One step of splitmix64 (Steele, Lea, Flood 2014): a bijection of 64-bit words without visible structure.
constexpr std::uint64_t mix(std::uint64_t x) {
  x += 0x9E3779B97F4A7C15ULL;
  x = (x ^ (x >> 30U)) * 0xBF58476D1CE4E5B9ULL;
  x = (x ^ (x >> 27U)) * 0x94D049BB133111EBULL;
  return x ^ (x >> 31U);
}

// What a hash is for; the same keys give unrelated values for different subjects.
enum class Subject : std::uint8_t {
  route,
  lot,
  style,
  detail,
  gap,
  ground,
  tree,
  lamp,
  furniture,
  parking,
  traffic,
  sprites,
  sky,
  plate,
  along,
  lateral,
  heading,
  pitch,
  roll,
  gain,
  contrast,
  warmth,
  sun,
  clouds,
  noise,
  photo
};

// A well-mixed word of the seed and the keys (integers; order matters).
template <class... Keys>
constexpr std::uint64_t hash(std::uint64_t seed, Subject subject, Keys... keys) {
  std::uint64_t word = mix(mix(seed) ^ static_cast<std::uint64_t>(subject));
  ((word = mix(word ^ static_cast<std::uint64_t>(keys))), ...);
  return word;
}

// 0 <= value < 1, from the top 53 bits.
constexpr double unit(std::uint64_t word) { return static_cast<double>(word >> 11U) * 0x1.0p-53; }

// A stream of random values that starts from a hash.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}

  double uniform() { return unit(next()); }
  double uniform(double low, double high) { return low + (high - low) * uniform(); }
  bool chance(double probability) { return uniform() < probability; }
  // 0 .. count-1
  int index(int count) { return static_cast<int>(uniform() * count); }
  std::uint64_t next() { return mix(state_ += 0x9E3779B97F4A7C15ULL); }

 private:
  std::uint64_t state_;
};

// Continuous in t, with a new value in -1..1 at every whole t and a smooth step between them.
inline double smooth_noise(std::uint64_t seed, double t) {
  const double whole = std::floor(t);
  const double part = t - whole;
  const auto lattice = static_cast<std::uint64_t>(static_cast<std::int64_t>(whole));
  const double a = 2 * unit(mix(seed ^ mix(lattice))) - 1;
  const double b = 2 * unit(mix(seed ^ mix(lattice + 1))) - 1;
  return a + (b - a) * part * part * (3 - 2 * part);
}

}  // namespace sailmap::simulate
