#include "grouping.hpp"

#include <algorithm>
#include <cmath>

#include "screen.hpp"

namespace sailmap::index {
namespace {

// Blocks of a leaf before it is split in two. Unfinished blocks, one for each leaf, are thus few among all.
constexpr std::size_t blocks_of_a_leaf = 16;

// The numbers along an axis, in order.
std::vector<float> along(const std::vector<ColumnKeys>& images, std::size_t axis) {
  std::vector<float> numbers;
  numbers.reserve(images.size());
  for (const ColumnKeys& keys : images) numbers.push_back(keys[axis]);
  std::sort(numbers.begin(), numbers.end());
  return numbers;
}

}  // namespace

ColumnKeys column_keys(const Signature& signature) {
  if (signature.regions.empty()) return {};
  const auto count = static_cast<float>(signature.regions.size());
  float sum = 0;
  for (const Region& region : signature.regions) sum += static_cast<float>(region.x);
  const float mean = sum / count;
  float distances = 0;
  for (const Region& region : signature.regions) distances += std::abs(static_cast<float>(region.x) - mean);
  return {mean, distances / count};
}

std::size_t Grouping::leaf_of(const ColumnKeys& keys) const {
  std::size_t node = 0;
  while (nodes_[node].first_child != 0) {
    node = nodes_[node].first_child + (keys[nodes_[node].axis] < nodes_[node].cut ? 0 : 1);
  }
  return node;
}

Grouping::Place Grouping::add(const ColumnKeys& keys) {
  const std::size_t node = leaf_of(keys);
  Node& leaf = nodes_[node];
  if (leaf.images.empty()) leaf.block = blocks_++;
  const Place place{leaf.block, leaf.images.size()};
  leaf.images.push_back(keys);
  if (leaf.images.size() == block_images) {
    if (++leaf.finished >= blocks_of_a_leaf) split(node);
    nodes_[node].images = {};
  }
  return place;
}

// In the middle of its last block, along the axis where that is wider without its outermost eighths.
void Grouping::split(std::size_t leaf) {
  constexpr std::size_t eighth = block_images / 8;
  float widest = 0;
  for (std::size_t axis = 0; axis < ColumnKeys().size(); ++axis) {
    const std::vector<float> numbers = along(nodes_[leaf].images, axis);
    const float width = numbers[block_images - 1 - eighth] - numbers[eighth];
    if (width <= widest) continue;
    widest = width;
    nodes_[leaf].axis = axis;
    nodes_[leaf].cut = numbers[block_images / 2];
  }
  if (widest == 0) return;  // all alike
  nodes_[leaf].first_child = nodes_.size();
  nodes_.resize(nodes_.size() + 2);
}

std::size_t Grouping::memory() const {
  std::size_t bytes = nodes_.capacity() * sizeof(Node);
  for (const Node& node : nodes_) bytes += node.images.capacity() * sizeof(ColumnKeys);
  return bytes;
}

}  // namespace sailmap::index
