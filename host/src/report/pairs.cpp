#include "pairs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <functional>
#include <numeric>
#include <unordered_set>

#include "sailmap/context.hpp"
#include "sailmap/error.hpp"

namespace sailmap::report {
namespace {

using Order = std::vector<std::size_t>;

Order sorted(const Subject& subject, const std::function<double(const Loop&)>& key) {
  Order order(subject.loops.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t k) { return key(subject.loops[k]); });
  return order;
}

// The regions as the method numbers them.
Signature numbered(const Signature& signature, const MatchConfig& config) {
  return config.method == Method::context ? with_context_regions(signature) : signature;
}

}  // namespace

std::vector<Pick> pick_loops(const Subject& subject, std::size_t most) {
  const Order weakest = sorted(subject, [](const Loop& loop) { return loop.score; });
  const Order strongest = sorted(subject, [](const Loop& loop) { return -loop.score; });
  const Order doubtful = sorted(subject, [&](const Loop& loop) { return margin(loop, subject.threshold); });
  const std::size_t wanted = std::min(most, subject.loops.size());
  std::vector<Pick> out;
  std::unordered_set<std::size_t> taken;
  const auto take = [&](std::size_t loop, const char* why) {
    if (out.size() < wanted && taken.insert(loop).second) out.push_back({loop, why});
  };
  for (const std::size_t loop : strongest) {
    if (subject.loops[loop].right == false && out.size() < (most + 2) / 3) take(loop, "wrong");
  }
  struct Queue {
    const Order& order;
    const char* why;
    std::size_t next = 0;
  };
  std::array<Queue, 3> queues = {Queue{strongest, "strongest"}, Queue{weakest, "weakest"},
                                 Queue{doubtful, "doubtful"}};
  while (out.size() < wanted) {
    for (Queue& queue : queues) {
      while (queue.next < queue.order.size() && taken.contains(queue.order[queue.next])) ++queue.next;
      if (queue.next < queue.order.size()) take(queue.order[queue.next], queue.why);
    }
  }
  return out;
}

int best_view(const Loop& loop, const Signature& image, const StoredSignatures& stored,
              const MatchConfig& config) {
  int best = loop.views.front();
  if (loop.views.size() == 1) return best;
  double most = -1;
  for (const int view : loop.views) {
    const Signature* signature = stored.of(view);
    if (signature == nullptr || signature->width != image.width || signature->height != image.height)
      continue;
    const double similarity = match(image, *signature, config).similarity;
    if (similarity > most) {
      most = similarity;
      best = view;
    }
  }
  return best;
}

nlohmann::ordered_json pair_of(const Loop& loop, const PairNames& names, const Look& image, const Look& place,
                               const Subject& subject) {
  nlohmann::ordered_json flat = nlohmann::ordered_json::array();
  const Signature left = numbered(image.signature, subject.config.match);
  const Signature right = numbered(place.signature, subject.config.match);
  if (!subject.frontend.empty()) {
    const auto matches =
        loop.matches ? *loop.matches : match(image.signature, place.signature, subject.config.match).matches;
    for (const RegionMatch& m : matches) {
      const auto fits = [](int region, const Signature& s) {
        return region >= 0 && region < static_cast<int>(s.regions.size());
      };
      if (!fits(m.query, left) || !fits(m.candidate, right)) {
        throw Error(fmt::format("{}: not the image it was, its regions are others",
                                fits(m.query, left) ? names.place : names.image));
      }
      flat.push_back(m.query);
      flat.push_back(m.candidate);
      flat.push_back(shortened(m.distance));
    }
  }
  const int side = subject.config.regions.box_side;
  return {{"view", names.view},
          {"matches", std::move(flat)},
          {"regions", boxes_of(left, side)},
          {"place_regions", boxes_of(right, side)}};
}

}  // namespace sailmap::report
