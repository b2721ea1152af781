// Keeps the textures used last; memory does not grow with the length of the drive.
#pragma once

#include <cstddef>
#include <cstdint>
#include <list>
#include <mutex>
#include <unordered_map>
#include <utility>

#include "texture.hpp"

namespace sailmap::simulate {

// Safe to use from several threads.
class TextureCache {
 public:
  explicit TextureCache(std::size_t capacity) : capacity_(capacity) {}

  // The texture of that key, made by `make()` when it is not there. A key must always stand for the same
  // texture.
  template <class Make>
  TexturePtr get(std::uint64_t key, const Make& make) {
    const std::scoped_lock lock(mutex_);
    if (const auto found = places_.find(key); found != places_.end()) {
      entries_.splice(entries_.begin(), entries_, found->second);
      return entries_.front().second;
    }
    entries_.emplace_front(key, make());
    places_[key] = entries_.begin();
    if (entries_.size() > capacity_) {
      places_.erase(entries_.back().first);
      entries_.pop_back();
    }
    return entries_.front().second;
  }

 private:
  using Entries = std::list<std::pair<std::uint64_t, TexturePtr>>;  // the newest first
  std::size_t capacity_;
  std::mutex mutex_;
  Entries entries_;
  std::unordered_map<std::uint64_t, Entries::iterator> places_;
};

}  // namespace sailmap::simulate
