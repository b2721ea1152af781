// Several 16-bit numbers side by side in one native word: what streams carry and memories hold.
//
// Lane 0 is the low half-word. Everything here unrolls by template recursion, so that all shifts are
// constants.
#pragma once

#include <cstdint>

namespace sailmap {
namespace hls {

constexpr int lane_bits = 16;

// The narrowest native word of `Count` lanes, and of `Count` bytes.
template <int Count>
struct WordOf;
template <>
struct WordOf<1> {
  using lanes = uint16_t;
  using bytes = uint8_t;
};
template <>
struct WordOf<2> {
  using lanes = uint32_t;
  using bytes = uint16_t;
};
template <>
struct WordOf<3> {
  using lanes = uint64_t;
};
template <>
struct WordOf<4> {
  using lanes = uint64_t;
  using bytes = uint32_t;
};
template <>
struct WordOf<8> {
  using bytes = uint64_t;
};
template <int Count>
using lanes_t = typename WordOf<Count>::lanes;
template <int Count>
using bytes_t = typename WordOf<Count>::bytes;

// Lane `Index` of a word.
template <int Index, class Word>
inline uint16_t lane(Word word) {
  return static_cast<uint16_t>(word >> (Index * lane_bits));
}

template <int Index, class Word>
inline uint8_t byte_lane(Word word) {
  return static_cast<uint8_t>(word >> (Index * 8));
}

inline uint64_t pack(uint16_t a, uint16_t b, uint16_t c, uint16_t d) {
  return static_cast<uint64_t>(a) | static_cast<uint64_t>(b) << 16 | static_cast<uint64_t>(c) << 32 |
         static_cast<uint64_t>(d) << 48;
}
inline uint32_t pack(uint16_t a, uint16_t b) {
  return static_cast<uint32_t>(a) | static_cast<uint32_t>(b) << 16;
}

// A pair of maps where they are wider than 16 bits: two lanes of 32.
template <int Index>
inline uint32_t wide_lane(uint64_t pair) {
  return static_cast<uint32_t>(pair >> (Index * 32));
}
inline uint64_t wide_pair(uint32_t a, uint32_t b) {
  return static_cast<uint64_t>(a) | static_cast<uint64_t>(b) << 32;
}

// The low bits of a number that has no more of them: nothing is lost, and a tool is told how wide its
// registers and adders need be where a number comes from a memory or a FIFO.
template <int Bits>
constexpr uint32_t narrow(uint32_t value) {
  static_assert(Bits > 0 && Bits < 32, "narrower than the native number");
  return value & ((uint32_t{1} << Bits) - 1);
}
// The same of a number with a sign.
template <int Bits>
inline int32_t narrow_signed(int32_t value) {
  return static_cast<int32_t>(static_cast<uint32_t>(value) << (32 - Bits)) >> (32 - Bits);
}
// Both lanes of a pair.
template <int Bits>
constexpr uint64_t narrow_pair(uint64_t pair) {
  return pair & (uint64_t{narrow<Bits>(~uint32_t{0})} << 32 | narrow<Bits>(~uint32_t{0}));
}

// What a function is told that stages share (SAILMAP_SHARED), and its number among those alike: Bambu makes
// one of two functions that do the same, and misses the other.
template <int Number>
constexpr uint32_t tagged(uint32_t bits) {
  return bits << Number;
}
template <int Number>
constexpr uint32_t untagged(uint32_t tagged_bits) {
  return tagged_bits >> Number;
}

// Count numbers of one type, one scalar each: registers, to every tool.
template <int Count, class T>
struct Lanes {
  T first;
  Lanes<Count - 1, T> rest;
};
template <class T>
struct Lanes<1, T> {
  T first;
};

template <class T>
inline void fill(Lanes<1, T>& out, T value) {
  out.first = value;
}
template <int Count, class T>
inline void fill(Lanes<Count, T>& out, T value) {
  out.first = value;
  fill(out.rest, value);
}

template <class T, class Word>
inline void unpack(Word word, Lanes<1, T>& out) {
  out.first = static_cast<T>(static_cast<uint16_t>(word));
}
template <int Count, class T, class Word>
inline void unpack(Word word, Lanes<Count, T>& out) {
  out.first = static_cast<T>(static_cast<uint16_t>(word));
  unpack(static_cast<Word>(word >> lane_bits), out.rest);
}

template <class Word, class T>
inline Word packed(const Lanes<1, T>& lanes) {
  return static_cast<Word>(static_cast<uint16_t>(lanes.first));
}
template <class Word, int Count, class T>
inline Word packed(const Lanes<Count, T>& lanes) {
  return static_cast<Word>(static_cast<Word>(packed<Word>(lanes.rest) << lane_bits) |
                           static_cast<Word>(static_cast<uint16_t>(lanes.first)));
}

// A shift register: push() returns what was pushed Length pushes ago.
template <int Length, class T>
struct ShiftRegister {
  T newest;
  ShiftRegister<Length - 1, T> older;

  void fill(T value) {
    newest = value;
    older.fill(value);
  }
  T push(T value) {
    const T out = older.push(newest);
    newest = value;
    return out;
  }
};
template <class T>
struct ShiftRegister<1, T> {
  T newest;

  void fill(T value) { newest = value; }
  T push(T value) {
    const T out = newest;
    newest = value;
    return out;
  }
};

}  // namespace hls
}  // namespace sailmap
