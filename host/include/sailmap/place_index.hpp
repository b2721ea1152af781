// The nodes most similar to an image, found without comparing it with all: exactly what the exhaustive scan
// with match() says, node numbers and similarities bit for bit, ties included.
//
// Each image is kept as ten bytes a region, which bound every descriptor distance from both sides and hold
// positions, mostly exactly. Images whose similarity cannot reach the second-best place known are dismissed
// by these bounds, first under constraint 1 alone and then under both; most of the others by a similarity in
// single precision, and match() decides among the few that remain.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

#include "sailmap/detection.hpp"
#include "sailmap/signature.hpp"
#include "sailmap/similarity.hpp"

namespace sailmap {

namespace index {
struct Block;
class Grouping;
}  // namespace index

class PlaceIndex {
 public:
  // View number `view` of node number `node`, both from 0.
  struct Entry {
    int node = 0;
    int view = 0;
  };
  using SignatureOf = std::function<const Signature&(const Entry&)>;

  // What is asked for: see rank(), among nodes 0 .. `nodes` - 1 (all of which have entries). Nodes less
  // similar than `at_least` count as none; the higher it is, the less has to be compared.
  struct Question {
    int nodes = 0;
    int same_place_nodes = 0;
    double at_least = 0;
  };

  PlaceIndex();
  PlaceIndex(const PlaceIndex& other);
  PlaceIndex(PlaceIndex&& other) noexcept;
  PlaceIndex& operator=(const PlaceIndex& other);
  PlaceIndex& operator=(PlaceIndex&& other) noexcept;
  ~PlaceIndex();

  // Signatures are not copied; `find` asks for the few it needs. Throws Error when the image's size is not
  // that of those before it; the index is then unchanged.
  void add(const Entry& entry, const Signature& signature);

  // Best node and runner-up, a node being as similar as the most similar of its entries. `signature_of` gives
  // the signatures as they were added. Throws Error like match().
  [[nodiscard]] Ranking find(const Signature& query, const Question& question, const MatchConfig& config,
                             const SignatureOf& signature_of) const;

  [[nodiscard]] std::size_t size() const { return size_; }  // entries
  [[nodiscard]] std::size_t memory() const;                 // bytes, without the signatures

 private:
  Signature first_;  // its size, which is that of all
  std::size_t size_ = 0;
  std::unique_ptr<index::Grouping> grouping_;  // none of an empty index
  std::vector<index::Block> blocks_;
  std::vector<Entry>
      entries_;  // of lane l of block b: number 64 b + l; a node beyond all where there is none
  std::vector<Entry> unbounded_;  // with numbers that cannot be bounded: always compared
};

}  // namespace sailmap
