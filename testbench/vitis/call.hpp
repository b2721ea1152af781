// One call of a top as scripts/vitis/testbench.hpp reads it.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <sstream>
#include <string>
#include <vector>

#include "csim/expected_signature.hpp"
#include "sailmap/csim/frame.hpp"

namespace sailmap::testing {

// One call of a top, as text.
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
  void scalar(const std::string& port, std::uint32_t value) {
    text_ << "scalar " << port << ' ' << value << '\n';
  }
  // Already in hexadecimal.
  void text_words(const std::string& port, const std::vector<std::string>& words) {
    header(port, words.size());
    for (const std::string& word : words) text_ << ' ' << word;
    text_ << std::dec << '\n';
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
