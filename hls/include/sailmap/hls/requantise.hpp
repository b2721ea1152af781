// Number formats and the one operation that changes them: requantise.
//
// A Format<word, fraction, sign, rounding, overflow> says how a real number is held in an integer `raw`:
// value = raw * 2^-fraction. A negative fraction means that the least significant bit is worth more than one.
// The rounding and overflow modes are SystemC's (IEEE 1666-2011, 7.10.9 and 7.10.10; overflow with no
// saturated bits), each by its SystemC name without the prefix; the tests hold them to sc_fixed over all
// inputs of small formats.
#pragma once

#include <cstdint>
#include <limits>
#include <type_traits>

#ifdef SAILMAP_AP_TYPES
#include <ap_int.h>
#endif

namespace sailmap {
namespace hls {

enum class Sign { is_unsigned, is_signed };

enum class Rounding {
  rnd,          // SC_RND: nearest, ties towards plus infinity; one adder
  rnd_zero,     // SC_RND_ZERO: nearest, ties towards zero
  rnd_min_inf,  // SC_RND_MIN_INF: nearest, ties towards minus infinity
  rnd_inf,      // SC_RND_INF: nearest, ties away from zero
  rnd_conv,     // SC_RND_CONV: nearest, ties to even
  trn,          // SC_TRN: towards minus infinity; free
  trn_zero      // SC_TRN_ZERO: towards zero
};

enum class Overflow {
  sat,       // SC_SAT: the nearest end of the range
  sat_zero,  // SC_SAT_ZERO: zero
  sat_sym,   // SC_SAT_SYM: plus or minus the largest value
  wrap,      // SC_WRAP: modulo 2^word; free
  wrap_sm    // SC_WRAP_SM: sign-magnitude wrap-around, signed formats only
};

namespace detail {

template <int Bits, bool Signed>
struct native_integer {
  static_assert(Bits >= 1 && Bits <= 64, "a word has 1 to 64 bits");
  using type = std::conditional_t<
      (Bits <= 8), std::conditional_t<Signed, std::int8_t, std::uint8_t>,
      std::conditional_t<
          (Bits <= 16), std::conditional_t<Signed, std::int16_t, std::uint16_t>,
          std::conditional_t<(Bits <= 32), std::conditional_t<Signed, std::int32_t, std::uint32_t>,
                             std::conditional_t<Signed, std::int64_t, std::uint64_t>>>>;
};

}  // namespace detail

template <int Word, int Fraction, Sign SignOf = Sign::is_unsigned, Rounding RoundingOf = Rounding::rnd,
          Overflow OverflowOf = Overflow::wrap>
struct Format {
  static constexpr int word = Word;
  static constexpr int fraction = Fraction;
  static constexpr bool is_signed = SignOf == Sign::is_signed;
  static constexpr Rounding rounding = RoundingOf;
  static constexpr Overflow overflow = OverflowOf;

  // The narrowest native integer that holds the word.
  using native = typename detail::native_integer<Word, is_signed>::type;

  static constexpr std::int64_t max_raw() {
    return static_cast<std::int64_t>(~std::uint64_t{0} >> (64 - Word + (is_signed ? 1 : 0)));
  }
  static constexpr std::int64_t min_raw() { return is_signed ? -max_raw() - 1 : 0; }
  static_assert(Word <= 63, "raw values are int64_t");
};

// An exact intermediate value, nothing rounded: what requantise starts from. `Word` bits are room enough.
template <int Word, int Fraction, Sign SignOf = Sign::is_unsigned>
using Exactly = Format<Word, Fraction, SignOf>;

// How a value of the format is stored and streamed.
#ifdef SAILMAP_AP_TYPES
template <class F>
using word_t = std::conditional_t<F::is_signed, ap_int<F::word>, ap_uint<F::word>>;
#else
template <class F>
using word_t = typename F::native;
#endif

namespace detail {

// What to add before the bits below 2^Shift are dropped, so that the drop rounds as Mode says.
template <Rounding Mode, int Shift, class T>
constexpr T rounding_offset(T raw) {
  constexpr T one = 1;
  constexpr T half = one << (Shift - 1);
  const T negative = raw < 0 ? T{1} : T{0};
  switch (Mode) {
    case Rounding::trn:
      return T{0};
    case Rounding::trn_zero:
      return static_cast<T>(negative * ((one << Shift) - 1));
    case Rounding::rnd:
      return half;
    case Rounding::rnd_min_inf:
      return static_cast<T>(half - 1);
    case Rounding::rnd_zero:
      return static_cast<T>(half - 1 + negative);
    case Rounding::rnd_inf:
      return static_cast<T>(half - negative);
    case Rounding::rnd_conv:
      return static_cast<T>(half - 1 + ((raw >> Shift) & 1));
  }
  return T{0};
}

// Division by 2^Shift with rounding. `>>` of a negative integer is arithmetic on every compiler and tool
// here.
template <Rounding Mode, int Shift, class T>
constexpr std::enable_if_t<(Shift > 0), T> shift_right(T raw) {
  return static_cast<T>((raw + rounding_offset<Mode, Shift, T>(raw)) >> Shift);
}

template <Rounding Mode, int Shift, class T>
constexpr std::enable_if_t<(Shift <= 0), T> shift_right(T raw) {
  return static_cast<T>(raw * (T{1} << -Shift));
}

template <class To>
constexpr std::int64_t wrapped(std::int64_t raw) {
  const auto low = static_cast<std::uint64_t>(raw) & (~std::uint64_t{0} >> (64 - To::word));
  const bool minus = To::is_signed && ((low >> (To::word - 1)) & 1U) != 0;
  return static_cast<std::int64_t>(minus ? low | ~(~std::uint64_t{0} >> (64 - To::word)) : low);
}

// The sign of the result is the lowest deleted bit; where that is not the sign plain wrapping gives, the
// other bits are inverted, so that the value turns round at the ends of the range instead of jumping.
template <class To>
constexpr std::int64_t wrapped_sign_magnitude(std::int64_t raw) {
  const bool deleted = ((raw >> To::word) & 1) != 0;
  const bool sign = ((raw >> (To::word - 1)) & 1) != 0;
  return wrapped<To>(deleted == sign ? raw : ~raw);
}

// For SC_SAT_SYM the most negative word is out of range too.
template <class To>
constexpr std::int64_t overflowed(std::int64_t raw) {
  constexpr std::int64_t most = To::max_raw();
  constexpr std::int64_t least = To::is_signed && To::overflow == Overflow::sat_sym ? -most : To::min_raw();
  const bool above = raw > most;
  return !above && raw >= least                                               ? raw
         : To::overflow == Overflow::sat || To::overflow == Overflow::sat_sym ? (above ? most : least)
         : To::overflow == Overflow::sat_zero                                 ? 0
         : To::overflow == Overflow::wrap_sm ? wrapped_sign_magnitude<To>(raw)
                                             : wrapped<To>(raw);
}

// SC_WRAP drops the upper bits; done by the conversion alone where the word is a native one.
template <class To, class T>
constexpr std::enable_if_t<To::overflow == Overflow::wrap && To::word == 8 * sizeof(typename To::native),
                           typename To::native>
fit(T raw) {
  return static_cast<typename To::native>(raw);
}
template <class To, class T>
constexpr std::enable_if_t<To::overflow != Overflow::wrap || To::word != 8 * sizeof(typename To::native),
                           typename To::native>
fit(T raw) {
  return static_cast<typename To::native>(overflowed<To>(static_cast<std::int64_t>(raw)));
}

}  // namespace detail

// From `raw` of a format with From::fraction to the raw value of To, rounded and fitted as To says. T, the
// type of the argument, is the width of the arithmetic: it must hold raw times the scaling, and raw plus half
// a new unit.
template <class From, class To, class T>
constexpr typename To::native requantise(T raw) {
  static_assert(std::is_integral<T>::value && sizeof(T) >= 4, "arithmetic on native 32 or 64-bit integers");
  static_assert(!From::is_signed || std::is_signed<T>::value, "a signed value in an unsigned integer");
  constexpr int room = std::numeric_limits<T>::digits + (From::is_signed ? 1 : 0);
  constexpr int shift = From::fraction - To::fraction;
  static_assert(shift < std::numeric_limits<T>::digits, "nothing of the value is left");
  static_assert(From::word + (shift < 0   ? -shift
                              : shift > 0 ? 1
                                          : 0) <=
                    room,
                "the scaled or rounded value does not fit the arithmetic");
  return detail::fit<To>(detail::shift_right<To::rounding, shift, T>(raw));
}

}  // namespace hls
}  // namespace sailmap
