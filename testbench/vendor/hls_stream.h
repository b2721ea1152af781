// Stand-in for the tools' hls_stream.h: an unbounded queue, as the vendors' own C simulation has it. The
// stages of a region then run one after the other, to the end of the frame.
#pragma once

#include <cstddef>
#include <deque>
#include <stdexcept>

namespace hls {

template <class T>
class stream {
 public:
  T read() {
    if (words_.empty()) throw std::runtime_error("read from an empty stream");
    const T word = words_.front();
    words_.pop_front();
    return word;
  }
  bool read_nb(T& word) {
    if (words_.empty()) return false;
    word = read();
    return true;
  }
  void write(const T& word) { words_.push_back(word); }
  std::size_t size() const { return words_.size(); }

 private:
  std::deque<T> words_;
};

}  // namespace hls
