// Runs one stage, or a few, in C simulation: words in, words out.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "sailmap/csim/scheduler.hpp"
#include "sailmap/hls/stream.hpp"

namespace sailmap::testing {

class StageRun {
 public:
  // A FIFO into which the words go.
  template <class T>
  csim::Stream<T>& feed(std::vector<T> words) {
    csim::Stream<T>& stream = make<T>("in");
    scheduler_.launch("source", {&stream}, [&stream, words = std::move(words)] {
      for (const T& word : words) stream.write(word);
    });
    return stream;
  }

  // A FIFO from which `count` words go to `words`.
  template <class T>
  csim::Stream<T>& take(std::size_t count, std::vector<T>& words) {
    csim::Stream<T>& stream = make<T>("out");
    scheduler_.launch("sink", {&stream}, [&stream, &words, count] {
      words.resize(count);
      for (T& word : words) word = stream.read();
    });
    return stream;
  }

  // A FIFO between two stages.
  template <class T>
  csim::Stream<T>& between() {
    return make<T>("between");
  }

  void run() { scheduler_.run(); }

 private:
  template <class T>
  csim::Stream<T>& make(const char* name) {
    auto stream = std::make_unique<csim::Stream<T>>(name + std::to_string(fifos_.size()));
    csim::Stream<T>& reference = *stream;
    fifos_.push_back(std::move(stream));
    return reference;
  }

  std::vector<std::unique_ptr<csim::Fifo>> fifos_;
  csim::Scheduler scheduler_;
};

}  // namespace sailmap::testing
