// requantise against SystemC's sc_fix and sc_ufix (IEEE 1666): every input of small formats, every rounding
// mode with every overflow mode, from signed and unsigned, to signed and unsigned words of several widths and
// fractions.
#include "sailmap/hls/requantise.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#define SC_INCLUDE_FX
#include <systemc>

// libsystemc has a main of its own, which asks for this and would win over GoogleTest's: so the tests have
// theirs.
int sc_main(int /*argc*/, char* /*argv*/[]) { return 1; }

int main(int argc, char* argv[]) {
  ::testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}

namespace sailmap {
namespace hls {
namespace {

constexpr Rounding roundings[] = {Rounding::rnd,     Rounding::rnd_zero, Rounding::rnd_min_inf,
                                  Rounding::rnd_inf, Rounding::rnd_conv, Rounding::trn,
                                  Rounding::trn_zero};
constexpr sc_dt::sc_q_mode systemc_roundings[] = {
    sc_dt::SC_RND,      sc_dt::SC_RND_ZERO, sc_dt::SC_RND_MIN_INF, sc_dt::SC_RND_INF,
    sc_dt::SC_RND_CONV, sc_dt::SC_TRN,      sc_dt::SC_TRN_ZERO};
constexpr Overflow overflows[] = {Overflow::sat, Overflow::sat_zero, Overflow::sat_sym, Overflow::wrap,
                                  Overflow::wrap_sm};
constexpr sc_dt::sc_o_mode systemc_overflows[] = {sc_dt::SC_SAT, sc_dt::SC_SAT_ZERO, sc_dt::SC_SAT_SYM,
                                                  sc_dt::SC_WRAP, sc_dt::SC_WRAP_SM};

// What SystemC makes of `value` in a word of To.
template <class To>
std::int64_t systemc_raw(double value, sc_dt::sc_q_mode rounding, sc_dt::sc_o_mode overflow) {
  const int integer_bits = To::word - To::fraction;
  const double result =
      To::is_signed ? sc_dt::sc_fix(value, To::word, integer_bits, rounding, overflow, 0).to_double()
                    : sc_dt::sc_ufix(value, To::word, integer_bits, rounding, overflow, 0).to_double();
  return static_cast<std::int64_t>(std::ldexp(result, To::fraction));
}

template <class From, class To>
int compare_all_inputs(sc_dt::sc_q_mode rounding, sc_dt::sc_o_mode overflow) {
  int compared = 0;
  for (std::int64_t raw = From::min_raw(); raw <= From::max_raw(); ++raw) {
    const std::int64_t expected =
        systemc_raw<To>(std::ldexp(static_cast<double>(raw), -From::fraction), rounding, overflow);
    const std::int64_t wide = requantise<From, To>(raw);
    const std::int64_t narrow = requantise<From, To>(static_cast<std::int32_t>(raw));
    EXPECT_EQ(wide, expected) << raw << " * 2^-" << From::fraction << " to " << To::word << " bits, fraction "
                              << To::fraction << (To::is_signed ? " signed " : " unsigned ") << rounding
                              << overflow;
    EXPECT_EQ(narrow, expected);
    if constexpr (!From::is_signed) {
      EXPECT_EQ((requantise<From, To>(static_cast<std::uint32_t>(raw))), expected);
    }
    ++compared;
  }
  return compared;
}

// The standard has wrap_sm for signed words alone.
template <class From, int Word, int Fraction, Sign SignOf, std::size_t R, std::size_t O>
int one_mode() {
  if constexpr (SignOf == Sign::is_unsigned && overflows[O] == Overflow::wrap_sm) {
    return 0;
  } else {
    return compare_all_inputs<From, Format<Word, Fraction, SignOf, roundings[R], overflows[O]>>(
        systemc_roundings[R], systemc_overflows[O]);
  }
}

template <class From, int Word, int Fraction, Sign SignOf, std::size_t R, std::size_t... O>
int each_overflow(std::index_sequence<O...> /*modes*/) {
  return (one_mode<From, Word, Fraction, SignOf, R, O>() + ...);
}

template <class From, int Word, int Fraction, Sign SignOf, std::size_t... R>
int each_rounding(std::index_sequence<R...> /*modes*/) {
  return (each_overflow<From, Word, Fraction, SignOf, R>(std::make_index_sequence<std::size(overflows)>()) +
          ...);
}

template <class From, int Word, int Fraction>
int each_sign() {
  constexpr auto modes = std::make_index_sequence<std::size(roundings)>();
  return each_rounding<From, Word, Fraction, Sign::is_unsigned>(modes) +
         each_rounding<From, Word, Fraction, Sign::is_signed>(modes);
}

template <class From>
int each_target() {
  return each_sign<From, 4, 0>() + each_sign<From, 8, 4>() + each_sign<From, 3, 2>() +
         each_sign<From, 5, -1>() + each_sign<From, 6, 3>() + each_sign<From, 11, 6>() +
         each_sign<From, 16, 5>();
}

constexpr int modes_of_both_signs = 7 * (5 + 4);

TEST(Requantise, IsSystemCsFromUnsigned) {
  using From = Format<9, 4, Sign::is_unsigned>;
  EXPECT_EQ(each_target<From>(), 7 * modes_of_both_signs * 512);
}

TEST(Requantise, IsSystemCsFromSigned) {
  using From = Format<9, 4, Sign::is_signed>;
  EXPECT_EQ(each_target<From>(), 7 * modes_of_both_signs * 512);
}

TEST(Requantise, IsSystemCsFromNegativeFraction) {
  using From = Format<7, -2, Sign::is_signed>;
  EXPECT_EQ(each_target<From>(), 7 * modes_of_both_signs * 128);
}

// Known answers, so that the two cannot be wrong together.
TEST(Requantise, HandWorked) {
  using Half = Format<8, 1, Sign::is_signed>;  // raw 5 is 2.5
  EXPECT_EQ((requantise<Half, Format<4, 0, Sign::is_signed, Rounding::rnd>>(5)), 3);
  EXPECT_EQ((requantise<Half, Format<4, 0, Sign::is_signed, Rounding::rnd>>(-5)), -2);
  EXPECT_EQ((requantise<Half, Format<4, 0, Sign::is_signed, Rounding::rnd_inf>>(-5)), -3);
  EXPECT_EQ((requantise<Half, Format<4, 0, Sign::is_signed, Rounding::rnd_conv>>(5)), 2);
  EXPECT_EQ((requantise<Half, Format<4, 0, Sign::is_signed, Rounding::trn>>(-5)), -3);
  EXPECT_EQ((requantise<Half, Format<3, 0, Sign::is_signed, Rounding::rnd, Overflow::sat>>(100)), 3);
  EXPECT_EQ((requantise<Half, Format<3, 0, Sign::is_signed, Rounding::rnd, Overflow::sat_sym>>(-100)), -3);
  EXPECT_EQ((requantise<Half, Format<3, 0, Sign::is_signed, Rounding::trn, Overflow::wrap>>(8)), -4);
}

static_assert(requantise<Format<8, 1>, Format<4, 0>>(5) == 3, "requantise is constexpr");

}  // namespace
}  // namespace hls
}  // namespace sailmap
