// What the generated test benches share: words from a file into the ports of a top, and its words against the
// file. C++14 and the tool's streams alone, for C simulation, co-simulation and g++.
//
// File, written by testbench/vitis/write_vectors.cpp, for each call of the top:
//   call
//   scalar NAME VALUE                decimal
//   words NAME COUNT WORD...         hexadecimal; of an AXI4-Stream DATA:TUSER:TLAST
#pragma once

#include <ap_axi_sdata.h>
#include <ap_int.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <map>
#include <string>
#include <vector>

#include "sailmap/hls/stream.hpp"

namespace sailmap {
namespace vitis {

// A word of a port from and to the text of the file.
template <class T>
struct Token {
  static T word(const std::string& text) { return static_cast<T>(std::stoull(text, nullptr, 16)); }
  static bool same(const T& a, const T& b) { return a == b; }
};

template <int Bits>
struct Token<ap_uint<Bits> > {
  // May be longer than any native integer.
  static ap_uint<Bits> word(const std::string& text) {
    ap_uint<Bits> number = 0;
    for (int i = 0; i < Bits && static_cast<std::size_t>(i / 4) < text.size(); ++i) {
      const std::string digit(1, text[text.size() - 1 - static_cast<std::size_t>(i / 4)]);
      number.set(i, (std::stoi(digit, nullptr, 16) >> (i % 4) & 1) != 0);
    }
    return number;
  }
};

template <int Data, int User, int Id, int Dest>
struct Token<ap_axiu<Data, User, Id, Dest> > {
  using Beat = ap_axiu<Data, User, Id, Dest>;

  // DATA:TUSER:TLAST.
  static Beat word(const std::string& text) {
    const std::size_t digits = text.find(':');
    Beat beat;
    beat.data = Token<ap_uint<Data> >::word(text.substr(0, digits));
    beat.keep = -1;
    beat.strb = -1;
    beat.user = text[digits + 1] == '1' ? 1 : 0;
    beat.last = text[digits + 3] == '1' ? 1 : 0;
    beat.id = 0;
    beat.dest = 0;
    return beat;
  }
  // Of maps, which have at most 64 bits.
  static bool same(const Beat& a, const Beat& b) {
    return a.data.to_uint64() == b.data.to_uint64() && a.keep.to_uint() == b.keep.to_uint() &&
           a.user.to_uint() == b.user.to_uint() && a.last.to_uint() == b.last.to_uint();
  }
};

class Vectors {
 public:
  // The file is the program's only argument. Without it, ends the program.
  Vectors(int argc, char** argv) : name_(argc == 2 ? argv[1] : ""), file_(name_), calls_(0), faults_(0) {
    std::string keyword;
    if (!(file_ >> keyword) || keyword != "call") stop("no vectors");
  }

  // Reads the next call; false after the last.
  bool next_call() {
    scalars_.clear();
    words_.clear();
    if (!file_) return false;
    std::string keyword;
    while (file_ >> keyword && keyword != "call") read(keyword);
    ++calls_;
    return true;
  }

  std::uint16_t scalar(const std::string& port) const {
    const auto found = scalars_.find(port);
    if (found == scalars_.end()) stop("no scalar " + port);
    return found->second;
  }

  template <class T>
  void fill(const std::string& port, hls::stream<T>& stream) const {
    for (const std::string& text : words_of(port)) stream.write(Token<T>::word(text));
  }
  template <class T, std::size_t Extent>
  void fill(const std::string& port, T (&memory)[Extent]) const {
    const std::vector<std::string>& words = words_of(port);
    if (words.size() > Extent) stop("too many words of " + port);
    for (std::size_t i = 0; i < words.size(); ++i) memory[i] = Token<T>::word(words[i]);
  }
  // The top must have read all of an input.
  template <class T>
  void expect_read(const std::string& port, hls::stream<T>& stream) {
    if (stream.size() > 0) fault(port, "words not read");
    while (stream.size() > 0) stream.read();
  }
  template <class T>
  void check(const std::string& port, hls::stream<T>& stream) {
    std::vector<T> got;
    while (stream.size() > 0) got.push_back(stream.read());
    compare(port, got);
  }
  // The first words of an array, as many as the file has.
  template <class T, std::size_t Extent>
  void check(const std::string& port, const T (&got)[Extent]) {
    const std::size_t count = words_of(port).size();
    compare(port, std::vector<T>(got, got + (count < Extent ? count : Extent)));
  }

  // The exit code: 0 when every word of every call was right.
  int finish() const {
    std::cout << name_ << ": " << calls_ << " calls, " << faults_ << " ports wrong\n";
    return faults_ == 0 ? 0 : 1;
  }

 private:
  template <class T>
  void compare(const std::string& port, const std::vector<T>& got) {
    const std::vector<std::string>& want = words_of(port);
    if (got.size() != want.size()) {
      fault(port, std::to_string(got.size()) + " words, not " + std::to_string(want.size()));
      return;
    }
    std::size_t wrong = 0;
    for (std::size_t i = 0; i < got.size(); ++i) {
      if (!Token<T>::same(got[i], Token<T>::word(want[i]))) ++wrong;
    }
    if (wrong > 0) fault(port, std::to_string(wrong) + " of " + std::to_string(got.size()) + " words wrong");
  }

  void read(const std::string& keyword) {
    std::string port;
    std::size_t number = 0;
    if (!(file_ >> port >> number)) stop("broken at " + keyword);
    if (keyword == "scalar") {
      scalars_[port] = static_cast<std::uint16_t>(number);
      return;
    }
    std::vector<std::string>& words = words_[port];
    words.resize(number);
    for (std::string& word : words) {
      if (!(file_ >> word)) stop("too few words of " + port);
    }
  }
  const std::vector<std::string>& words_of(const std::string& port) const {
    const auto found = words_.find(port);
    if (found == words_.end()) stop("no words of " + port);
    return found->second;
  }
  void fault(const std::string& port, const std::string& what) {
    std::cout << "call " << calls_ << ", " << port << ": " << what << '\n';
    ++faults_;
  }
  [[noreturn]] void stop(const std::string& what) const {
    std::cerr << "testbench: " << (name_.empty() ? "no file given" : name_ + ": " + what) << '\n';
    std::exit(2);
  }

  std::string name_;
  std::ifstream file_;
  std::map<std::string, std::uint16_t> scalars_;
  std::map<std::string, std::vector<std::string> > words_;
  int calls_;
  int faults_;
};

}  // namespace vitis
}  // namespace sailmap
