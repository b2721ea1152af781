#include "sailmap/place_index.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <limits>
#include <utility>

#include "agreement.hpp"
#include "estimate.hpp"
#include "grouping.hpp"
#include "leaders.hpp"
#include "match/check.hpp"
#include "screen.hpp"

namespace sailmap {
namespace {

using index::block_images;

// Blocks screened before those that pass are looked at: enough that the memory reads of many overlap, and
// few at first, when nothing is known yet and all pass.
constexpr std::size_t most_blocks_at_once = 16;
// Of a lane without an image: a number that no map reaches.
constexpr int no_node = std::numeric_limits<int>::max();

class Search {
 public:
  Search(const Signature& query, const PlaceIndex::Question& question, const MatchConfig& config,
         const PlaceIndex::SignatureOf& signature_of)
      : query_(query),
        nodes_(question.nodes),
        config_(config),
        signature_of_(signature_of),
        leaders_(question.same_place_nodes, question.at_least),
        screen_(query, config),
        agreement_(query, config),
        estimate_(query, config) {}

  void compare(const PlaceIndex::Entry& entry) {
    if (entry.node < nodes_) {
      leaders_.add({entry.node, match(query_, signature_of_(entry), config_).similarity});
    }
  }

  void screen(const std::vector<PlaceIndex::Entry>& entries, const std::vector<index::Block>& blocks) {
    raise_threshold();
    std::size_t at_once = 1;
    for (std::size_t begin = 0; begin < blocks.size();) {
      const std::size_t end = std::min(blocks.size(), begin + at_once);
      for (std::size_t b = begin; b < end; ++b) {
        sift(entries, blocks[b], blocks[std::min(b + 1, blocks.size() - 1)], b * block_images);
      }
      compare_all();
      raise_threshold();
      begin = end;
      at_once = std::min(2 * at_once, most_blocks_at_once);
    }
    keep_agreeing();
    compare_all();
  }

  [[nodiscard]] Ranking ranking() const { return leaders_.ranking(nodes_); }

 private:
  struct Promising {
    PlaceIndex::Entry entry;
    double bound = 0;  // of the similarity, once estimated
    const Signature* signature = nullptr;
  };
  static bool by_bound(const Promising& a, const Promising& b) { return a.bound > b.bound; }

  void raise_threshold() {
    const double threshold = leaders_.threshold();
    if (threshold <= asked_for_) return;
    screen_.set_threshold(threshold);
    agreement_.set_threshold(threshold);
    asked_for_ = threshold;
  }

  // What passes is looked at again, as soon as there are enough for that.
  void sift(const std::vector<PlaceIndex::Entry>& entries, const index::Block& block,
            const index::Block& next, std::size_t first) {
    const bool known = asked_for_ > 0;
    const std::uint64_t passing = known ? screen_.passing(block, next) : ~std::uint64_t{0};
    for (std::uint64_t left = passing; left != 0; left &= left - 1) {
      const auto lane = static_cast<unsigned>(std::countr_zero(left));
      const std::size_t e = first + lane;
      if (entries[e].node >= nodes_) continue;
      if (!known || !agreement_.judges(block, lane)) {
        promising_.push_back({entries[e]});
        continue;
      }
      in_batch_[batch_.images] = {entries[e]};
      batch_.add(block, lane);
      if (batch_.full()) keep_agreeing();
    }
  }

  void keep_agreeing() {
    if (batch_.images == 0) return;
    const std::uint32_t agreeing = agreement_.passing(batch_);
    for (std::uint32_t left = agreeing; left != 0; left &= left - 1) {
      promising_.push_back(in_batch_[static_cast<unsigned>(std::countr_zero(left))]);
    }
    batch_.clear();
  }

  void find_signature(Promising& p) {
    p.signature = &signature_of_(p.entry);
    __builtin_prefetch(p.signature);
  }

  static void fetch_regions(const Promising& p) {
    const auto* bytes = reinterpret_cast<const char*>(p.signature->regions.data());
    for (std::size_t at = 0; at < p.signature->regions.size() * sizeof(Region); at += 64) {
      __builtin_prefetch(bytes + at);
    }
  }

  // Signatures are asked for well before they are needed, as memory is slow.
  void estimate_all() {
    constexpr std::size_t ahead = 8;
    const std::size_t count = promising_.size();
    for (std::size_t step = 0; step < count + 2 * ahead; ++step) {
      if (step < count) find_signature(promising_[step]);
      if (step >= ahead && step - ahead < count) fetch_regions(promising_[step - ahead]);
      if (step < 2 * ahead) continue;
      Promising& p = promising_[step - 2 * ahead];
      p.bound = estimate_(*p.signature);
    }
  }

  void compare_all() {
    estimate_all();
    std::sort(promising_.begin(), promising_.end(), by_bound);
    for (const Promising& p : promising_) {
      if (p.bound <= 0 || p.bound < leaders_.threshold()) break;
      leaders_.add({p.entry.node, match(query_, *p.signature, config_).similarity});
    }
    promising_.clear();
  }

  const Signature& query_;
  int nodes_;
  const MatchConfig& config_;
  const PlaceIndex::SignatureOf& signature_of_;
  index::Leaders leaders_;
  index::ScreenQuery screen_;
  index::AgreementQuery agreement_;
  index::Estimator estimate_;
  index::Batch batch_;  // screened, and its entries
  std::array<Promising, index::batch_images> in_batch_;
  std::vector<Promising> promising_;
  double asked_for_ = 0;  // the threshold of screening and agreement
};

}  // namespace

PlaceIndex::PlaceIndex() = default;
PlaceIndex::PlaceIndex(const PlaceIndex& other)
    : first_(other.first_),
      size_(other.size_),
      grouping_(other.grouping_ ? std::make_unique<index::Grouping>(*other.grouping_) : nullptr),
      blocks_(other.blocks_),
      entries_(other.entries_),
      unbounded_(other.unbounded_) {}
PlaceIndex::PlaceIndex(PlaceIndex&& other) noexcept = default;
PlaceIndex& PlaceIndex::operator=(const PlaceIndex& other) { return *this = PlaceIndex(other); }
PlaceIndex& PlaceIndex::operator=(PlaceIndex&& other) noexcept = default;
PlaceIndex::~PlaceIndex() = default;

void PlaceIndex::add(const Entry& entry, const Signature& signature) {
  if (size_ == 0) {
    first_ = {signature.width, signature.height, {}};
  } else {
    check_same_size(signature, first_);
  }
  ++size_;
  if (!index::can_be_bounded(signature)) {
    unbounded_.push_back(entry);
    return;
  }
  if (!grouping_) grouping_ = std::make_unique<index::Grouping>();
  const index::Grouping::Place place = grouping_->add(index::column_keys(signature));
  if (place.block == blocks_.size()) {
    blocks_.emplace_back();
    entries_.resize(blocks_.size() * block_images, {no_node, 0});
  }
  blocks_[place.block].add(place.lane, signature);
  entries_[place.block * block_images + place.lane] = entry;
}

Ranking PlaceIndex::find(const Signature& query, const Question& question, const MatchConfig& config,
                         const SignatureOf& signature_of) const {
  check_match_config(config);
  if (size_ > 0) check_same_size(query, first_);
  index::Leaders leaders(question.same_place_nodes, question.at_least);
  if (query.regions.empty()) return leaders.ranking(question.nodes);
  if (!index::can_be_bounded(query)) {
    for (const std::vector<Entry>* entries : {&entries_, &unbounded_}) {
      for (const Entry& entry : *entries) {
        if (entry.node >= question.nodes) continue;
        leaders.add({entry.node, match(query, signature_of(entry), config).similarity});
      }
    }
    return leaders.ranking(question.nodes);
  }
  Search search(query, question, config, signature_of);
  for (const Entry& entry : unbounded_) search.compare(entry);
  search.screen(entries_, blocks_);
  return search.ranking();
}

std::size_t PlaceIndex::memory() const {
  std::size_t bytes = entries_.capacity() * sizeof(Entry) + blocks_.capacity() * sizeof(index::Block) +
                      unbounded_.capacity() * sizeof(Entry) + (grouping_ ? grouping_->memory() : 0);
  for (const index::Block& block : blocks_) bytes += block.memory();
  return bytes;
}

}  // namespace sailmap
