// The words and scalars of one call of a top as text, in the format of scripts/vitis/testbench.hpp.
#pragma once

#include <cmath>
#include <cstdint>
#include <sstream>
#include <string>
#include <vector>

#include "csim/frames.hpp"
#include "sailmap/ref/signature.hpp"

namespace sailmap::testing {

class Call {
 public:
  Call() { text_ << "call\n"; }
  void size(const csim::Frame& frame) {
    text_ << "scalar width " << frame.width << "\nscalar height " << frame.height << '\n';
  }
  void parameters(const ref::RegionParameters& parameters) {
    text_ << "scalar max_regions " << parameters.max_regions << "\nscalar stop_ratio "
          << std::lround(65536 * parameters.stop_ratio) << "\nscalar box_side " << parameters.box_side
          << '\n';
  }
  template <class Word>
  void words(const std::string& port, const std::vector<Word>& words) {
    header(port, words.size());
    for (const Word word : words) text_ << ' ' << std::uint64_t{word};
    text_ << std::dec << '\n';
  }
  // As AXI4-Stream packets of `row` words, the first marked as the start of the frame.
  template <class Word>
  void packets(const std::string& port, const std::vector<Word>& words, std::size_t row) {
    header(port, words.size());
    for (std::size_t i = 0; i < words.size(); ++i) {
      text_ << ' ' << words[i] << (i == 0 ? ":1:" : ":0:") << ((i + 1) % row == 0 ? 1 : 0);
    }
    text_ << std::dec << '\n';
  }
  [[nodiscard]] std::string text() const { return text_.str(); }

 private:
  void header(const std::string& port, std::size_t count) {
    text_ << "words " << port << ' ' << count << std::hex;
  }
  std::ostringstream text_;
};

}  // namespace sailmap::testing
