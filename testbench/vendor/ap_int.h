// Stand-in for AMD's ap_int.h: the little of ap_uint that the wrapper uses, on an array of 32-bit words.
#pragma once

#include <cstdint>

template <int Bits>
class ap_uint {
 public:
  // Bits [high:low] of a number, at most 64 of them.
  class Range {
   public:
    Range(const ap_uint& number, int high, int low) : value_(0) {
      for (int i = high; i >= low; --i) value_ = value_ << 1 | number.bit(i);
    }
    std::uint64_t to_uint64() const { return value_; }
    unsigned to_uint() const { return static_cast<unsigned>(value_); }

   private:
    std::uint64_t value_;
  };

  ap_uint() { clear(); }
  // As the vendor's, takes any integer; a negative one is sign-extended.
  ap_uint(long long value) {
    for (int i = 0; i < Bits; ++i) set(i, i < 64 ? (value >> i & 1) != 0 : value < 0);
  }
  ap_uint(unsigned long value) {
    for (int i = 0; i < Bits; ++i) set(i, i < 64 && (value >> i & 1) != 0);
  }
  ap_uint(int value) : ap_uint(static_cast<long long>(value)) {}
  ap_uint(unsigned value) : ap_uint(static_cast<unsigned long>(value)) {}
  ap_uint(std::uint16_t value) : ap_uint(static_cast<unsigned long>(value)) {}

  Range range(int high, int low) const { return Range(*this, high, low); }
  unsigned to_uint() const { return words_[0]; }
  std::uint64_t to_uint64() const { return Range(*this, Bits < 64 ? Bits - 1 : 63, 0).to_uint64(); }

  unsigned bit(int place) const { return words_[place / 32] >> (place % 32) & 1U; }
  void set(int place, bool value) {
    const std::uint32_t mask = std::uint32_t{1} << (place % 32);
    words_[place / 32] = value ? words_[place / 32] | mask : words_[place / 32] & ~mask;
  }

 private:
  static constexpr int count = (Bits + 31) / 32;
  void clear() {
    for (int i = 0; i < count; ++i) words_[i] = 0;
  }
  std::uint32_t words_[count] = {};
};
