// A region in ten bytes: enough to bound its distance to another from below and above within about 0.03.
#pragma once

#include <array>
#include <cstdint>

#include "sailmap/signature.hpp"

namespace sailmap::index {

// A descriptor's numbers sum to one within each kind, so that seven orthonormal directions hold all of a
// distance: rows of a Hadamard matrix within each kind.
inline constexpr std::size_t directions = 7;
using Projection = std::array<double, directions>;

// Distances between projections are at most those between the descriptors (each number cut to +-1000 before,
// which brings none further apart), but for rounding below 1e-9.
Projection project(const Descriptor& descriptor);

// Codes of directions are in steps of `step`; what lies beyond the first or the last counts as that, which
// brings none further apart either.
inline constexpr double step = 0.01123;  // 127 of them span the +-sqrt(1/2) of a kind with two numbers
inline constexpr int first_code = -64;
inline constexpr int last_code = 63;

// Columns and rows are counted in `step` pixels: 4 pixels, which is exact for regions on the base level,
// unless the image is too large for the kernel's 8 and 16 bits (most images up to 1000 pixels wide are not).
// What lies beyond the last column or row counts as that, which brings none further apart.
struct PositionGrid {
  PositionGrid(int width, int height);
  double step = 4;
  std::array<int, 2> last{};  // x, y
};
// Codes count positions from here, as far to the right and below as signed bytes allow: the products
// of positions that are near each other are then small enough for 16 bits.
inline constexpr int position_zero = 127;

// Seven directions, a byte that is nothing (bytes are taken in pairs), then column and row.
inline constexpr std::size_t column_byte = 8;
inline constexpr std::size_t row_byte = 9;
inline constexpr std::size_t code_bytes = 10;
using RegionCode = std::array<std::int8_t, code_bytes>;
RegionCode encode(const Region& region, const PositionGrid& grid);

// Whether the code stands for exactly the region's position.
bool is_exact(const Region& region, const PositionGrid& grid);

// How far, in descriptor distance, a descriptor is from what its code stands for: less than this, and
// exactly.
inline constexpr double largest_code_error = 0.01486;  // step / 2 in each of seven directions
double code_error(const Descriptor& descriptor, const RegionCode& code);

// The query's directions are in half steps from 0, and from what the code can hold no further than these.
using QueryCode = std::array<int, directions>;
inline constexpr int last_half_step = 127;
QueryCode encode_query(const Descriptor& descriptor);
double code_error(const Descriptor& descriptor, const QueryCode& code);

// Of a region of the query and its code, and any candidate and its code, with room for rounding.
double both_code_errors(const Region& query);

// Which kinds a signature's descriptors hold shares of, a bit for each kind: numbers that are not negative
// and sum to one, within `share_error`, in all regions; of the other kinds they hold nothing, within the
// same. Between two that hold the same kinds the seven directions are all of a distance, but for what the
// sums differ, and no code stands for anything beyond its end.
inline constexpr double share_error = 0.01;  // fixed-point front ends stay within 0.0066
inline constexpr double largest_squared_rest = 4 * share_error * share_error;  // of what the sums differ
inline constexpr std::uint8_t no_shares = 0xFF;                                // anything else
std::uint8_t kinds_shared(const Signature& signature);

// Not too many regions, all numbers finite and small enough that no arithmetic on them in single precision
// overflows. Other signatures are compared exactly.
bool can_be_bounded(const Signature& signature);

}  // namespace sailmap::index
