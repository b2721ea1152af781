// A region in four bytes: eight numbers of four bits, coarse but enough to bound a distance from below.
#pragma once

#include <array>
#include <cstdint>

#include "sailmap/signature.hpp"

namespace sailmap::index {

// A descriptor's numbers sum to one within each kind, so that seven orthonormal directions hold all of a
// distance: rows of a Hadamard matrix within each kind. The one that varies least on real images
// (ori_0 + ori_90 - ori_45 - ori_135, 1 % of the variance) is left out for the sake of four even bytes.
inline constexpr std::size_t directions = 6;
inline constexpr int levels = 16;   // per direction; the outer ones are open-ended
inline constexpr int cells = 15;    // columns, and rows, of the grid over the image
inline constexpr int no_cell = 15;  // where there is no region
inline constexpr std::size_t code_bytes = directions / 2 + 1;
inline constexpr std::size_t code_numbers = 2 * code_bytes;

using Projection = std::array<double, directions>;

// Distances between projections are at most those between the descriptors (each number cut to +-1000 before,
// which brings none further apart), but for rounding below `projection_error`.
Projection project(const Descriptor& descriptor);
inline constexpr double projection_error = 1e-9;

// Directions in bytes 0..2, two each, low bits first; column (low) and row (high) in the last.
using RegionCode = std::array<std::uint8_t, code_bytes>;
RegionCode encode(const Region& region, int width, int height);

// The column, or row, of the grid; positions outside the image count to the outermost.
int cell(int position, int side);

// At least how far a number is from any that has the code `level`; 0 when it may be equal.
double level_gap(double number, std::size_t direction, int level);
// At least how many pixels a position is from any in the cell.
int cell_gap(int position, int cell, int side);

// All numbers finite and small enough that no arithmetic on them in single precision overflows. Other
// signatures are compared exactly.
bool can_be_bounded(const Signature& signature);

}  // namespace sailmap::index
