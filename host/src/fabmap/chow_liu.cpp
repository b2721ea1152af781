// The tree of words that tells most of how they occur together (Chow and Liu, 1968).
#include <bit>
#include <cmath>
#include <cstdint>

#include "check.hpp"
#include "sailmap/fabmap.hpp"

namespace sailmap::fabmap {
namespace {

// In which images each word occurs, a bit an image.
class Occurrences {
 public:
  Occurrences(const std::vector<Words>& images, std::size_t words)
      : images_(images.size()), blocks_((images.size() + 63) / 64), bits_(words * blocks_), counts_(words) {
    for (std::size_t image = 0; image < images.size(); ++image) {
      for (const int word : images[image]) {
        const auto w = static_cast<std::size_t>(word);
        bits_[w * blocks_ + image / 64] |= std::uint64_t{1} << (image % 64);
        ++counts_[w];
      }
    }
  }

  [[nodiscard]] double images() const { return static_cast<double>(images_); }
  [[nodiscard]] double with(std::size_t word) const { return counts_[word]; }
  [[nodiscard]] double with_both(std::size_t a, std::size_t b) const {
    int count = 0;
    for (std::size_t i = 0; i < blocks_; ++i)
      count += std::popcount(bits_[a * blocks_ + i] & bits_[b * blocks_ + i]);
    return count;
  }

 private:
  std::size_t images_;
  std::size_t blocks_;
  std::vector<std::uint64_t> bits_;
  std::vector<double> counts_;
};

// Of a count among `all`, half an image with and half an image without added: never 0 nor 1.
double smoothed(double count, double all) { return (count + 0.5) / (all + 1); }

// sum p(a, b) log(p(a, b) / (p(a) p(b))) over the four cases, from the counts; 0 log 0 is 0.
double mutual_information(const Occurrences& seen, std::size_t a, std::size_t b) {
  const double n = seen.images();
  const double both = seen.with_both(a, b);
  const double with_a = seen.with(a);
  const double with_b = seen.with(b);
  const auto term = [n](double joint, double of_a, double of_b) {
    return joint > 0 ? joint / n * std::log(joint * n / (of_a * of_b)) : 0;
  };
  return term(both, with_a, with_b) + term(with_a - both, with_a, n - with_b) +
         term(with_b - both, n - with_a, with_b) + term(n - with_a - with_b + both, n - with_a, n - with_b);
}

// Parents of the maximum spanning tree grown from word 0 (Prim), the first in order on ties.
std::vector<int> spanning_tree(const Occurrences& seen, std::size_t words) {
  std::vector<int> parent(words, -1);
  std::vector<double> best(words, -1);
  std::vector<bool> inside(words, false);
  std::size_t newest = 0;
  inside[0] = true;
  for (std::size_t grown = 1; grown < words; ++grown) {
    std::size_t next = 0;
    for (std::size_t word = 0; word < words; ++word) {
      if (inside[word]) continue;
      const double information = mutual_information(seen, newest, word);
      if (information > best[word]) {
        best[word] = information;
        parent[word] = static_cast<int>(newest);
      }
      if (next == 0 || best[word] > best[next]) next = word;
    }
    inside[next] = true;
    newest = next;
  }
  return parent;
}

}  // namespace

ChowLiuTree learn_tree(const std::vector<Words>& images, int words) {
  if (images.empty()) throw Error("fabmap: no image to learn from");
  if (words < 1) throw Error("fabmap: no word to learn about");
  const auto count = static_cast<std::size_t>(words);
  for (const Words& image : images) check_words(image, count);
  const Occurrences seen(images, count);
  const std::vector<int> parents = spanning_tree(seen, count);
  ChowLiuTree tree(count);
  for (std::size_t word = 0; word < count; ++word) {
    TreeNode& node = tree[word];
    node.parent = parents[word];
    node.marginal = smoothed(seen.with(word), seen.images());
    node.given_parent = node.given_no_parent = node.marginal;
    if (node.parent < 0) continue;
    const auto parent = static_cast<std::size_t>(node.parent);
    const double both = seen.with_both(word, parent);
    node.given_parent = smoothed(both, seen.with(parent));
    node.given_no_parent = smoothed(seen.with(word) - both, seen.images() - seen.with(parent));
  }
  return tree;
}

}  // namespace sailmap::fabmap
