// The bag of visual words, the plainest method to hold others against: how alike two images' words are,
// rare words counting for more (Sivic and Zisserman, ICCV 2003). Words and vocabulary are those of FAB-MAP.
#pragma once

#include <vector>

#include "sailmap/fabmap.hpp"
#include "sailmap/ref/plane.hpp"

namespace sailmap::bow {

// log((N + 1) / (n + 1)) of each word, n of N training images showing it; >= 0.
std::vector<double> rarity(const fabmap::Vocabulary& vocabulary);

// Cosine of the angle between the images' histograms, each word weighted by its rarity: 0 (no word of any
// weight in common) .. 1. Throws Error when a word has no rarity.
double similarity(const fabmap::Histogram& a, const fabmap::Histogram& b, const std::vector<double>& rarity);

// Similarity of each image with all earlier ones but the `exclude_recent` newest: row = query, column =
// candidate, NaN where not admissible. Runs on all cores; the result does not depend on their number.
Plane<float> score_sequence(const std::vector<fabmap::Histogram>& images, int exclude_recent,
                            const fabmap::Vocabulary& vocabulary);

// Two traverses: each query against all references.
Plane<float> score_traverses(const std::vector<fabmap::Histogram>& queries,
                             const std::vector<fabmap::Histogram>& references,
                             const fabmap::Vocabulary& vocabulary);

// Similarity above which an image is taken for a known place. What is alike depends on the vocabulary: this
// one was measured with 1000 words (docs/recognition.md).
inline constexpr double default_threshold = 0.5;

}  // namespace sailmap::bow
