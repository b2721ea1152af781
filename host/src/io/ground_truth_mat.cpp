#include <matio.h>

#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include "ground_truth_readers.hpp"
#include "mat_integrity.hpp"
#include "sailmap/error.hpp"
#include "sailmap/ground_truth.hpp"

namespace sailmap {

namespace {

using MatFile = std::unique_ptr<mat_t, decltype(&Mat_Close)>;
using Variable = std::unique_ptr<matvar_t, decltype(&Mat_VarFree)>;

MatFile open_mat(const std::filesystem::path& path) {
  io::check_mat_file(path);
  MatFile file(Mat_Open(path.c_str(), MAT_ACC_RDONLY), &Mat_Close);
  if (!file) throw Error(path.string() + ": not a MATLAB file");
  return file;
}

bool is_matrix(const matvar_t& variable) {
  const bool numeric = variable.class_type >= MAT_C_SPARSE && variable.class_type <= MAT_C_UINT64;
  return numeric && variable.rank == 2 && variable.isComplex == 0 && variable.name != nullptr;
}

// The one matrix of the file, without its data yet.
Variable find_matrix(const std::filesystem::path& path, mat_t* file) {
  Variable found(nullptr, &Mat_VarFree);
  for (;;) {
    Variable variable(Mat_VarReadNextInfo(file), &Mat_VarFree);
    if (!variable) break;
    if (!is_matrix(*variable)) continue;
    if (found) {
      throw Error(path.string() + ": several matrices (" + found->name + ", " + variable->name +
                  "); a ground truth is one");
    }
    found = std::move(variable);
  }
  if (!found) throw Error(path.string() + ": no real two-dimensional numeric or logical matrix in this file");
  return found;
}

io::Extent extent_of(const std::filesystem::path& path, const matvar_t& matrix) {
  constexpr std::size_t limit = std::numeric_limits<int>::max() / 2;
  if (matrix.dims[0] > limit || matrix.dims[1] > limit) throw Error(path.string() + ": matrix too large");
  return {static_cast<int>(matrix.dims[0]), static_cast<int>(matrix.dims[1])};
}

// Is element k of a typed array other than 0? Nothing for a NaN or an unknown type.
class NonZero {
 public:
  NonZero(const void* data, matio_types type) : data_(data), type_(type) {}

  [[nodiscard]] std::optional<bool> operator()(std::size_t k) const {
    switch (type_) {
      case MAT_T_INT8:
      case MAT_T_UINT8:
        return test<std::uint8_t>(k);
      case MAT_T_INT16:
      case MAT_T_UINT16:
        return test<std::uint16_t>(k);
      case MAT_T_INT32:
      case MAT_T_UINT32:
        return test<std::uint32_t>(k);
      case MAT_T_INT64:
      case MAT_T_UINT64:
        return test<std::uint64_t>(k);
      case MAT_T_SINGLE:
        return test_real<float>(k);
      case MAT_T_DOUBLE:
        return test_real<double>(k);
      default:
        return std::nullopt;
    }
  }

 private:
  template <class T>
  [[nodiscard]] bool test(std::size_t k) const {
    return static_cast<const T*>(data_)[k] != 0;
  }
  template <class T>
  [[nodiscard]] std::optional<bool> test_real(std::size_t k) const {
    const T value = static_cast<const T*>(data_)[k];
    if (std::isnan(value)) return std::nullopt;
    return value != 0;
  }

  const void* data_;
  matio_types type_;
};

// Adds the non-zero elements of a matrix, column by column as MATLAB stores them, so that matches come out
// rising.
class Collector {
 public:
  Collector(const std::filesystem::path& path, const io::Extent& extent) : path_(path), extent_(extent) {
    truth_.matches.resize(static_cast<std::size_t>(extent.queries));
  }

  GroundTruth dense(const matvar_t& matrix) {
    const auto rows = static_cast<std::size_t>(extent_.queries);
    const auto columns = static_cast<std::size_t>(extent_.candidates);
    const auto size = static_cast<std::size_t>(matrix.data_size);
    if (matrix.data == nullptr || matrix.nbytes != rows * columns * size) fail();
    const NonZero non_zero(matrix.data, matrix.data_type);
    for (std::size_t k = 0; k < rows * columns; ++k) add(k % rows, k / rows, non_zero(k));
    return std::move(truth_);
  }

  GroundTruth sparse(const matvar_t& matrix) {
    if (matrix.data == nullptr) fail();
    const auto& stored = *static_cast<const mat_sparse_t*>(matrix.data);
    if (stored.njc != matrix.dims[1] + 1 || stored.jc == nullptr) fail();
    const std::span<const mat_uint32_t> starts(stored.jc, stored.njc);
    const NonZero non_zero(stored.data, matrix.data_type);
    for (std::size_t column = 0; column < matrix.dims[1]; ++column) {
      if (starts[column] > starts[column + 1] || starts[column + 1] > std::min(stored.nir, stored.ndata))
        fail();
      for (std::size_t k = starts[column]; k < starts[column + 1]; ++k)
        add(stored.ir[k], column, non_zero(k));
    }
    return std::move(truth_);
  }

 private:
  [[noreturn]] void fail() const { throw Error(path_.string() + ": damaged matrix"); }

  void add(std::size_t row, std::size_t column, std::optional<bool> same_place) {
    if (!same_place) throw Error(path_.string() + ": the matrix holds what is not a number");
    if (row >= truth_.matches.size()) fail();
    if (*same_place) truth_.matches[row].push_back(static_cast<int>(column));
  }

  const std::filesystem::path& path_;
  io::Extent extent_;
  GroundTruth truth_;
};

}  // namespace

namespace io {

Extent mat_extent(const std::filesystem::path& path) {
  const MatFile file = open_mat(path);
  return extent_of(path, *find_matrix(path, file.get()));
}

}  // namespace io

GroundTruth read_mat_ground_truth(const std::filesystem::path& path, int queries, int candidates) {
  const MatFile file = open_mat(path);
  const Variable matrix = find_matrix(path, file.get());
  const io::Extent extent = extent_of(path, *matrix);
  if (extent.queries != queries || extent.candidates != candidates) {
    throw Error(path.string() + ": matrix of " + std::to_string(extent.queries) + " x " +
                std::to_string(extent.candidates) + ", but there are " + std::to_string(queries) +
                " queries and " + std::to_string(candidates) + " candidates");
  }
  if (Mat_VarReadDataAll(file.get(), matrix.get()) != 0) throw Error(path.string() + ": damaged matrix");
  Collector collector(path, extent);
  return matrix->class_type == MAT_C_SPARSE ? collector.sparse(*matrix) : collector.dense(*matrix);
}

}  // namespace sailmap
