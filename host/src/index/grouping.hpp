// Which images share a block. Screening skips the slots that are out of reach in all images of a group, so a
// block is worth the more the more alike the columns of its images' regions are: each goes to the block of
// those that are like it, found in a k-d tree whose leaves have one unfinished block each.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "sailmap/signature.hpp"

namespace sailmap::index {

// Where the regions of an image lie, across: their mean column, and their mean distance from it, in pixels.
using ColumnKeys = std::array<float, 2>;
ColumnKeys column_keys(const Signature& signature);

class Grouping {
 public:
  struct Place {
    std::size_t block = 0;
    std::size_t lane = 0;
  };

  // Where the next image goes: a block that has room, or the one after all there are.
  Place add(const ColumnKeys& keys);

  [[nodiscard]] std::size_t blocks() const { return blocks_; }
  [[nodiscard]] std::size_t memory() const;  // bytes

 private:
  struct Node {
    // Of a leaf.
    std::size_t block = 0;
    std::vector<ColumnKeys> images;  // in its block; none where it has no block yet
    std::size_t finished = 0;        // blocks
    // Of the others: keys below the cut are those of the first child, the second is next to it.
    std::size_t first_child = 0;
    std::size_t axis = 0;
    float cut = 0;
  };

  [[nodiscard]] std::size_t leaf_of(const ColumnKeys& keys) const;
  void split(std::size_t leaf);

  std::vector<Node> nodes_{1};
  std::size_t blocks_ = 0;
};

}  // namespace sailmap::index
