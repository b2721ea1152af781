#include <cmath>
#include <iomanip>
#include <sstream>

#include "documents.hpp"
#include "sailmap/number_format.hpp"

namespace sailmap::numbers {
namespace {

constexpr const char* introduction = R"(# Number formats

Made from `hls/include/sailmap/hls/formats.hpp` by `scripts/numbers`; a test holds the two together. Do not edit.

Every named point of the design (spec section 9): where the kernels round, and where the reference's `quantised` policy
rounds likewise. Between two points all arithmetic is exact. A real number of the spec is raw x 2^-fraction x unit; a negative
fraction means that the least significant bit (LSB) is worth more than one unit.

- **Format**: u or s (unsigned, signed), integer bits . fraction bits; their sum is the word length.
- **Rounding**, **overflow**: SystemC's modes (IEEE 1666). `SC_WRAP` costs nothing, and `hls/ranges.hpp` proves for every point that no value
  leaves its word, nor would fit one bit less; the one `SC_SAT` is meant (a gain of 1 becomes 1 - 2^-16).
- **Unit**: `one` = 1; `grey` = 1/765, since intensity is kept as r+g+b; `grey21` = 1/(765 x 21) and `colour21` = 1/21, since the contrasts' divisors
  48 and 224 have 672 = 32 x 21 in common and normalisation cancels what is no power of two; `block` = a power of two chosen for
  each number (block floating).
- **LSB**: one raw unit in the spec's units.

| point | word | format | rounding | overflow | unit | LSB | what |
|---|---|---|---|---|---|---|---|
)";

void write_row(std::ostream& out, const NumberFormat& f) {
  out << "| `" << f.name << "` | " << f.word << " | " << (f.is_signed ? 's' : 'u') << f.word - f.fraction
      << '.' << f.fraction << " | " << f.rounding << " | " << f.overflow << " | " << f.unit_name << " | "
      << std::setprecision(3) << std::ldexp(f.unit, -f.fraction) << " | " << f.what << " |\n";
}

}  // namespace

std::string formats_document() {
  std::ostringstream out;
  out << introduction;
  for (const NumberFormat& format : number_formats()) write_row(out, format);
  return out.str();
}

}  // namespace sailmap::numbers
