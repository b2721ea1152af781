// What can happen to a picture of a place, one thing at a time and as strong as wanted: to measure how much
// of it a method bears.
#pragma once

#include <cstdint>
#include <opencv2/core/mat.hpp>
#include <string_view>
#include <vector>

namespace sailmap {

enum class PerturbationKind { shift, crop, rotate, scale, brightness, gamma, noise, blur, occlusion, grey };

std::string_view name(PerturbationKind kind);
PerturbationKind perturbation_from_name(std::string_view name);  // throws Error
std::vector<std::string_view> perturbation_names();
// What the strength of a kind means, with its range, for people.
std::string_view strength_of(PerturbationKind kind);

// A changed copy, of the same size, of an 8-bit BGR image. What comes in from outside the image is its edge
// repeated. `seed` decides noise and the place of the occlusion; the same seed gives the same picture. Throws
// Error when the strength is out of the kind's range.
cv::Mat perturb(const cv::Mat& image, PerturbationKind kind, double strength, std::uint64_t seed);

}  // namespace sailmap
